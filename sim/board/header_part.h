// header_part.h - a part on the headers' wires: what the board calls of it, and what it gets
#pragma once

#include <cstdint>
#include <functional>

#include "sim/board/header.h"
#include "sim/board/part.h"
#include "sim/pins/agenda.h"
#include "sim/pins/header_pin.h"

namespace sim {

class HeaderPart : public Part {
public:
    // The wires of the headers have these levels from now on.  Called at each change of any wire.
    virtual void look(const HeaderMasks& levels, std::uint64_t time_ps) {
        (void)levels, (void)time_ps;
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
