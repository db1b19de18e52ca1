#include "sim/live/waves.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/run/run_again.h"

namespace sim::live {

Waves::Waves(const RunDescription& run) : run_{run} {}

Waves::~Waves() {
    given_up_ = true;
    if (running_.valid()) running_.wait();
}

void Waves::begin(const std::string& scenario, SimTime from, SimTime to) {
    if (running_.valid())
        throw std::runtime_error{"waveforms are being written; wait for their end"};
    const std::filesystem::path folder = run_.outputs.out / fmt::format("waves-{}", ++number_);
    const RunPart part{folder, std::max(from, SimTime{1}), to, folder.string() + ".yaml"};
    write_whole_file(part.scenario, scenario);
    running_ = std::async(std::launch::async, [this, part]() -> Done {
        const std::string problem = run_part_again(run_, part, [this] { return given_up_.load(); });
        return {problem.empty() ? (part.folder / "waves.fst").string() : "", problem};
    });
}

std::optional<Waves::Done> Waves::done() {
    if (!running_.valid() ||
        running_.wait_for(std::chrono::seconds{0}) != std::future_status::ready)
        return {};
    return running_.get();
}

}  // namespace sim::live
