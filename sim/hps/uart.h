// uart.h - HPS UART0 (Synopsys DW_apb_uart, a 16550) as a console: text out and in.
//
//   +0x00 THR/RBR/DLL   +0x04 IER/DLH   +0x08 FCR/IIR   +0x0C LCR   +0x10 MCR   +0x14 LSR
//   +0x18 MSR   +0x1C SCR   +0x7C USR   +0xF4 CPR   +0xF8 UCV   +0xFC CTR
//
// LCR bit 7 (DLAB) puts the divisor in the place of THR and IER.  A character takes no time, so LSR
// always says that the transmitter is empty, and the interrupt of an empty THR is there as long as
// IER asks for it and IIR has not been read.  Bytes are taken as well as words.
//
// A typed character takes 1 ms, as at the JTAG UARTs.  They wait in a FIFO of 128, or of 1 while
// FCR has it off; one that comes when it is full is lost, and LSR bit 1 says so once.  The
// interrupt is there while IER asks for it and a character waits.
//
// Not handled: speeds and formats, the FIFO's trigger levels (it interrupts with the first
// character), parity, framing and breaks, loopback, modem signals (MSR reads 0).
#pragma once

#include <deque>
#include <functional>
#include <string>

#include "sim/hps/registers.h"

namespace sim {

class Uart : public Registers {
public:
    // `sent` is called with each character, `line` with the interrupt's level.
    Uart(
        const sc_core::sc_module_name& module_name, std::function<void(char)> sent,
        std::function<void(bool up)> line = [](bool) {})
        : Registers{module_name}, sent_{std::move(sent)}, line_{std::move(line)} {
        SC_HAS_PROCESS(Uart);
        SC_METHOD(arrive);
        sensitive << arrival_;
        dont_initialize();
    }

    // Typed at the other end of the line.
    void receive(const std::string& text);

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    bool takes_bytes() const override { return true; }
    std::uint32_t rest(std::uint32_t, const sc_core::sc_time&) override {
        return 0;
    }  // all are bytes
    void empty(bool is_new);
    void arrive();
    void tell();

    std::function<void(char)> sent_;
    std::function<void(bool)> line_;
    std::uint32_t divisor_ = 0, ier_ = 0, fcr_ = 0, lcr_ = 0, mcr_ = 0, scr_ = 0;
    std::deque<char> typed_, received_;  // on their way, waiting
    bool overrun_ = false;
    sc_core::sc_event arrival_;
    bool thr_empty_ = false;  // an interrupt that IIR has not reported yet
};

}  // namespace sim
