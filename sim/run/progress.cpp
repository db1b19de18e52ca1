#include "sim/run/progress.h"

#include <unistd.h>

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "sim/text/messages.h"

namespace sim {

Progress::Progress(bool quiet, std::optional<double> total_s)
    : quiet_{quiet},
      terminal_{isatty(STDERR_FILENO) == 1},
      total_s_{total_s},
      begin_{std::chrono::steady_clock::now()} {}

double Progress::wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Progress::show(double simulated_s, std::uint64_t frames) {
    if (quiet_) return;
    const double wall = wall_s();
    if (terminal_ ? wall < next_wall_s_ : simulated_s < next_simulated_s_) return;
    next_wall_s_ = wall + 0.1;
    next_simulated_s_ = simulated_s + 1 - 1e-6;
    std::string line = fmt::format("{:6.2f} s", simulated_s);
    if (total_s_) line += fmt::format(" of {:.2f} s", *total_s_);
    line +=
        fmt::format(", {} frames, {:.2f} x real time", frames, wall > 0 ? simulated_s / wall : 0);
    if (!terminal_) {
        message(line);
        return;
    }
    std::string bar;
    if (total_s_ && *total_s_ > 0) {
        constexpr std::size_t WIDTH = 24;
        const auto full = static_cast<std::size_t>(std::min(1.0, simulated_s / *total_s_) * WIDTH);
        bar = "[" + std::string(full, '#') + std::string(WIDTH - full, '.') + "] ";
    }
    show_status(bar + line);
}

void Progress::done() { clear_status(); }

}  // namespace sim
