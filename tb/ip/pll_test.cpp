// altpll and altera_pll: which clocks they ask for, and what they do with them.

#include "Vpll_bench.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

namespace {

struct Tap {
    long long period_fs, phase_fs, high_fs;
    bool operator==(const Tap& other) const {
        return period_fs == other.period_fs && phase_fs == other.phase_fs &&
               high_fs == other.high_fs;
    }
};
std::ostream& operator<<(std::ostream& out, const Tap& tap) {
    return out << tap.period_fs << " fs, phase " << tap.phase_fs << ", high " << tap.high_fs;
}

std::map<std::string, Tap> taps;  // by the instance of the PLL and the clock's number
int locks_waiting = 0;

}  // namespace

extern "C" void de1sim_pll_waits(int more) { locks_waiting += more; }

extern "C" void tap_found(long long period_fs, long long phase_fs, long long high_fs,
                          const char* path) {
    std::string name = path;  // TOP.pll_bench.short.output_clock[0].used.tap
    const std::string top = "pll_bench.";
    name = name.substr(name.find(top) + top.size());
    const std::size_t index = name.find(".output_clock");
    name = name.substr(0, index) + name[name.find_first_of("0123456789", index)];
    taps[name] = {period_fs, phase_fs, high_fs};
}

namespace {

using testing::Pair;
using testing::UnorderedElementsAre;

constexpr unsigned LOCK_CLOCKS = 16;

class Pll : public testing::Test {
protected:
    Pll() {
        taps.clear();
        locks_waiting = 0;
        dut.clkena_i = 3;
        dut.pllena_i = 1;
        dut.eval();
    }

    void refclk(unsigned times) {
        for (; times; --times) {
            dut.refclk_i = 1;
            dut.eval();
            dut.refclk_i = 0;
            dut.eval();
        }
    }

    // The outputs, one bit each, with `clocks` from the taps.
    unsigned outputs(unsigned clocks) {
        dut.clocks_i = clocks;
        dut.eval();
        return dut.wizard_o | dut.short_o << 2 | dut.gated_o << 3 | dut.generated_o << 5;
    }

    Vpll_bench dut;
};

TEST_F(Pll, RequestsUsedClocksByPeriodPhaseAndDuty) {
    EXPECT_THAT(taps, UnorderedElementsAre(
                          Pair("wizard.altpll_component0", Tap{40'000'000, 0, 20'000'000}),
                          Pair("wizard.altpll_component1", Tap{10'000'000, 7'000'000, 5'000'000}),
                          Pair("short0", Tap{40'000'000, 0, 20'000'000}),
                          Pair("gated0", Tap{39'682'500, 0, 19'841'250}),
                          Pair("altera_pll_i0", Tap{39'721'946, 0, 19'860'973}),
                          Pair("altera_pll_i1", Tap{10'000'000, 7'000'000, 2'500'000}),
                          Pair("altera_pll_i3", Tap{80'000'000'000, 1'500'000, 40'000'000'000})));
}

TEST_F(Pll, PassesThoseClocksOn) {
    EXPECT_EQ(outputs(1), 0b0000'00'1'01u);
    EXPECT_EQ(outputs(2), 0b0010'00'0'10u);
    EXPECT_EQ(outputs(4), 0b0001'01'0'00u);
    EXPECT_EQ(outputs(0), 0u);
}

TEST_F(Pll, HoldsItsClocksLowInReset) {
    dut.rst_i = 1;
    EXPECT_EQ(outputs(7), 0b0000'01'1'00u);  // two have none
}

TEST_F(Pll, HoldsAClockLowWithoutItsEnableOrThePlls) {
    dut.clkena_i = 2;
    EXPECT_EQ(outputs(4), 0b0001'00'0'00u);
    dut.clkena_i = 3;
    dut.pllena_i = 0;
    EXPECT_EQ(outputs(4), 0b0001'00'0'00u);
}

TEST_F(Pll, IsLockedAfterSixteenClocksWithoutReset) {
    refclk(LOCK_CLOCKS - 1);
    EXPECT_FALSE(dut.wizard_locked_o || dut.generated_locked_o);
    EXPECT_GT(locks_waiting, 0);
    refclk(1);
    EXPECT_TRUE(dut.wizard_locked_o && dut.generated_locked_o);
    EXPECT_EQ(locks_waiting, 0);
    refclk(100);
    EXPECT_TRUE(dut.wizard_locked_o && dut.generated_locked_o);
    dut.rst_i = 1;
    dut.eval();
    EXPECT_FALSE(dut.wizard_locked_o || dut.generated_locked_o);
    EXPECT_GT(locks_waiting, 0);
    refclk(100);
    dut.rst_i = 0;
    refclk(LOCK_CLOCKS - 1);
    EXPECT_FALSE(dut.wizard_locked_o || dut.generated_locked_o);
    refclk(1);
    EXPECT_TRUE(dut.wizard_locked_o && dut.generated_locked_o);
}

}  // namespace
