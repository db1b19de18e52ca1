// voltage_test.cpp - set-voltage
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;

class VoltageSteps : public StepTest {
protected:
    // As the converter sends them: a conversion, whose word selects the next one's channel, twice.
    unsigned millivolts(unsigned channel) {
        const unsigned word = 0b100010 | (channel & 1) << 4 | (channel >> 1) << 2;
        unsigned result = 0;
        for (unsigned twice = 0; twice < 2; ++twice) {
            board.converter.drive(true, false, false, now_ps_);
            board.converter.drive(false, false, false, now_ps_ += sim::Ltc2308::CONVERSION_PS);
            result = 0;
            for (unsigned n = 0; n < 12; ++n) {
                const bool bit = n < 6 && word >> (5 - n) & 1;
                result = result << 1 | board.converter.sdo();
                board.converter.drive(false, true, bit, now_ps_ += 100'000);
                board.converter.drive(false, false, bit, now_ps_ += 100'000);
            }
        }
        return result;
    }

private:
    std::uint64_t now_ps_ = 0;
};

TEST_F(VoltageSteps, SetAChannelToVolts) {
    acts("set-voltage: {channel: 7, volts: 1.25}");
    EXPECT_EQ(millivolts(7), 1250u);
    EXPECT_EQ(millivolts(6), 0u);
    EXPECT_EQ(said("set-voltage: {channel: 0, volts: 3}"), "apply 3 V to CH0");
}

}  // namespace
