// ps2_mouse.h - a PS/2 mouse with three buttons and a wheel, as IBM's and Microsoft's answer.
//
// After its self-test it sends AA 00.  In stream mode, if enabled, it sends a packet after each
// change, at most as many per second as its rate says:
//
//   bit   7           6           5       4       3  2       1      0
//   1     Y overflow  X overflow  Y sign  X sign  1  middle  right  left
//   2, 3  X to the right, Y up: the lower 8 bits of 9
//   4     the wheel, -8 to 7, where it has been asked for: towards the hand is positive
//
// A counter saturates at -255 and 255, and sets its overflow bit.  It is set to 0 when a packet is
// sent, and by any command except FE.
//
//   FF reset (FA; after the test AA 00)   F6 defaults (FA): 100 per s, 4 per mm, 1:1, stream, off
//   F4 on, F5 off (FA)                    EA stream, F0 remote: speaks when asked (FA)
//   F3 rate, E8 resolution (FA, and FA for the byte more: 10 20 40 60 80 100 200; 0 to 3)
//   E6 scale 1:1, E7 2:1 (FA), the latter in stream mode only
//   E9 status (FA, three bytes)           EB a packet now (FA, packet)
//   F2 identity (FA 00)                   FE the last answer or packet again
//   EE wrap: every byte comes back (FA) until EC (FA) or FF
//
// The rates 200, 100, 80 in a row ask for the wheel: the identity is then 03, until a reset.
// Any other byte is answered with FE, and with FC if it is the second in a row.
//
// Source: IBM Personal System/2 Hardware Interface Technical Reference, auxiliary device; the
// packet with a wheel as Microsoft's IntelliMouse sends it.
//
// Not handled: buttons four and five.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>

#include "sim/board/ps2_device.h"
#include "sim/board/ps2_ports.h"

namespace sim {

class Ps2Mouse : public Ps2Device {
public:
    Ps2Mouse(Agenda& agenda, std::function<void()> moved);

    // In quarters of a millimetre; each is one count at 4 counts per mm.
    void move(int right, int up);
    void turn(int notches);  // of the wheel, towards the hand
    void button(MouseButton which, bool down);

    // Also hears of these, when the hand does them: the same mouse on USB.
    struct Listener {
        std::function<void(int right, int up)> move = [](int, int) {};
        std::function<void(int notches)> turn = [](int) {};
        std::function<void(MouseButton, bool down)> button = [](MouseButton, bool) {};
    };
    void set_listener(Listener listener) { listener_ = std::move(listener); }

private:
    enum Command : std::uint8_t;  // beside those of every device

    static constexpr int MOST = 255;  // counts in a packet

    // What one axis has moved since the last packet.
    struct Counter {
        int counts = 0;
        int rest = 0;  // fraction of a count, in quarters
        bool overflow = false;

        void add(int quarters);
    };

    void start() override;
    void command(std::uint8_t byte) override;
    bool may_report() const override { return argument_of_ == 0; }
    void defaults();
    void execute(std::uint8_t command);
    void argument(std::uint8_t of, std::uint8_t byte);
    void reply(const Bytes& bytes);
    void refuse();
    void stir();
    void look_at_stream();
    void stream();
    bool streams() const { return on_ && !remote_ && !wraps_; }
    Bytes packet(bool scaled);
    void forget();

    Listener listener_;
    Counter x_, y_;
    int wheel_ = 0;
    unsigned buttons_ = 0;
    bool stirred_ = false;  // since the last packet
    PartTimer stream_{agenda_, [this] { stream(); }};

    std::array<std::uint8_t, 3> rates_{};  // the last that were set, the newest last
    std::uint8_t resolution_ = 0;          // 2^n counts per mm
    bool on_ = false, remote_ = false, twice_ = false, wraps_ = false, has_wheel_ = false;
    std::uint8_t argument_of_ = 0;
    bool refused_ = false;  // the last byte
    Bytes last_;
};

}  // namespace sim
