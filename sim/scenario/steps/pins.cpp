// pins.cpp - set-pins, expect-pins: the headers JP1 and JP2
#include <fmt/format.h>

#include "sim/scenario/stage.h"
#include "sim/scenario/step_form.h"
#include "sim/scenario/words.h"

namespace sim {

namespace {

using namespace value_types;

constexpr const char* LEVELS[] = {"low", "high", "released"};  // as PinLevel

// Pins of both headers.
struct Pins {
    explicit Pins(const Values& v)
        : jp1{v.mask<std::uint32_t>("jp1")}, jp2{v.mask<std::uint32_t>("jp2")} {}

    // "JP1 D0 and D3, JP2 D4".
    static std::string say(std::uint32_t jp1, std::uint32_t jp2) {
        std::string all;
        for (const auto& [name, mask] : {std::pair{"JP1", jp1}, {"JP2", jp2}}) {
            std::string header;
            for (unsigned n = 0; n < 32; ++n)
                if (mask >> n & 1)
                    header += fmt::format("{} D{}", header.empty() ? name : " and", n);
            all += (all.empty() || header.empty() ? "" : ", ") + header;
        }
        return all;
    }
    std::string say() const { return say(jp1, jp2); }

    std::uint32_t jp1, jp2;
};

class SetPins : public Action {
public:
    explicit SetPins(const Values& v) : pins_{v}, level_{v.number<PinLevel>("level")} {}

    std::string say() const override {
        return level_ == PinLevel::RELEASED
                   ? "release " + pins_.say()
                   : fmt::format("drive {} {}", pins_.say(), LEVELS[static_cast<int>(level_)]);
    }
    void act(Stage& stage) const override { stage.drive_pins(pins_.jp1, pins_.jp2, level_); }

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

    std::string say() const override {
        return fmt::format("expect {} {}{}", pins_.say(), high_ ? "high" : "low", within(timeout_));
    }
    Verdict decide(Stage& stage) const override {
        const auto wrong = [&](std::uint32_t pins, std::uint32_t levels) {
            return pins & (high_ ? ~levels : levels);
        };
        std::uint32_t jp1 = 0, jp2 = 0;
        const bool met = stage.wait_until(Stage::Each::MILLISECOND, timeout_, [&] {
            jp1 = wrong(pins_.jp1, stage.jp1());
            jp2 = wrong(pins_.jp2, stage.jp2());
            return !jp1 && !jp2;
        });
        return {met, met ? "" : Pins::say(jp1, jp2) + (high_ ? " low" : " high")};
    }

private:
    Pins pins_;
    bool high_;
    SimTime timeout_;
};

const ValueType PIN = [] {
    ValueType type = whole_number("a pin number, 0 to 31", 0, 31);
    type.list_of = "pin";
    return type;
}();
const ValueType DRIVE = word("low, high or released", {std::begin(LEVELS), std::end(LEVELS)});
const ValueType LEVEL = word("low or high", {"low", "high"});

std::vector<Field> pins_and(const std::vector<Field>& others) {
    std::vector<Field> fields = {
        {"jp1", PIN, Need::OPTIONAL, "", "Data pin D0 to D31 of JP1, or a list of numbers."},
        {"jp2", PIN, Need::OPTIONAL, "", "Data pin D0 to D31 of JP2, or a list of numbers."},
    };
    for (const Field& other : others) fields.push_back(other);
    return fields;
}

}  // namespace

namespace steps {

std::vector<StepForm> pins() {
    const std::vector<const char*> any_header = {"jp1", "jp2"};
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
