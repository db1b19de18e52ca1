// waves.h - waveforms of a time that has been played: by running to it again, with tracing
//
// That run is a process of its own; the play goes on meanwhile.
#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/description.h"

namespace sim::live {

class Waves {
public:
    // `run`: that is played.
    explicit Waves(const RunDescription& run);
    // Ends the other run.
    ~Waves();
    Waves(const Waves&) = delete;
    Waves& operator=(const Waves&) = delete;

    // Plays this scenario again, as OUT/waves-N.yaml, and writes OUT/waves-N/waves.fst with its
    // waves.bus.txt and waves.calls.txt.  std::runtime_error: one is being written; IoError.
    void begin(const std::string& scenario, SimTime from, SimTime to);

    // Once, when one has ended: the file, or why there is none.
    struct Done {
        std::string file, problem;
    };
    std::optional<Done> done();

private:
    const RunDescription& run_;
    std::atomic<bool> given_up_{false};
    unsigned number_ = 0;
    std::future<Done> running_;
};

}  // namespace sim::live
