// header_part.h - a part on the headers' wires: what the board calls of it, and what it gets
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/board/display_picture.h"
#include "sim/board/header.h"
#include "sim/board/part.h"
#include "sim/pins/agenda.h"
#include "sim/pins/header_pin.h"
#include "sim/report/part_report.h"

namespace sim {

class HeaderPart : public Part {
public:
    // The wires of both headers have these levels from now on.  Called at each change of any wire.
    virtual void look(const HeaderMasks& levels, std::uint64_t time_ps) {
        (void)levels, (void)time_ps;
    }

    // ---- What a person sees of it, at this time: on the page of a live run, and in steps ----

    // Rows of LEDs: `#` is lit, `+` has less than a third of the brightest one's light, `.` is
    // dark.
    virtual std::vector<std::string> rows(std::uint64_t /*time_ps*/) { return {}; }
    virtual std::optional<DisplayPicture> picture() const { return {}; }

    // At the end of a run; nothing of a part that has nothing to tell.
    virtual std::optional<PartReport> report(const std::string& name, std::uint64_t time_ps) {
        std::vector<std::string> seen = rows(time_ps);
        if (seen.empty()) return {};
        return PartReport{name, std::move(seen)};
    }
};

// What the board gives to a part.
struct PartSocket {
    Agenda& agenda;
    // Puts a level on wires, until the next call.
    std::function<void(const HeaderMasks& pins, PinLevel level)> drive;
    // To be called after drive(), but not by constructors: all who look at the wires look again.
    std::function<void()> moved;
};

}  // namespace sim
