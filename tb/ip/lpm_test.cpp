// The LPM library, by Intel's "Integer Arithmetic IP Cores User Guide" (683490) and LPM's own.

#include "Vlpm_bench.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstdlib>

namespace {

class Lpm : public testing::Test {
protected:
    Lpm() {
        dut.enable_i = dut.count_i = dut.up_i = 1;
        dut.eval();
    }

    void clock(unsigned times = 1) {
        for (; times; --times) {
            dut.clock_i = 1;
            dut.eval();
            dut.clock_i = 0;
            dut.eval();
        }
    }

    // All pairs of these and their negatives.
    template <class Check>
    void each_pair(const Check& check) {
        const int values[] = {0, 1, -1, 2, -2, 7, -7, 10, -10, 100, -100, 127, -127, -128};
        for (const int a : values) {
            for (const int b : values) {
                dut.a_i = static_cast<std::uint8_t>(a);
                dut.b_i = static_cast<std::uint8_t>(b);
                dut.eval();
                SCOPED_TRACE(std::to_string(a) + " and " + std::to_string(b));
                check(a, b);
            }
        }
    }

    Vlpm_bench dut;
};

TEST_F(Lpm, CountsUpToAModulusAndDown) {
    clock(9);
    EXPECT_EQ(dut.decade_o, 9);
    EXPECT_TRUE(dut.decade_cout_o);
    EXPECT_EQ(dut.down_o, 7);
    EXPECT_FALSE(dut.down_cout_o);
    clock();
    EXPECT_EQ(dut.decade_o, 0);
    EXPECT_FALSE(dut.decade_cout_o);
    dut.up_i = 0;
    dut.eval();
    EXPECT_TRUE(dut.decade_cout_o);
    clock();
    EXPECT_EQ(dut.decade_o, 9);
    clock(5);
    EXPECT_EQ(dut.down_o, 0);
    EXPECT_TRUE(dut.down_cout_o);
    clock();
    EXPECT_EQ(dut.down_o, 15);
}

TEST_F(Lpm, CountsOnlyWhereItIsEnabled) {
    clock(2);
    dut.count_i = 0;
    clock();
    EXPECT_EQ(dut.decade_o, 2);
    dut.a_i = 6;
    dut.load_i = 1;
    dut.enable_i = 0;
    clock();
    EXPECT_EQ(dut.decade_o, 2);
    dut.enable_i = 1;
    clock();
    EXPECT_EQ(dut.decade_o, 6);  // without cnt_en
}

TEST_F(Lpm, ClearsAndSetsACounterInTheirOrder) {
    dut.a_i = 3;
    dut.load_i = dut.sset_i = dut.sclr_i = 1;
    clock();
    EXPECT_EQ(dut.decade_o, 0);
    dut.sclr_i = 0;
    clock();
    EXPECT_EQ(dut.decade_o, 5);
    dut.sset_i = 0;
    clock();
    EXPECT_EQ(dut.decade_o, 3);
    dut.aset_i = 1;
    dut.eval();
    EXPECT_EQ(dut.decade_o, 7);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.decade_o, 0);
}

TEST_F(Lpm, Multiplies) {
    each_pair([&](int a, int b) {
        EXPECT_EQ(dut.product_o, (a & 255) * (b & 255) + (a & 255));
        EXPECT_EQ(static_cast<std::int16_t>(dut.signed_product_o), a * b);
    });
}

TEST_F(Lpm, KeepsTheUpperBitsOfAProductAfterItsPipeline) {
    dut.a_i = dut.b_i = 255;
    clock();
    EXPECT_EQ(dut.top_product_o, 0);
    dut.a_i = 0;
    clock();
    EXPECT_EQ(dut.top_product_o, 254);
    dut.enable_i = 0;
    clock();
    EXPECT_EQ(dut.top_product_o, 254);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.top_product_o, 0);
}

TEST_F(Lpm, Divides) {
    each_pair([&](int a, int b) {
        if (b == 0 || (a == -128 && b == -1)) return;
        EXPECT_EQ(dut.quotient_o, (a & 255) / (b & 255));
        EXPECT_EQ(dut.remain_o, (a & 255) % (b & 255));
        EXPECT_EQ(static_cast<std::int8_t>(dut.signed_quotient_o), a / b);
        EXPECT_EQ(static_cast<std::int8_t>(dut.signed_remain_o), a % b);
        const int remain = (a % b + std::abs(b)) % std::abs(b);
        EXPECT_EQ(dut.rounded_remain_o, remain);
        EXPECT_EQ(static_cast<std::int8_t>(dut.rounded_quotient_o), (a - remain) / b);
    });
}

TEST_F(Lpm, AddsAndSubtracts) {
    for (dut.shiftin_i = 0; dut.shiftin_i < 2; ++dut.shiftin_i) {
        each_pair([&](int a, int b) {
            const int sum = a + b + dut.shiftin_i;
            EXPECT_EQ(dut.sum_o, sum & 255);
            EXPECT_EQ(dut.sum_cout_o, ((a & 255) + (b & 255) + dut.shiftin_i) >> 8);
            EXPECT_EQ(dut.sum_overflow_o, sum < -128 || sum > 127);
            EXPECT_EQ(dut.difference_o, (a - b) & 255);
            EXPECT_EQ(dut.difference_cout_o, (a & 255) >= (b & 255));
            EXPECT_EQ(dut.difference_overflow_o, a - b < -128 || a - b > 127);
        });
    }
    dut.shiftin_i = 0;
    dut.a_i = 20;
    dut.b_i = 30;
    clock();
    EXPECT_EQ(dut.either_o, 50);
    dut.up_i = 0;
    clock();
    EXPECT_EQ(dut.either_o, 246);
}

TEST_F(Lpm, Compares) {
    const auto bits = [](int a, int b) {
        return (a < b) | (a == b) << 1 | (a > b) << 2 | (a <= b) << 3 | (a != b) << 4 |
               (a >= b) << 5;
    };
    each_pair([&](int a, int b) {
        EXPECT_EQ(dut.compare_o, bits(a & 255, b & 255));
        EXPECT_EQ(dut.signed_compare_o, bits(a, b));
    });
}

TEST_F(Lpm, ShiftsBothWays) {
    dut.a_i = 0x81;
    dut.load_i = 1;
    clock();
    EXPECT_EQ(dut.left_o, 0x81);
    EXPECT_TRUE(dut.left_out_o && dut.right_out_o);
    dut.load_i = 0;
    dut.shiftin_i = 1;
    clock();
    EXPECT_EQ(dut.left_o, 0x03);
    EXPECT_EQ(dut.right_o, 0xC0);
    EXPECT_FALSE(dut.left_out_o || dut.right_out_o);
    dut.sset_i = 1;
    clock();
    EXPECT_EQ(dut.left_o, 0xFF);
    EXPECT_EQ(dut.right_o, 9);
    dut.sclr_i = 1;
    clock();
    EXPECT_EQ(dut.left_o, 0);
    dut.aset_i = 1;
    dut.eval();
    EXPECT_EQ(dut.left_o, 0xFF);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.left_o, 0);
}

TEST_F(Lpm, TogglesAndLoadsFlipFlops) {
    dut.a_i = 0x0F;
    clock();
    EXPECT_EQ(dut.toggle_o, 0x0F);
    dut.a_i = 0x3C;
    clock();
    EXPECT_EQ(dut.toggle_o, 0x33);
    dut.load_i = 1;
    clock();
    EXPECT_EQ(dut.toggle_o, 0x3C);
    dut.sset_i = 1;
    clock();
    EXPECT_EQ(dut.toggle_o, 0xFF);
    dut.sclr_i = 1;
    clock();
    EXPECT_EQ(dut.toggle_o, 0);
}

TEST_F(Lpm, HasConstantsAsNumbersAndAsTexts) {
    EXPECT_EQ(dut.constant_o, 173);
    EXPECT_EQ(dut.text_constant_o, 173);
}

TEST_F(Lpm, ChoosesAValueAndABit) {
    dut.a_i = 0x43;
    dut.b_i = 0x21;
    for (unsigned i = 0; i < 8; ++i) {
        dut.sel_i = i;
        dut.eval();
        EXPECT_EQ(dut.mux_o, i % 4 + 1);
        EXPECT_EQ(dut.decode_o, 1 << i);
    }
    dut.enable_i = 0;
    dut.eval();
    EXPECT_EQ(dut.decode_o, 0);
}

}  // namespace
