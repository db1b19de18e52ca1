// part_report.h - what a run tells at its end of a part that a scenario has hung on the headers
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sim {

struct PartReport {
    std::string name;
    std::vector<std::string> rows = {};        // of LEDs, as they are seen; none: it has none
    std::optional<std::string> received = {};  // bytes from the FPGA; nothing: it is no terminal
    std::uint64_t lost = 0;                    // bytes of them
    std::vector<std::string> advice = {};      // what may be wrong, for the summary
};

}  // namespace sim
