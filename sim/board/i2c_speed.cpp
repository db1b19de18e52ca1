#include "sim/board/i2c_speed.h"

#include <utility>

#include <fmt/format.h>

namespace sim {

bool I2cSpeed::answers(std::uint64_t period_ps) {
    const std::uint64_t least_ps = 1'000'000'000'000 / most_hz_;
    if (period_ps >= least_ps) return true;
    const bool answers = period_ps >= least_ps * 4 / 5;
    if (!std::exchange(answers ? slow_reported_ : fast_reported_, true))
        report_(fmt::format(
            "I2C: SCL at {:.0f} kHz, faster than the {}'s {} kHz: {}",
            1e9 / static_cast<double>(period_ps), chip_, most_hz_ / 1000,
            answers ? "it answers here, and may not on a board" : "it does not answer"));
    return answers;
}

}  // namespace sim
