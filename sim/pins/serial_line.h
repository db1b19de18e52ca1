// serial_line.h - the lines on which a program prints and is typed to, each with a terminal.
#pragma once

#include <array>

namespace sim {

// UART: the HPS's UART0, and the console of a Linux program.
enum class SerialLine { UART, JTAG_0, JTAG_1 };

constexpr std::array<const char*, 3> SERIAL_LINES{"serial", "jtag-0", "jtag-1"};

}  // namespace sim
