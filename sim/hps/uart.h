// uart.h - HPS UART0 (Synopsys DW_apb_uart, a 16550) as a console: text out and in.
//
//   +0x00 THR/RBR/DLL   +0x04 IER/DLH   +0x08 FCR/IIR   +0x0C LCR   +0x10 MCR   +0x14 LSR
//   +0x18 MSR   +0x1C SCR   +0x7C USR   +0x80 TFL   +0x84 RFL   +0xF4 CPR   +0xF8 UCV   +0xFC CTR
//
// LCR bit 7 (DLAB) puts the divisor in the place of THR and IER.  Bytes are taken as well as words.
//
// A character takes the bits of its format, 16 divisors of 10 ns each.  Those that wait for it are
// in a FIFO of 128, or of 1 while FCR has it off; one that comes when it is full is lost.  Without
// a divisor nothing is sent.  The interrupt of an empty transmitter is there when the FIFO has
// become empty or IER has begun to ask for it, until IIR has been read or something is written.
// With IER bit 7 it is that of FCR's level, and LSR bit 5 says that the FIFO is full.
//
// A typed character takes 1 ms, as at the JTAG UARTs.  They wait in a FIFO of 128, or of 1 while
// FCR has it off; one that comes when it is full is lost, and LSR bit 1 says so once.  The
// interrupt is there while IER asks for it and a character waits.
//
// Not handled: the speed at which characters come, and the level from which on they interrupt (it
// is 1), parity, framing and breaks, loopback, modem signals (MSR reads 0).
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>

#include "sim/hps/registers.h"

namespace sim {

class Uart : public Registers {
public:
    struct Settings {
        std::uint32_t divisor = 0, lcr = 0, fcr = 0, mcr = 0;
    };
    // As U-Boot's preloader leaves UART0: 115,200 baud, 8N1, with FIFOs.
    static constexpr Settings CONSOLE{54, 3, 1, 3};

    // `sent` is called with each character, `line` with the interrupt's level, `lost` when one that
    // is written finds no room.
    Uart(
        const sc_core::sc_module_name& module_name, std::function<void(char)> sent,
        std::function<void(bool up)> line = [](bool) {}, std::function<void()> lost = [] {},
        const Settings& settings = CONSOLE)
        : Registers{module_name},
          sent_{std::move(sent)},
          line_{std::move(line)},
          overflow_{std::move(lost)},
          divisor_{settings.divisor},
          fcr_{settings.fcr},
          lcr_{settings.lcr},
          mcr_{settings.mcr} {
        SC_HAS_PROCESS(Uart);
        SC_METHOD(sent);
        sensitive << sent_one_;
        dont_initialize();
        SC_METHOD(arrive);
        sensitive << arrival_;
        dont_initialize();
    }

    // Typed at the other end of the line.
    void receive(const std::string& text);

    // Something that was written is still on its way.
    bool is_sending() const { return divisor_ != 0 && (shifts_ || !waiting_.empty()); }

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    bool allows_bytes() const override { return true; }
    std::uint32_t rest(std::uint32_t, const sc_core::sc_time&) override {
        return 0;
    }  // all are bytes
    bool fifos() const;
    bool transmitter_has_room() const;
    std::size_t level() const;
    sc_core::sc_time character_time() const;
    void send(char character, const sc_core::sc_time& now);
    void shift(const sc_core::sc_time& now);
    void sent();
    void arrive();
    void update_interrupt();

    std::function<void(char)> sent_;
    std::function<void(bool)> line_;
    std::function<void()> overflow_;
    std::uint32_t divisor_, ier_ = 0, fcr_, lcr_, mcr_, scr_ = 0;
    std::deque<char> waiting_;  // to be sent
    bool shifts_ = false;       // shifted_ is on its way
    char shifted_ = 0;
    sc_core::sc_event sent_one_;
    std::deque<char> typed_, received_;  // on their way, waiting
    bool overrun_ = false;
    sc_core::sc_event arrival_;
    bool thr_empty_ = true;  // an interrupt that IIR has not reported yet
};

}  // namespace sim
