// part.h - a component on the board's pins that people act on or observe
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/board/display_picture.h"
#include "sim/report/part_report.h"

namespace sim {

class Part {
public:
    virtual ~Part() = default;

    // ---- What a person sees of it, at this time: on the page of a live run, and in steps ----

    // Rows of LEDs: `#` is lit, `+` has less than a third of the brightest one's light, `.` is
    // dark.
    virtual std::vector<std::string> rows(std::uint64_t /*time_ps*/) { return {}; }
    virtual std::optional<DisplayPicture> picture() const { return {}; }

    // At the end of a run; nothing of a part that has nothing to tell.
    virtual std::optional<PartReport> final_report(const std::string& name, std::uint64_t time_ps) {
        std::vector<std::string> seen = rows(time_ps);
        if (seen.empty()) return {};
        return PartReport{name, std::move(seen)};
    }

protected:
    Part() = default;
    Part(const Part&) = default;
    Part& operator=(const Part&) = default;
};

}  // namespace sim
