// serial.cpp - type-serial, wait-serial: the terminal at the board's serial line and JTAG UART
#include <fmt/format.h>

#include <optional>

#include "sim/scenario/stage.h"
#include "sim/scenario/step_form.h"
#include "sim/scenario/words.h"

namespace sim {

namespace {

using namespace value_types;

const ValueType LINES =
    word("serial, jtag-0 or jtag-1", {SERIAL_LINES.begin(), SERIAL_LINES.end()});

class TypeSerial : public Action {
public:
    explicit TypeSerial(const Values& v) : text_{v.get<std::string>("text")} {
        if (v.find("to")) to_ = v.number<SerialLine>("to");
    }

    std::string say() const override {
        const std::string where =
            to_ ? fmt::format(" at {}", SERIAL_LINES[static_cast<std::size_t>(*to_)]) : "";
        return "type " + in_quotes(text_) + where;
    }
    void act(Stage& stage) const override { stage.type_serial(text_, to_); }

private:
    std::string text_;
    std::optional<SerialLine> to_;
};

class WaitSerial : public Claim {
public:
    explicit WaitSerial(const Values& v)
        : text_{v.get<std::string>("text")}, timeout_{v.get<SimTime>("timeout")} {}

    std::string say() const override {
        return "wait for " + in_quotes(text_) + " on the serial line" + within(timeout_);
    }
    Verdict decide(Stage& stage) const override {
        ConsoleText& text = stage.senses().text;
        if (stage.wait_until(Stage::Each::CHARACTER, timeout_, [&] { return text.take(text_); }))
            return {true, ""};
        std::string detail = printed(text);
        if (text.forgotten())
            detail += fmt::format("; the first {} were too old to be looked at", text.forgotten());
        return {false, detail};
    }

private:
    // What there was instead, or its end.
    static std::string printed(const ConsoleText& text) {
        constexpr std::size_t MOST = 60;
        const std::uint64_t count = text.unread();
        if (count == 0) return "the console printed nothing behind the last match";
        const char* before = count > MOST ? "..." : "";
        return fmt::format(
            "the console printed {} character{} behind the last match, but not "
            "that: {}{}",
            count, count == 1 ? "" : "s", before, in_quotes(text.end(MOST)));
    }

    std::string text_;
    SimTime timeout_;
};

}  // namespace

namespace steps {

std::vector<StepForm> serial() {
    return {
        {"type-serial",
         "Type a text at a terminal and go on; a character takes 1 ms.",
         Notation::BOTH,
         {},
         {{"text", TEXT, Need::REQUIRED, "", "The text."},
          {"to", LINES, Need::OPTIONAL, "",
           "At which terminal. Without it where programs listen: at the first JTAG UART's and a "
           "Linux program's."}},
         make<TypeSerial>},
        {"wait-serial",
         "Wait until the firmware has printed a text; the next wait-serial searches after it.",
         Notation::BOTH,
         {},
         {{"text", TEXT, Need::REQUIRED, "", "The text."},
          {"timeout", SOME_TIME, Need::OPTIONAL, "10s",
           "Longest wait in simulated time; then the run fails."}},
         make<WaitSerial>},
    };
}

}  // namespace steps

}  // namespace sim
