// serial.cpp - type-serial, wait-serial: the terminals at the board's serial line, at the JTAG
// UARTs and among the parts
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "sim/board/serial_terminal.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

std::optional<SerialLine> line_of(const std::string& name) {
    const auto found = std::find(SERIAL_LINES.begin(), SERIAL_LINES.end(), name);
    if (found == SERIAL_LINES.end()) return {};
    return static_cast<SerialLine>(found - SERIAL_LINES.begin());
}

class TypeSerial : public Action {
public:
    explicit TypeSerial(const Values& v)
        : text_{v.get<std::string>("text")}, to_{v.get<std::string>("to")} {}

    std::string describe() const override {
        return "type " + in_quotes(text_) + (to_.empty() ? "" : " at " + to_);
    }
    void check(StaticChecks& checks) const override {
        if (!to_.empty() && !line_of(to_)) checks.need_part("terminal", to_);
    }
    void act(BoardControl& board) const override {
        if (to_.empty() || line_of(to_))
            board.type_serial(text_, line_of(to_));
        else
            board.act([text = text_, &terminal = board.part<SerialTerminal>(to_)] {
                terminal.type(text);
            });
    }

private:
    std::string text_, to_;
};

class WaitSerial : public Claim {
public:
    explicit WaitSerial(const Values& v)
        : text_{v.get<std::string>("text")},
          on_{v.get<std::string>("on")},
          timeout_{v.get<SimTime>("timeout")} {}

    std::string describe() const override {
        return fmt::format("wait for {} on {}{}", in_quotes(text_),
                           on_.empty() ? "the serial line" : on_, within(timeout_));
    }
    void check(StaticChecks& checks) const override {
        if (!on_.empty()) checks.need_part("terminal", on_);
    }
    Verdict decide(BoardControl& board) const override {
        ConsoleText& text = on_.empty() ? board.observations().text : board.terminal(on_);
        if (board.wait_until(BoardControl::Each::CHARACTER, timeout_,
                             [&] { return text.consume(text_); }))
            return {true, ""};
        std::string detail = printed(text);
        if (text.forgotten())
            detail += fmt::format("; the first {} were too old to be looked at", text.forgotten());
        return {false, detail};
    }

private:
    // What there was instead, or its end.
    std::string printed(const ConsoleText& text) const {
        constexpr std::size_t MOST = 60;
        const std::uint64_t count = text.unread();
        const std::string who = on_.empty() ? "the console printed" : on_ + " received";
        if (count == 0) return who + " nothing after the last match";
        const char* before = count > MOST ? "..." : "";
        return fmt::format("{} {} character{} after the last match, but not that: {}{}", who, count,
                           count == 1 ? "" : "s", before, in_quotes(text.end(MOST)));
    }

    std::string text_, on_;
    SimTime timeout_;
};

}  // namespace

namespace steps {

std::vector<StepForm> serial() {
    return {
        {"type-serial",
         "Type a text at a terminal and go on; a character takes 1 ms, or ten bits at one of the "
         "parts.",
         Notation::BOTH,
         {},
         {{"text", TEXT, Need::REQUIRED, "", "The text."},
          {"to", LINE, Need::OPTIONAL, "",
           "At which terminal: serial, jtag-0, jtag-1, or the name of one among the parts. Without "
           "it where programs listen: at the first JTAG UART's and a Linux program's."}},
         make<TypeSerial>},
        {"wait-serial",
         "Wait until the firmware has printed a text; the next wait-serial searches after it.",
         Notation::BOTH,
         {},
         {{"text", TEXT, Need::REQUIRED, "", "The text."},
          {"on", LINE, Need::OPTIONAL, "",
           "The terminal among the parts that receives it. Without it what programs print."},
          {"timeout", SOME_TIME, Need::OPTIONAL, "10s",
           "Longest wait in simulated time; then the run fails."}},
         make<WaitSerial>},
    };
}

}  // namespace steps

}  // namespace sim
