// i2c_speed.h - whether a chip on an I2C bus answers at the master's speed.
//
// A datasheet promises nothing above its greatest frequency of SCL.  Up to a quarter above it the
// chip answers here all the same, as most do on a board; beyond that it does not.  Either
// is reported once.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace sim {

class I2cSpeed {
public:
    I2cSpeed(std::string chip, unsigned most_hz, std::function<void(const std::string&)> report)
        : chip_{std::move(chip)}, most_hz_{most_hz}, report_{std::move(report)} {}

    // `period_ps`: the shortest of SCL since START.
    bool answers(std::uint64_t period_ps);

private:
    const std::string chip_;
    const unsigned most_hz_;
    const std::function<void(const std::string&)> report_;
    bool slow_reported_ = false, fast_reported_ = false;
};

}  // namespace sim
