// uart.h - HPS UART0 (Synopsys DW_apb_uart, a 16550) as a console: what is sent becomes text.
//
//   +0x00 THR (write)   +0x14 LSR (read): bit 5 THR empty, bit 6 transmitter empty, both always 1
//
// Not handled: baud rate (a character takes no time), FIFOs, receiving, interrupts: the other
// registers read 0 and ignore writes.
#pragma once

#include <functional>
#include <string>

#include "sim/hps/registers.h"

namespace sim {

class Uart : public Registers {
public:
    // `sent` is called with each character.
    Uart(const sc_core::sc_module_name& module_name, std::function<void(char)> sent)
        : Registers{module_name}, sent_{std::move(sent)} {}

private:
    static constexpr std::uint32_t THR = 0x00, LSR = 0x14;

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time&) override {
        return offset == LSR ? 0x60 : 0;
    }
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) override {
        if (offset == THR) sent_(static_cast<char>(value));
    }

    std::function<void(char)> sent_;
};

}  // namespace sim
