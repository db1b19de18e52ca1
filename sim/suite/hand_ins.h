// hand_ins.h - what students have handed in: a folder for each, which the same scenarios judge
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "sim/process/confined.h"
#include "sim/process/run_command.h"
#include "sim/suite/cases.h"

namespace sim::suite {

struct HandInOptions {
    std::filesystem::path folder;  // with a folder for each hand-in; empty: there are none
    std::string build;             // command of a shell, run in each; or empty
    std::filesystem::path csv;     // or empty
    unsigned memory_mb = 3'000;    // of a run
    unsigned output_mb = 256;      // that it writes
    bool unconfined = false;
};

constexpr int WROTE_TOO_MUCH = -2;  // an Outcome's code, as TIMED_OUT

class HandIns {
public:
    // `paths` are those of the scenarios.  std::runtime_error: there is no hand-in, the folders lie
    // in each other, or hand-ins cannot be confined here.
    HandIns(const HandInOptions& options, const std::vector<std::filesystem::path>& paths,
            std::filesystem::path out);

    // Each scenario for each hand-in, with the hand-in's own `program:` or `project:`, as
    // HAND-IN/SCENARIO.  std::runtime_error: a scenario has neither.
    std::vector<Case> cases(const std::vector<Case>& scenarios) const;

    // Copies a hand-in to out/hand-ins/NAME, without what de1sim has left in it, and builds it.
    // Empty, or why it could not be built.  The first call does it; others wait for that.
    const std::string& prepare(const std::string& name, unsigned limit_s);

    // Runs a case's command in a copy of its hand-in that lies in `folder`, where alone they write.
    Outcome run(const Case& one, const std::vector<std::string>& command,
                const std::filesystem::path& folder, unsigned limit_s,
                const std::function<bool()>& given_up) const;

private:
    struct Prepared {
        std::once_flag once;
        std::string problem;
    };

    Outcome run_confined(const std::vector<std::string>& command,
                         const std::filesystem::path& writable, unsigned limit_s,
                         const std::function<bool()>& given_up) const;
    std::string build(const std::string& name, unsigned limit_s) const;

    const HandInOptions options_;
    const std::filesystem::path out_;
    std::vector<std::string> names_;  // of the folders, sorted
    std::map<std::string, Prepared> prepared_;
    Confinement confinement_;
};

}  // namespace sim::suite
