// terminal.h - the terminal at which a program has its console, on Linux and by semihosting: lines
// that are typed, one after another.
//
// A character takes 1 ms, as at the JTAG UART.  Like a terminal, it delivers a line when it is
// complete, DEL or backspace deletes the character before, ^D ends the input, and it echoes.  With
// ICANON off a program gets each character as it comes, with VMIN = 0 possibly none; with ECHO off
// nothing is echoed (TCSETS).  A carriage return is a newline.
//
// With ISIG, and a listener for signals, ^C, ^\ and ^Z send theirs when they come; what was typed
// before and is not read yet is dropped, unless NOFLSH says otherwise.
//
// Not handled: the echo comes when the line is read, not when it is typed, but for that of ^C and
// its kind; VTIME; settings of windows, modems and speeds are kept without effect.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
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
        std::function<void(unsigned)> signal{};  // by its number
        std::function<void()> typed{};           // there is something new
    };
    explicit Terminal(Outside outside);

    void type(const std::string& text);
    void close() { closed_ = true; }  // no more input: at its end once all is read

    // As read(2): waits for a line, or with ICANON off for a character.
    std::int64_t read(char* to, std::size_t bytes);
    // The same without waiting: EAGAIN.
    std::int64_t read_now(char* to, std::size_t bytes);
    void flush();  // what has come and is not read yet
    // Sends the signals that were typed until now.  True if anything has come since the last call.
    bool arrive();
    std::optional<sc_core::sc_time> next_arrival() const;  // of what arrive() has not seen
    std::uint32_t ready() const;                           // characters that could be read at once
    bool readable() const;  // read() would not block: there is input, or its end
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
    std::int64_t give(char* to, std::size_t bytes);
    unsigned signal_of(char c) const;

    Outside outside_;
    std::deque<Key> typed_;
    std::size_t seen_ = 0;  // of these, by arrive()
    std::string line_;      // the rest of the one that is being read
    bool closed_ = false, waits_ = false;
    sc_core::sc_event more_;
};

}  // namespace sim
