// parts.cpp - press-button, hold-button, release-button, set-switch, expect-led, expect-matrix: the
// parts that the scenario hangs on the headers
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/pattern.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;
using Kind = PartPlan::Kind;

// ---- Buttons ----

class OnPartButton : public Action {
protected:
    explicit OnPartButton(const Values& v) : button_{v.get<std::string>("button")} {}

    std::string control(const StaticChecks& checks) const {
        checks.need_part(Kind::BUTTON, button_);
        return "button " + button_;
    }

    std::string button_;
};

class PressPartButton : public OnPartButton {
public:
    explicit PressPartButton(const Values& v) : OnPartButton{v}, time_{v.get<SimTime>("for")} {}

    std::string describe() const override {
        return fmt::format("press the button {} for {}", button_, to_string(time_));
    }
    SimTime least() const override { return time_; }
    void check(StaticChecks& checks) const override { checks.need_free(control(checks)); }
    void act(BoardControl& board) const override {
        board.close_contact(button_, true);
        board.wait(time_);
        board.close_contact(button_, false);
    }

private:
    SimTime time_;
};

class HoldPartButton : public OnPartButton {
public:
    explicit HoldPartButton(const Values& v) : OnPartButton{v} {}
    std::string describe() const override { return "hold the button " + button_; }
    void check(StaticChecks& checks) const override { checks.hold(control(checks)); }
    void act(BoardControl& board) const override { board.close_contact(button_, true); }
};

class ReleasePartButton : public OnPartButton {
public:
    explicit ReleasePartButton(const Values& v) : OnPartButton{v} {}
    std::string describe() const override { return "release the button " + button_; }
    void check(StaticChecks& checks) const override { checks.release(control(checks)); }
    void act(BoardControl& board) const override { board.close_contact(button_, false); }
};

// ---- set-switch ----

class SetSwitch : public Action {
public:
    explicit SetSwitch(const Values& v)
        : switch_{v.get<std::string>("switch")}, high_{v.number<bool>("level")} {}

    std::string describe() const override {
        return fmt::format("set the switch {} {}", switch_, high_ ? "high" : "low");
    }
    void check(StaticChecks& checks) const override { checks.need_part(Kind::SWITCH, switch_); }
    void act(BoardControl& board) const override { board.close_contact(switch_, high_); }

private:
    std::string switch_;
    bool high_;
};

// ---- expect-led ----

class ExpectLed : public Claim {
public:
    explicit ExpectLed(const Values& v)
        : led_{v.get<std::string>("led")},
          lit_{v.number<bool>("equals")},
          timeout_{v.get<SimTime>("timeout")} {}

    std::string describe() const override {
        return fmt::format("expect the LED {} {}{}", led_, lit_ ? "lit" : "dark", within(timeout_));
    }
    void check(StaticChecks& checks) const override { checks.need_part(Kind::LED, led_); }
    Verdict decide(BoardControl& board) const override {
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return board.led_is_lit(led_) == lit_; });
        return {met, met ? "" : lit_ ? "it is dark" : "it is lit"};
    }

private:
    std::string led_;
    bool lit_;
    SimTime timeout_;
};

// ---- expect-matrix ----

class ExpectMatrix : public Claim {
public:
    explicit ExpectMatrix(const Values& v)
        : matrix_{v.get<std::string>("matrix")},
          rows_{rows_of(v.get<std::string>("equals"))},
          timeout_{v.get<SimTime>("timeout")} {}

    std::string describe() const override {
        return fmt::format("expect {} on the matrix {}{}", fmt::join(rows_, "/"), matrix_,
                           within(timeout_));
    }
    void check(StaticChecks& checks) const override {
        const PartPlan& part = checks.need_part(Kind::LED_MATRIX, matrix_);
        const auto width = std::max_element(rows_.begin(), rows_.end(), [](auto& a, auto& b) {
                               return a.size() < b.size();
                           })->size();
        for (const std::string& row : rows_)
            if (rows_.size() != part.rows() || row.size() != part.columns.size())
                checks.refuse_step(
                    fmt::format("{} rows of {} characters, as {} of line {} has them", part.rows(),
                                part.columns.size(), matrix_, part.line),
                    fmt::format("{} rows of {}", rows_.size(),
                                row.size() == width ? width : row.size()));
    }
    Verdict decide(BoardControl& board) const override {
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return board.matrix_rows(matrix_) == rows_; });
        return {met, met ? ""
                         : fmt::format("{} shows {}", matrix_,
                                       fmt::join(board.matrix_rows(matrix_), "/"))};
    }

private:
    static std::vector<std::string> rows_of(const std::string& text) {
        std::vector<std::string> rows{""};
        for (const char c : text)
            if (c == '\n')
                rows.emplace_back();
            else
                rows.back() += c;
        if (rows.back().empty()) rows.pop_back();
        return rows;
    }

    std::string matrix_;
    std::vector<std::string> rows_;
    SimTime timeout_;
};

Reading read_rows(const YamlNode& node) {
    static const Pattern ALL{"[.#+]+(\n[.#+]+)*\n?"};
    if (!is_text(node) || node.text.size() > 2000 || !ALL.matches(node.text)) return std::nullopt;
    return node.text;
}

const ValueType ROWS_OF_LEDS{"rows of the characters . # +, a line each",
                             R"({"type": "string", "pattern": "^[.#+]+(\\n[.#+]+)*\\n?$"})",
                             read_rows};
const ValueType SWITCH_LEVEL = word("low or high", {"low", "high"});
const ValueType LIT_OR_DARK = word("dark or lit", {"dark", "lit"});
constexpr const char* UNTIL_HELP = "How long it may take until it is so.";

}  // namespace

namespace steps {

std::vector<StepForm> parts() {
    const Field button{"button", LINE, Need::REQUIRED, "", "Its name among the parts."};
    return {
        {"press-button",
         "Press a button of the parts and let go; the next step comes after that. One that was "
         "let go of just before is pressed 50 ms later.",
         Notation::BOTH,
         {},
         {button, {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}},
         make<PressPartButton>},
        {"hold-button",
         "Begin to hold a button of the parts and go on to the next step.",
         Notation::BOTH,
         {},
         {button},
         make<HoldPartButton>},
        {"release-button",
         "Let go of a button that is held.",
         Notation::BOTH,
         {},
         {button},
         make<ReleasePartButton>},
        {"set-switch",
         "Move a switch of the parts and go on.",
         Notation::MAP,
         {},
         {{"switch", LINE, Need::REQUIRED, "", "Its name among the parts."},
          {"level", SWITCH_LEVEL, Need::REQUIRED, "", "What it puts on its pin."}},
         make<SetSwitch>},
        {"expect-led",
         "Look at an LED of the parts.",
         Notation::MAP,
         {},
         {{"led", LINE, Need::REQUIRED, "", "Its name among the parts."},
          {"equals", LIT_OR_DARK, Need::REQUIRED, "", "dark or lit."},
          {"timeout", TIME, Need::OPTIONAL, "0s", UNTIL_HELP}},
         make<ExpectLed>},
        {"expect-matrix",
         "Look at an LED matrix of the parts.",
         Notation::MAP,
         {},
         {{"matrix", LINE, Need::REQUIRED, "", "Its name among the parts."},
          {"equals", ROWS_OF_LEDS, Need::REQUIRED, "",
           "The picture as text, a line per row: `#` is lit, `+` with less than a third of the "
           "brightest LED's light, `.` dark."},
          {"timeout", TIME, Need::OPTIONAL, "0s", UNTIL_HELP}},
         make<ExpectMatrix>},
    };
}

}  // namespace steps

}  // namespace sim
