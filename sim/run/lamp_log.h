// lamp_log.h - what is seen without a monitor, in the course of time: LEDR, HEX, HPS_LED, and
// the headers' pins.
#pragma once

#include <string>
#include <vector>

#include "sim/board/board.h"
#include "sim/report/changes.h"
#include "sim/report/report.h"

namespace sim {

class LampLog {
public:
    // How the headers' pins are named: JP1 and JP2 with D31-D0, as the DE1-SoC Computer has them,
    // or GPIO_0 and GPIO_1 with all 36.
    enum class Headers { JP, GPIO };

    void show(const Lamps& lamps, double time_s);
    // As the report has it.
    std::vector<RunReport::Shown> shown(Headers headers) const;
    // What is not dark or at rest, as a person says it: "LEDR 1000000001, HEX \"    12\""; or "".
    std::string text(Headers headers) const;

private:
    Changes<std::uint16_t> ledr_{0};
    Changes<std::uint64_t> hex_{0};
    Changes<bool> hps_led_{false};
    Changes<Lamps::Header> gpio_0_{{ALL_HEADER_PINS, 0}}, gpio_1_{{ALL_HEADER_PINS, 0}};
};

}  // namespace sim
