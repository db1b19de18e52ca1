// pins.cpp - set-pins, expect-pins: the headers, by JP1's and JP2's D31-D0 or by all pins
#include <array>

#include <fmt/format.h>

#include "sim/pins/header_pin.h"

#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

constexpr const char* LEVELS[] = {"low", "high", "released"};  // as PinLevel

// By which steps name the headers' pins.
constexpr std::array<const char*, HEADERS> KEYS{
#define CHIP_HEADER(wire, port) #port,
#include "sim/pins/chip_wires.def"
};

// Pins of the headers, by the names that they were given.
class Pins {
public:
    explicit Pins(const Values& v)
        : d_{v.mask<std::uint32_t>("jp1"), v.mask<std::uint32_t>("jp2")} {
        for (unsigned n = 0; n < HEADERS; ++n) pins_[n] = v.mask<std::uint64_t>(KEYS[n]);
    }

    HeaderMasks all() const {
        HeaderMasks all = pins_;
        for (unsigned n = 0; n < 2; ++n) all[n] |= pins_of_bits(d_[n]);
        return all;
    }
    // "JP1 D0 and D3, GPIO_1[4]", of those that are among `these`.
    std::string describe(const HeaderMasks& these = all_header_pins()) const {
        std::string text;
        for (unsigned n = 0; n < 2; ++n)
            text += names(fmt::format("JP{} D{{}}", n + 1), " and D{}",
                          d_[n] & bits_of_pins(these[n]), text.empty());
        for (unsigned n = 0; n < HEADERS; ++n)
            text += names(fmt::format("{}[{{}}]", header_wires(n).name), " and [{}]",
                          pins_[n] & these[n], text.empty());
        return text;
    }

private:
    static std::string names(const std::string& first, const std::string& next, std::uint64_t mask,
                             bool is_begin) {
        std::string text;
        for (unsigned n = 0; mask >> n; ++n)
            if (mask >> n & 1) text += fmt::format(fmt::runtime(text.empty() ? first : next), n);
        return text.empty() || is_begin ? text : ", " + text;
    }

    std::uint32_t d_[2];
    HeaderMasks pins_;
};

class SetPins : public Action {
public:
    explicit SetPins(const Values& v) : pins_{v}, level_{v.number<PinLevel>("level")} {}

    void check(StaticChecks& checks) const override { checks.need_on_board(pins_.all()); }
    std::string describe() const override {
        return level_ == PinLevel::RELEASED
                   ? "release " + pins_.describe()
                   : fmt::format("drive {} {}", pins_.describe(), LEVELS[static_cast<int>(level_)]);
    }
    void act(BoardControl& board) const override { board.drive_pins(pins_.all(), level_); }

private:
    Pins pins_;
    PinLevel level_;
};

class ExpectPins : public Claim {
public:
    explicit ExpectPins(const Values& v)
        : pins_{v},
          high_{v.number<PinLevel>("level") == PinLevel::HIGH},
          timeout_{v.get<SimTime>("timeout")} {}

    void check(StaticChecks& checks) const override { checks.need_on_board(pins_.all()); }
    std::string describe() const override {
        return fmt::format("expect {} {}{}", pins_.describe(), high_ ? "high" : "low",
                           within(timeout_));
    }
    Verdict decide(BoardControl& board) const override {
        const HeaderMasks pins = pins_.all();
        HeaderMasks wrong{};
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, timeout_, [&] {
            const HeaderMasks levels = board.header_levels();
            std::uint64_t any = 0;
            for (unsigned n = 0; n < HEADERS; ++n)
                any |= wrong[n] = pins[n] & (high_ ? ~levels[n] : levels[n]);
            return any == 0;
        });
        return {met, met ? "" : pins_.describe(wrong) + (high_ ? " low" : " high")};
    }

private:
    Pins pins_;
    bool high_;
    SimTime timeout_;
};

ValueType pin_number(const std::string& expected, unsigned most) {
    ValueType type = whole_number(expected, 0, most);
    type.list_of = "pin";
    return type;
}
const ValueType DATA_PIN = pin_number("a pin number, 0 to 31", 31);
const ValueType PIN = pin_number("a pin number, 0 to 35", 35);
const ValueType ARDUINO_PIN = pin_number("a pin number, 0 to 15", 15);
const ValueType DRIVE = word("low, high or released", {std::begin(LEVELS), std::end(LEVELS)});
const ValueType LEVEL = word("low or high", {"low", "high"});

std::vector<Field> pins_and(const std::vector<Field>& others) {
    std::vector<Field> fields = {
        {"jp1", DATA_PIN, Need::OPTIONAL, "", "Data pin D0 to D31 of JP1, or a list of numbers."},
        {"jp2", DATA_PIN, Need::OPTIONAL, "", "Data pin D0 to D31 of JP2, or a list of numbers."},
        {"gpio_0", PIN, Need::OPTIONAL, "", "Pin GPIO_0[0] to [35], or a list of numbers."},
        {"gpio_1", PIN, Need::OPTIONAL, "", "Pin GPIO_1[0] to [35], or a list of numbers."},
        {"arduino_io", ARDUINO_PIN, Need::OPTIONAL, "",
         "Pin ARDUINO_IO[0] to [15] of a DE10-Lite or DE10-Nano, or a list of numbers."},
    };
    for (const Field& other : others) fields.push_back(other);
    return fields;
}

}  // namespace

namespace steps {

std::vector<StepForm> pins() {
    const std::vector<const char*> any_header = {"jp1", "jp2", "gpio_0", "gpio_1", "arduino_io"};
    return {
        {"set-pins", "Drive pins of the headers from outside, until told otherwise, and go on.",
         Notation::MAP, any_header,
         pins_and({{"level", DRIVE, Need::REQUIRED, "",
                    "low, high, or released: left to the FPGA and the pull-up."}}),
         make<SetPins>},
        {"expect-pins", "Look at the levels of pins of the headers, whoever drives them.",
         Notation::MAP, any_header,
         pins_and(
             {{"level", LEVEL, Need::REQUIRED, "", "low or high, all of them."},
              {"timeout", TIME, Need::OPTIONAL, "0s", "How long it may take until it is so."}}),
         make<ExpectPins>},
    };
}

}  // namespace steps

}  // namespace sim
