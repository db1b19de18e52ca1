// lamps.cpp - expect-leds, expect-hps-led, expect-hex: eyes on the LEDs and seven-segment digits
#include <bitset>

#include <fmt/format.h>

#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

// ---- expect-leds ----

using Leds = std::bitset<LEDS>;  // bit n = LEDRn

// Ten, as most boards have, up to those of all boards.
constexpr unsigned FEWEST_LEDS = 10;
constexpr std::uint64_t ALL_LEDS = (std::uint64_t{1} << LEDS) - 1;

std::string as_text(std::uint64_t leds) { return fmt::format("{:0{}b}", leds, FEWEST_LEDS); }

Reading read_leds(const YamlNode& node) {
    if (!node.quoted) return whole_number("", 0, ALL_LEDS).read(node);
    if (node.text.size() < FEWEST_LEDS || node.text.size() > LEDS ||
        node.text.find_first_not_of("01") != node.text.npos)
        return std::nullopt;
    return std::uint64_t{Leds(node.text).to_ulong()};
}

// "ten", or "10 to 27".
std::string so_many(unsigned fewest, unsigned most, const char* fewest_in_words) {
    return fewest == most ? fewest_in_words : fmt::format("{} to {}", fewest, most);
}

// In a regular expression: "{10}", "{10,27}".
std::string times(unsigned fewest, unsigned most) {
    return fewest == most ? fmt::format("{{{}}}", most) : fmt::format("{{{},{}}}", fewest, most);
}

const ValueType LEDS_LIT{fmt::format("{} characters 0 or 1, LEDR{} first, or a number from 0 to {}",
                                     so_many(FEWEST_LEDS, LEDS, "ten"), LEDS - 1, ALL_LEDS),
                         fmt::format(R"({{"anyOf": [{{"type": "string", "pattern": "^[01]{}$"}},
                                   {{"type": "integer", "minimum": 0, "maximum": {}}}]}})",
                                     times(FEWEST_LEDS, LEDS), ALL_LEDS),
                         read_leds};

class ExpectLeds : public Claim {
public:
    explicit ExpectLeds(const Values& v)
        : leds_{v.number<std::uint64_t>("equals")}, timeout_{v.get<SimTime>("timeout")} {}

    void check(StaticChecks& checks) const override {
        for (unsigned n = 0; n < leds_.size(); ++n)
            if (leds_[n])
                checks.need_on_board(wire_of(WireGroup::LAMPS, n), fmt::format("LED {}", n));
    }
    std::string describe() const override {
        return "expect LEDs " + as_text(leds_.to_ulong()) + within(timeout_);
    }
    Verdict decide(BoardControl& board) const override {
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return Leds{board.ledr()} == leds_; });
        return {met, "LEDR shows " + as_text(board.ledr())};
    }

private:
    Leds leds_;
    SimTime timeout_;
};

// ---- expect-hps-led ----

const ValueType LIT = word("dark or lit", {"dark", "lit"});

class ExpectHpsLed : public Claim {
public:
    explicit ExpectHpsLed(const Values& v)
        : lit_{v.number<bool>("equals")}, timeout_{v.get<SimTime>("timeout")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("HPS", "the processor's LED");
    }
    std::string describe() const override {
        return std::string{"expect the HPS LED "} + (lit_ ? "lit" : "dark") + within(timeout_);
    }
    Verdict decide(BoardControl& board) const override {
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return board.hps_led() == lit_; });
        return {met, board.hps_led() ? "it is lit" : "it is dark"};
    }

private:
    bool lit_;
    SimTime timeout_;
};

// ---- expect-hex ----

Reading read_hex(const YamlNode& node) {
    if (!is_text(node) || !is_hex_text(node.text)) return std::nullopt;
    return node.text;
}

const ValueType HEX{
    fmt::format("{} characters, HEX{} first, of 0-9 A-F H L P U n o r t u y - _ and blank",
                so_many(FEWEST_DIGITS, HEX_DIGITS, "six"), HEX_DIGITS - 1),
    fmt::format(R"({{"type": "string", "pattern": "^[0-9A-FHLPUnortuy _-]{}$"}})",
                times(FEWEST_DIGITS, HEX_DIGITS)),
    read_hex};

class ExpectHex : public Claim {
public:
    explicit ExpectHex(const Values& v)
        : text_{v.get<std::string>("equals")}, timeout_{v.get<SimTime>("timeout")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("HEX0[0]", "the seven-segment digits");
    }
    std::string describe() const override {
        return "expect \"" + text_ + "\" on HEX" + within(timeout_);
    }
    Verdict decide(BoardControl& board) const override {
        const auto shown = [&] { return hex_text(board.hex(), text_); };
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return shown() == text_; });
        return {met, "HEX shows \"" + shown() + "\""};
    }

private:
    std::string text_;  // HEX0 last
    SimTime timeout_;
};

constexpr const char* TIMEOUT_HELP = "How long it may take until it is so.";

}  // namespace

namespace steps {

std::vector<StepForm> lamps() {
    return {
        {"expect-leds",
         "Look at the ten red LEDs.",
         Notation::BOTH,
         {},
         {{"equals", LEDS_LIT, Need::REQUIRED, "",
           "Ten characters 0 or 1 in quotes, LEDR9 first, or the number they make."},
          {"timeout", TIME, Need::OPTIONAL, "0s", TIMEOUT_HELP}},
         make<ExpectLeds>},
        {"expect-hps-led",
         "Look at the green LED of the processor.",
         Notation::BOTH,
         {},
         {{"equals", LIT, Need::REQUIRED, "", "dark or lit."},
          {"timeout", TIME, Need::OPTIONAL, "0s", TIMEOUT_HELP}},
         make<ExpectHpsLed>},
        {"expect-hex",
         "Read the six seven-segment digits.",
         Notation::BOTH,
         {},
         {{"equals", HEX, Need::REQUIRED, "",
           "Six characters in quotes, HEX5 first: 0-9 A-F H L P U n o r t u y - _ and blank. "
           "6, 7 and 9 count in both of their usual forms."},
          {"timeout", TIME, Need::OPTIONAL, "0s", TIMEOUT_HELP}},
         make<ExpectHex>},
    };
}

}  // namespace steps

}  // namespace sim
