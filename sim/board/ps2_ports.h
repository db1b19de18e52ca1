// ps2_ports.h - what is plugged into the board's two PS/2 ports
#pragma once

namespace sim {

enum class Ps2Plug { KEYBOARD, MOUSE, NOTHING };

enum class MouseButton { LEFT, RIGHT, MIDDLE };  // in the order of their bits in a packet

// Each device is in one port at most.
struct Ps2Ports {
    Ps2Plug first = Ps2Plug::KEYBOARD;
    Ps2Plug second = Ps2Plug::MOUSE;

    bool has(Ps2Plug plug) const { return first == plug || second == plug; }
};

}  // namespace sim
