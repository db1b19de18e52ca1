// abort_log.h - the log of the aborts that a program takes: each place once.
//
// The first abort of an instruction is a line, when the program has left its handler; one that ends
// the program stands in its fault and is no line.  Those that follow are only counted, and at the
// run's end there is a line for each place with how many they were.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sim {

class AbortLog {
public:
    explicit AbortLog(std::function<void(const std::string&)> log) : log_{std::move(log)} {}

    // An abort, or an undefined instruction, of the instruction at `pc`, whose handler is entered.
    void happened(unsigned exception, std::uint32_t pc, const std::string& text);
    // The program has left its handlers.
    void handled() { failed(""); }
    // The program has failed by the one with this text, which is not reported again.
    void failed(const std::string& text);
    // At the run's end.
    void end();

private:
    static constexpr std::size_t MOST = 1000;  // places

    struct Place {
        std::string text;
        std::uint64_t times = 0;
    };

    std::function<void(const std::string&)> log_;
    std::map<std::pair<unsigned, std::uint32_t>, Place> places_;
    std::vector<std::string> pending_lines_;
};

}  // namespace sim
