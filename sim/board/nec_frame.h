// nec_frame.h - what a button of the board's remote control sends: a frame of the NEC protocol.
//
//   ~~~~~|__|~|_|~|___|~| ... |~|____   high: light
//   9 ms  4.5   0    1         end      bits: 562.5 us of light, then 562.5 of dark are a 0,
//                                       1,687.5 a 1; the lowest first
//
// The 32 bits are the remote's custom code, the button's code and that code inverted.
//
// Source: DE1-SoC User Manual, IR receiver; its remote control has the custom code 6B86.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sim {

// The code of a button: "power", "channel-up", "5", "a" and so on.
std::optional<std::uint8_t> remote_button(const std::string& name);
std::vector<std::string> remote_buttons();

// Nanoseconds of light, dark, light ... light.
std::vector<std::uint32_t> nec_frame(std::uint8_t button);

}  // namespace sim
