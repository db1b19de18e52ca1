// terminal.h - the terminal at which a program has its console, on Linux and by semihosting: lines
// that are typed, one after another.
//
// A character takes 1 ms, as at the JTAG UART.  Like a terminal, it delivers a line when it is
// complete, DEL or backspace deletes the character before, ^D ends the input, and it echoes.  With
// ICANON off a program gets each character as it comes, with VMIN = 0 possibly none; with ECHO off
// nothing is echoed (TCSETS).  A carriage return is a newline.
//
// Not handled: the echo comes when the line is read, not when it is typed; signals by ^C and ^Z;
// VTIME; settings of windows, modems and speeds are kept without effect.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include <systemc>

namespace sim {

class Terminal {
public:
    using Settings = std::array<std::uint8_t, 36>;  // the kernel's struct termios

    // `sleep` lets simulated time pass in the program; `sleep_until` waits for the event.
    struct Outside {
        std::function<sc_core::sc_time()> now;  // the program's
        std::function<void(const sc_core::sc_time&)> sleep;
        std::function<void(const sc_core::sc_event&, const sc_core::sc_time& at_most)> sleep_until;
        std::function<void(char)> echo;
    };
    explicit Terminal(Outside outside);

    void type(const std::string& text);
    void close() { closed_ = true; }  // no more input: at its end once all is read

    // As read(2): waits for a line, or with ICANON off for a character.
    std::int64_t read(char* to, std::size_t bytes);
    std::uint32_t ready() const;  // characters that could be read at once
    bool readable() const;        // read() would not block: there is input, or its end
    void wait(const sc_core::sc_time& at_most);  // until it is readable
    bool waits() const { return waits_; }

    Settings settings;

private:
    struct Key {
        char character;
        sc_core::sc_time at;
    };

    bool by_line() const;
    bool arrived(std::size_t count) const;
    std::size_t unit() const;
    void doze(const sc_core::sc_time& at_most);
    std::int64_t take(char* to, std::size_t bytes);

    Outside outside_;
    std::deque<Key> typed_;
    std::string line_;  // the rest of the one that is being read
    bool closed_ = false, waits_ = false;
    sc_core::sc_event more_;
};

}  // namespace sim
