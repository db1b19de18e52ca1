// ps2_keyboard.h - a PS/2 keyboard with scan code set 2, on two open-collector wires.
//
// 500 ms after power-on it has tested itself and says AA.  A key sends its make code when it goes
// down and F0 and the code when it comes up; a letter that needs it has the left shift (12) around
// it.  Bits are 80 us long.  While the host holds CLK low, bytes wait; one that this interrupts
// before its stop bit is sent again.
//
// Commands: FF reset (FA, after 500 ms AA), FE resend, F6 defaults, F5 off and F4 on again (keys
// send nothing in between), F3 rate and ED lamps with a byte more each, F2 identity (AB 83) and
// EE echo.  All but EE and FE are answered with FA; others and wrong parity with FE.
//
// Not handled: other scan code sets, keys that repeat while held, keys without a character.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include <systemc>

namespace sim {

class Ps2Keyboard : public sc_core::sc_module {
public:
    // `moved` is called after each change of clk_low() or dat_low().
    Ps2Keyboard(const sc_core::sc_module_name& name, std::function<void()> moved);

    // Presses the keys of characters that have a scan_code(), one after the other, each down for
    // 20 ms and up for 20 ms, from now on.
    void type(const std::string& text);

    // What the host pulls low.
    void host(bool clk_low, bool dat_low);
    // What the keyboard pulls low.
    bool clk_low() const { return clk_low_; }
    bool dat_low() const { return dat_low_; }

    bool enabled() const { return enabled_; }
    std::uint8_t lamps() const { return lamps_; }  // as of command ED

private:
    void serve();
    void press_keys();
    bool send(std::uint8_t byte);
    void receive();
    void command(std::uint8_t byte);
    void reset();
    void drive(bool clk_low, bool dat_low);

    std::function<void()> moved_;
    std::deque<std::uint8_t> to_send_;
    std::deque<char> keys_;
    sc_core::sc_event work_, key_;
    std::uint8_t last_ = 0, argument_of_ = 0, lamps_ = 0;
    bool clk_low_ = false, dat_low_ = false, host_clk_low_ = false, host_dat_low_ = false;
    bool enabled_ = false;
};

}  // namespace sim
