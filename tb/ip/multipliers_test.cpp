// Products and their sums, by Intel's "Integer Arithmetic IP Cores User Guide" (683490); the
// reference is C++'s arithmetic on random numbers, and the registers that the guide counts.

#include "Vmultipliers_bench.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <deque>
#include <random>

namespace {

using Number = std::int64_t;

class Multipliers : public testing::Test {
protected:
    Multipliers() {
        dut.enable_i = 1;
        next();
    }

    // Other random numbers at the inputs; those of the clocks before are in `before`.
    void next() {
        dut.a_i = random() & 0xF'FFFF'FFFF;
        dut.b_i = static_cast<std::uint32_t>(random() & 0xFFF'FFFF);
        if (random() % 4 == 0) dut.a_i = random() % 2 ? 0x8'0402'0100 : 0xF'FFFF'FFFF;
        if (random() % 4 == 0) dut.b_i = random() % 2 ? 0x810'2040 : 0xFFF'FFFF;
        dut.signa_i = random() & 1;
        dut.signb_i = random() & 1;
        dut.add_1_i = random() & 1;
        dut.add_3_i = random() & 1;
        dut.eval();
    }
    // The clock rises on these inputs, then come others.
    void clock() {
        before.push_front({dut.a_i, dut.b_i, dut.signa_i != 0, dut.add_1_i != 0});
        rise();
        next();
    }
    void rise() {
        dut.clock_i = 1;
        dut.eval();
        dut.clock_i = 0;
        dut.eval();
    }

    struct Inputs {
        std::uint64_t a, b;
        bool sign_a, add_1;

        Number a_of(unsigned i, bool sign) const { return part(a, 9 * i, 9, sign); }
        Number b_of(unsigned i, bool sign) const { return part(b, 7 * i, 7, sign); }
        Number product(unsigned i, bool sign_of_a, bool sign_of_b) const {
            return a_of(i, sign_of_a) * b_of(i, sign_of_b);
        }
    };
    Inputs now() const { return {dut.a_i, dut.b_i, dut.signa_i != 0, dut.add_1_i != 0}; }

    // Bits `lowest` to `lowest` + `width` - 1, as a number.
    static Number part(std::uint64_t word, unsigned lowest, unsigned width, bool sign) {
        const Number value = static_cast<Number>(word >> lowest & ((1ull << width) - 1));
        return sign && value >> (width - 1) ? value - (Number{1} << width) : value;
    }
    // The lower `width` bits.
    static Number low(Number value, unsigned width) {
        return part(static_cast<std::uint64_t>(value), 0, width, false);
    }

    std::mt19937_64 random{11};
    Vmultipliers_bench dut;
    std::deque<Inputs> before;
    static constexpr int TIMES = 2000;
};

TEST_F(Multipliers, MultiplyForANiosWithASignByPort) {
    for (int i = 0; i < TIMES; ++i) {
        const Number a = part(dut.a_i, 0, 16, false);
        const Number b = part(dut.b_i, 0, 16, dut.signb_i != 0);
        clock();
        EXPECT_EQ(dut.nios_o, low(a * b, 32));
    }
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.nios_o, 0);
}

TEST_F(Multipliers, AddAndSubtractFourProductsAsPortsSay) {
    for (int i = 0; i < TIMES; ++i, next()) {
        const bool a = dut.signa_i != 0, b = dut.signb_i != 0;
        const Inputs in = now();
        EXPECT_EQ(dut.four_o,
                  low(in.product(0, a, b) + in.product(1, a, b) * (dut.add_1_i ? 1 : -1) +
                          in.product(2, a, b) + in.product(3, a, b) * (dut.add_3_i ? 1 : -1),
                      18));
    }
}

TEST_F(Multipliers, ExtendASignedSumThreeClocksLater) {
    for (int i = 0; i < TIMES; ++i) {
        clock();
        if (i < 2) continue;
        const Inputs& in = before[2];
        EXPECT_EQ(dut.late_o, low(in.product(0, true, true) - in.product(1, true, true) +
                                      in.product(2, true, true),
                                  28));
    }
}

TEST_F(Multipliers, ClearOnlyTheRegistersOfAClear) {
    clock();
    dut.aclr_i = 1;  // the first operands
    dut.eval();
    dut.aclr_i = 0;
    before[0].a &= ~0x1FFull;
    clock();
    clock();
    const auto sum = [](const Inputs& in, bool second) {
        return low(in.product(0, true, true) - (second ? in.product(1, true, true) : 0) +
                       in.product(2, true, true),
                   28);
    };
    EXPECT_EQ(dut.late_o, sum(before[2], true));
    dut.sclr_i = 1;  // the second product
    clock();
    dut.sclr_i = 0;
    clock();
    EXPECT_EQ(dut.late_o, sum(before[2], false));
    const unsigned late = dut.late_o;
    dut.enable_i = 0;
    clock();
    EXPECT_EQ(dut.late_o, late);
}

TEST_F(Multipliers, HandOperandsOnFromOneToTheNext) {
    for (int i = 0; i < TIMES; ++i) {
        clock();
        if (i < 3) continue;
        Number sum = 0;
        for (unsigned k = 0; k < 3; ++k) sum += before[k].a_of(0, false) * now().b_of(k, false);
        EXPECT_EQ(dut.fir_o, low(sum, 18));
        EXPECT_EQ(dut.fir_scan_o, before[3].a_of(0, false));
    }
}

TEST_F(Multipliers, TakeAnOperandFromWhereAPortSays) {
    for (int i = 0; i < 64; ++i, next()) {
        dut.source_i = i % 16;
        dut.eval();
        const Number a = now().a_of(i & 2 ? 0 : 1, false), b = now().b_of(i & 8 ? 0 : 1, false);
        EXPECT_EQ(dut.chosen_o, now().product(0, false, false) + a * b);
    }
}

TEST_F(Multipliers, AccumulateFromAConstantOn) {
    Number up = 0, down = 0;
    bool load = false;
    rise();
    dut.aclr_i = 1;
    dut.load_i = 1;
    rise();
    dut.aclr_i = 0;
    load = true;
    for (int i = 0; i < TIMES; ++i) {
        dut.load_i = i % 50 == 0;
        dut.eval();
        up = (load ? 32 : up) + now().product(0, true, true);
        down = (load ? 0 : down) - now().product(0, false, false);
        load = dut.load_i != 0;
        clock();
        EXPECT_EQ(dut.up_o, low(up, 20)) << i;
        EXPECT_EQ(dut.down_o, low(down, 20)) << i;
    }
}

TEST_F(Multipliers, TakeClocksOfLatencyBeforeTheProduct) {
    for (int i = 0; i < 20; ++i) {
        clock();
        if (i < 2) continue;
        EXPECT_EQ(dut.latency_o, before[2].product(0, false, false));
    }
}

TEST_F(Multipliers, HaveRegistersOfSeveralClocks) {
    const Number product = now().product(0, false, false);
    rise();
    EXPECT_EQ(dut.clocks_o, 0);
    dut.other_clock_i = 1;
    dut.eval();
    EXPECT_EQ(dut.clocks_o, product);
    const Number b = now().b_of(0, false);
    next();
    dut.enable_i = 0;  // of clock 2 alone
    dut.other_clock_i = 0;
    rise();
    dut.other_clock_i = 1;
    dut.eval();
    EXPECT_EQ(dut.clocks_o, now().a_of(0, false) * b);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.clocks_o, 0);
}

TEST_F(Multipliers, WorkAsAWizardWritesThem) {
    for (int i = 0; i < TIMES; ++i, next())
        EXPECT_EQ(dut.wizard_o,
                  low(now().product(0, true, true) - now().product(1, true, true), 16));
}

TEST_F(Multipliers, HaveAllRegistersInAltmultAddIfNotToldOtherwise) {
    for (int i = 0; i < TIMES; ++i) {
        clock();
        if (i < 2) continue;
        const Inputs& in = before[2];
        EXPECT_EQ(dut.old_o, low(in.product(0, true, false) - in.product(1, true, false) +
                                     in.product(2, true, false) + in.product(3, true, false),
                                 18));
        const Number second = in.product(1, in.sign_a, true);
        EXPECT_EQ(dut.old_add_o,
                  low(in.product(0, in.sign_a, true) + (in.add_1 ? second : -second), 19));
    }
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.old_o, 0);
}

TEST_F(Multipliers, MultiplyComplexNumbers) {
    for (int i = 0; i < TIMES; ++i) {
        const Inputs in = now();
        const Number ar = in.a_of(0, true), ai = in.a_of(1, true);
        const Number br = in.b_of(0, true), bi = in.b_of(1, true);
        EXPECT_EQ(dut.real_o, low(ar * br - ai * bi, 18));
        EXPECT_EQ(dut.imag_o, low(ar * bi + ai * br, 18));
        clock();
        if (i < 2) continue;
        const Inputs& then = before[2];
        const Number cr = then.a_of(0, false), ci = then.a_of(1, false);
        const Number dr = then.b_of(0, true), di = then.b_of(1, true);
        EXPECT_EQ(dut.late_real_o, low(cr * dr - ci * di, 18));
        EXPECT_EQ(dut.late_imag_o, low(cr * di + ci * dr, 18));
    }
}

}  // namespace
