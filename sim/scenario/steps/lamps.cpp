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

using Leds = std::bitset<10>;  // bit n = LEDRn

Reading read_leds(const YamlNode& node) {
    if (!node.quoted) return whole_number("", 0, 1023).read(node);
    if (node.text.size() != 10 || node.text.find_first_not_of("01") != node.text.npos)
        return std::nullopt;
    return std::uint64_t{Leds(node.text).to_ulong()};
}

const ValueType LEDS{"ten characters 0 or 1, LEDR9 first, or a number from 0 to 1023",
                     R"({"anyOf": [{"type": "string", "pattern": "^[01]{10}$"},
                                   {"type": "integer", "minimum": 0, "maximum": 1023}]})",
                     read_leds};

class ExpectLeds : public Claim {
public:
    explicit ExpectLeds(const Values& v)
        : leds_{v.number<std::uint64_t>("equals")}, timeout_{v.get<SimTime>("timeout")} {}

    void check(StaticChecks& checks) const override {
        for (unsigned n = 0; n < leds_.size(); ++n)
            if (leds_[n])
                checks.need_on_board(fmt::format("LEDR[{}]", n), fmt::format("LED {}", n));
    }
    std::string describe() const override {
        return "expect LEDs " + leds_.to_string() + within(timeout_);
    }
    Verdict decide(BoardControl& board) const override {
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_,
                                          [&] { return Leds{board.ledr()} == leds_; });
        return {met, "LEDR shows " + Leds{board.ledr()}.to_string()};
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

const ValueType HEX{"six characters, HEX5 first, of 0-9 A-F H L P U n o r t u y - _ and blank",
                    R"({"type": "string", "pattern": "^[0-9A-FHLPUnortuy _-]{6}$"})", read_hex};

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
    std::string text_;  // six characters, HEX5 first
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
         {{"equals", LEDS, Need::REQUIRED, "",
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
