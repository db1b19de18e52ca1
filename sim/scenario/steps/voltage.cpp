// voltage.cpp - set-voltage: what is wired to the AD converter's inputs
#include <fmt/format.h>

#include <cmath>

#include "sim/board/ltc2308.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

class SetVoltage : public Action {
public:
    explicit SetVoltage(const Values& v)
        : channel_{v.number<unsigned>("channel")}, volts_{v.get<double>("volts")} {}

    void check(StaticChecks& checks) const override {
        if (checks.has_on_board("ADC_DOUT")) return;
        const std::string input = fmt::format("ANALOG[{}]", channel_);
        checks.need_on_board(input, fmt::format("input {} of the AD converter", channel_));
    }
    std::string describe() const override {
        return fmt::format("apply {:.6g} V to CH{}", volts_, channel_);
    }
    void act(BoardControl& board) const override {
        auto& converter = board.part<Ltc2308>("AD converter");
        const int millivolts = static_cast<int>(std::lround(volts_ * 1000));
        board.act(
            [&converter, channel = channel_, millivolts] { converter.set(channel, millivolts); });
    }

private:
    unsigned channel_;
    double volts_;
};

const ValueType CHANNEL = whole_number("a channel number, 0 to 7", 0, 7);
const ValueType VOLTS = decimal_number("a number of volts, 0 to 5", 0, 5);

}  // namespace

namespace steps {

std::vector<StepForm> voltage() {
    return {
        {"set-voltage",
         "Apply a voltage to an input of the AD converter and go on; all begin at 0 V. On a "
         "DE10-Lite the inputs are Arduino_A0 to A5.",
         Notation::MAP,
         {},
         {{"channel", CHANNEL, Need::REQUIRED, "", "The input, CH0 to CH7."},
          {"volts", VOLTS, Need::REQUIRED, "", "Against ground."}},
         make<SetVoltage>},
    };
}

}  // namespace steps

}  // namespace sim
