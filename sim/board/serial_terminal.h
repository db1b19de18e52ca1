// serial_terminal.h - a serial terminal on two pins of a header: 8 data bits, no parity, 1 stop bit
//
//   ------\  0 /  bits 0 to 7  /  1    A byte begins where the wire falls; each bit is taken in its
//          ----                        middle.  A byte whose stop bit is low is lost and counted.
//
// What is typed goes out at once, byte after byte without a pause.  Nothing is echoed.
//
// Not handled: flow control, a break.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include "sim/board/header_part.h"

namespace sim {

class SerialTerminal : public HeaderPart {
public:
    static constexpr std::size_t MOST = 1 << 16;  // bytes that are kept of what it received

    // `rx` is the wire from the FPGA; `tx` that to the FPGA, which begins high.
    SerialTerminal(HeaderPin rx, HeaderPin tx, unsigned baud, const PartSocket& socket);

    void look(const HeaderMasks& levels, std::uint64_t time_ps) override;
    void type(const std::string& text);

    // Called with each byte received.
    std::function<void(char)> heard = [](char) {};
    // The last of them, and bytes that were lost.
    const std::string& received() const { return received_; }
    std::uint64_t lost() const { return lost_; }
    std::optional<PartReport> final_report(const std::string& name, std::uint64_t) override;

private:
    // So many halves of a bit after `begin_ps`.
    std::uint64_t after(std::uint64_t begin_ps, unsigned halves) const {
        return begin_ps + (halves * 500'000'000'000 + baud_ / 2) / baud_;
    }
    void sample();
    void send();

    const HeaderPin rx_;
    const HeaderMasks tx_;
    const std::uint64_t baud_;
    const PartSocket& socket_;

    bool level_ = true;
    unsigned taken_ = 0;  // bits, the start bit included
    std::uint64_t begin_ps_ = 0;
    std::uint8_t byte_ = 0;
    std::string received_;
    std::uint64_t lost_ = 0;
    PartTimer sampling_{socket_.agenda, [this] { sample(); }};

    std::deque<char> typed_;
    unsigned sent_ = 0;  // bits of the first of them
    std::uint64_t sending_since_ps_ = 0;
    PartTimer sending_{socket_.agenda, [this] { send(); }};
};

}  // namespace sim
