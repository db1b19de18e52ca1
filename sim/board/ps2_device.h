// ps2_device.h - a device's end of PS/2: bytes to the host and from it on two open-collector wires.
//
//   device to host   start 0, 8 bits from bit 0, odd parity, stop 1; the device makes CLK, and DAT
//                    moves while it is high
//   host to device   the host holds CLK low for 60 us or longer, pulls DAT low, and lets go of CLK;
//                    the device clocks in 8 bits, parity and stop, and pulls DAT low for the
//                    acknowledge
//
// Bits are 80 us long.  While the host holds CLK low, bytes wait.  A byte that is interrupted so
// before its stop bit is sent again.  A byte with wrong parity is answered with FE.
//
// DAT low alone requests nothing, and after CLK was low for less than 60 us neither.
//
// For 500 ms after power-on and after a reset the device tests itself and neither sends nor
// receives.
//
// Source: IBM Personal System/2 Hardware Interface Technical Reference, keyboard and auxiliary
// device controller.
//
// Not handled: a host that aborts a byte while sending it.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "sim/board/part.h"
#include "sim/pins/agenda.h"

namespace sim {

class Ps2Device : public Part {
public:
    // Powers on at agenda.now_ps().  `moved` is called after each change of clk_low() or dat_low().
    Ps2Device(Agenda& agenda, std::function<void()> moved);

    // What the host pulls low from agenda.now_ps() on.
    void host(bool clk_low, bool dat_low);
    // What the device pulls low.
    bool clk_low() const { return clk_low_; }
    bool dat_low() const { return dat_low_; }

protected:
    using Bytes = std::vector<std::uint8_t>;
    static constexpr std::uint8_t PASSED = 0xAA, ACKNOWLEDGE = 0xFA, RESEND = 0xFE;
    // Commands of both kinds of device; RATE has an argument.
    static constexpr std::uint8_t IDENTITY = 0xF2, RATE = 0xF3, ON = 0xF4, OFF = 0xF5,
                                  DEFAULTS = 0xF6, AGAIN = 0xFE, RESET = 0xFF;

    // The self-test has passed: the device sets its defaults and sends its answer.
    virtual void start() = 0;
    // A byte from the host.
    virtual void command(std::uint8_t byte) = 0;
    // False: reports have to wait.
    virtual bool may_report() const = 0;

    void answer(const Bytes& bytes);  // before all reports
    void report(const Bytes& bytes);  // after earlier reports
    void drop_reports() { reports_.clear(); }
    void reset();  // acknowledges, then tests itself

    bool ready() const { return ready_; }  // not in its test
    bool idle() const { return answers_.empty() && reports_.empty(); }
    std::uint8_t last_sent() const { return last_sent_; }

    Agenda& agenda_;

private:
    enum class Doing { NOTHING, TEST, SEND, RECEIVE, REST };

    void work();
    void look_for_work();
    void test();
    void begin(Doing doing, std::uint64_t first_ps);
    void send();
    void sent();
    void receive();
    void received();
    void drive(bool clk_low, bool dat_low, std::uint64_t for_ps);

    std::function<void()> moved_;
    PartTimer next_{agenda_, [this] { work(); }};
    Doing doing_ = Doing::TEST;
    unsigned part_ = 0;   // of what it does
    unsigned frame_ = 0;  // its bits: to be sent, or received so far
    std::deque<std::uint8_t> answers_, reports_;
    std::deque<std::uint8_t>* sending_ = nullptr;  // whose first byte
    std::uint8_t last_sent_ = 0;
    bool clk_low_ = false, dat_low_ = false, host_clk_low_ = false, host_dat_low_ = false;
    bool ready_ = false, to_reset_ = false;
    bool held_ = false;  // CLK, long enough for a request, since the last byte from the host
    std::uint64_t held_since_ps_ = 0;
};

}  // namespace sim
