// lamp_log.h - what is seen without a monitor, in the course of time: LEDR, HEX, HPS_LED, JP1, JP2.
#pragma once

#include <string>
#include <vector>

#include "sim/board/board.h"
#include "sim/report/changes.h"
#include "sim/report/report.h"

namespace sim {

class LampLog {
public:
    void show(const Lamps& lamps, double time_s);
    // As the report has it.
    std::vector<RunReport::Shown> shown() const;
    // What is not dark or at rest, as a person says it: "LEDR 1000000001, HEX \"    12\""; or "".
    std::string say() const;

private:
    Changes<std::uint16_t> ledr_{0};
    Changes<std::uint64_t> hex_{0};
    Changes<bool> hps_led_{false};
    Changes<Lamps::Header> jp1_{{0xFFFFFFFF, 0}}, jp2_{{0xFFFFFFFF, 0}};
};

}  // namespace sim
