// leds.cpp - the parts led and led-matrix; expect-led, expect-matrix
#include <algorithm>

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/board/led_matrix.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/part_form.h"
#include "sim/scenario/static_checks.h"
#include "sim/text/pattern.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

// ---- The parts ----

PartPlan leds(LedMatrix::Wiring wiring) {
    PartPlan part;
    (wiring.coded_rows ? part.shared : part.pins) = wiring.rows;
    part.pins.insert(part.pins.end(), wiring.columns.begin(), wiring.columns.end());
    part.rows = wiring.row_count();
    part.columns = static_cast<unsigned>(wiring.columns.size());
    part.hang = [wiring = std::move(wiring)](const PartSocket&) {
        return std::make_unique<LedMatrix>(wiring);
    };
    return part;
}

PartPlan led(const Values& v) {
    return leds({pins_of(v, "pin"), {}, v.number<bool>("lit"), false, false});
}

PartPlan led_matrix(const Values& v) {
    const bool coded = v.find("row-number");
    return leds({pins_of(v, coded ? "row-number" : "rows"), pins_of(v, "columns"),
                 v.number<bool>("row-lit"), v.number<bool>("column-lit"), coded});
}

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
    void check(StaticChecks& checks) const override { checks.need_part("led", led_); }
    Verdict decide(BoardControl& board) const override {
        LedMatrix& led = board.part<LedMatrix>(led_);
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_, [&] {
            board.catch_up();
            return led.lit(board.now_ps()) == lit_;
        });
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
        const PartPlan& part = checks.need_part("led-matrix", matrix_);
        const auto width = std::max_element(rows_.begin(), rows_.end(), [](auto& a, auto& b) {
                               return a.size() < b.size();
                           })->size();
        for (const std::string& row : rows_)
            if (rows_.size() != part.rows || row.size() != part.columns)
                checks.refuse_step(
                    fmt::format("{} rows of {} characters, as {} of line {} has them", part.rows,
                                part.columns, matrix_, part.line),
                    fmt::format("{} rows of {}", rows_.size(),
                                row.size() == width ? width : row.size()));
    }
    Verdict decide(BoardControl& board) const override {
        const auto shown = [&, &matrix = board.part<LedMatrix>(matrix_)] {
            board.catch_up();
            return matrix.rows(board.now_ps());
        };
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return shown() == rows_; });
        return {met, met ? "" : fmt::format("{} shows {}", matrix_, fmt::join(shown(), "/"))};
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
const ValueType LIT_OR_DARK = word("dark or lit", {"dark", "lit"});
constexpr const char* UNTIL_HELP = "How long it may take until it is so.";

}  // namespace

namespace parts {

PartFamily leds() {
    std::vector<PartForm> parts{
        {"led",
         "An LED.",
         Notation::MAP,
         {},
         {part_name(),
          {"pin", PART_PIN, Need::REQUIRED, "", "Where it is."},
          {"lit", PIN_LEVEL, Need::OPTIONAL, "high", "The level that lights it."}},
         led},
        {"led-matrix",
         "An LED at each crossing of a row and a column, seen as a person sees it while its rows "
         "or "
         "columns are shown one after the other.",
         Notation::MAP,
         {"rows", "row-number"},
         {part_name(),
          {"rows", PART_PINS, Need::OPTIONAL, "", "The rows' pins, from the top."},
          {"row-number", NUMBER_PINS, Need::OPTIONAL, "",
           "Instead of `rows`, where the LED board decodes a number: its pins, from the highest "
           "bit. Row 0 is at the top. Several matrices may share them."},
          {"columns", PART_PINS, Need::REQUIRED, "", "The columns' pins, from the left."},
          {"row-lit", PIN_LEVEL, Need::OPTIONAL, "high", "The level of a row that is shown."},
          {"column-lit", PIN_LEVEL, Need::OPTIONAL, "low",
           "The level of a column whose LED in that row is lit."}},
         led_matrix,
         true},
    };
    std::vector<StepForm> steps{
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
    return {std::move(parts), std::move(steps)};
}

}  // namespace parts

}  // namespace sim
