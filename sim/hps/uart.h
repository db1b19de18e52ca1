// uart.h - HPS UART0 (Synopsys DW_apb_uart, a 16550): a console, or wires to the FPGA.
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
// Where the UART is routed to the FPGA, see connect(), its signals are those of the design, bit by
// bit: txd with a break and the modem's outputs, rxd with what is wrong with a frame (LSR bits 2 to
// 4), and the modem's inputs with their interrupt (MSR).  The modem's signals are low at the wires
// where they are active.  A frame begins when it can, at no edge of the baud rate's own clock.
//
// Not handled: the speed at which typed characters come, and the level from which on they interrupt
// (it is 1); loopback; automatic flow control (MCR bit 5); at pins, modem signals (MSR reads 0),
// parity, framing and breaks.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "sim/hps/fabric_wires.h"
#include "sim/hps/registers.h"
#include "sim/hps/uart_frame.h"

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
        SC_METHOD(next_bit);
        sensitive << bit_due_;
        dont_initialize();
        SC_METHOD(look);
        sensitive << look_;
        dont_initialize();
    }

    // It is routed to the FPGA; before the program begins.  `moved` is to be called with what the
    // design does.
    void connect(FabricWires wires);
    bool is_connected() const { return wires_.has_value(); }
    void moved(std::uint64_t levels, std::uint64_t time_ps);

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
    void send(char character, const sc_core::sc_time& now);
    void shift(const sc_core::sc_time& now);
    void sent();
    void arrive();
    void update_interrupt();
    UartFormat format() const;
    void next_bit();
    void put(const sc_core::sc_time& now);
    void look();
    void receive_until(std::uint64_t time_ps);
    void keep(std::uint8_t character, std::uint32_t errors);
    std::uint32_t modem_status();
    std::uint32_t identify_interrupt();
    std::uint32_t line_status();

    struct Received {
        std::uint8_t character;
        std::uint32_t errors;  // bits of LSR
    };

    std::function<void(char)> sent_;
    std::function<void(bool)> line_;
    std::function<void()> overflow_;
    std::uint32_t divisor_, ier_ = 0, fcr_, lcr_, mcr_, scr_ = 0;
    std::deque<char> waiting_;  // to be sent
    bool shifts_ = false;       // shifted_ is on its way
    char shifted_ = 0;
    sc_core::sc_event sent_one_;
    std::deque<char> typed_;         // on their way
    std::deque<Received> received_;  // waiting
    bool overrun_ = false;
    sc_core::sc_event arrival_;
    std::optional<FabricWires> wires_;
    UartReceiver receiver_;
    UartFormat sends_{};              // the frame that is on its way
    std::uint32_t frame_ = 0;         // its bits
    unsigned bit_ = 0;                // the next of them
    bool txd_ = true;                 // without a break
    std::uint64_t modem_ = 0xF;       // cts, dsr, dcd, ri, as they are at the wires
    std::uint32_t modem_deltas_ = 0;  // MSR bits 3:0
    sc_core::sc_event bit_due_, look_;
    bool thr_empty_ = true;  // an interrupt that IIR has not reported yet
};

}  // namespace sim
