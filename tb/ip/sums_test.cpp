// Sums of many numbers, squares, roots, shifts and words joined, by Intel's "Integer Arithmetic IP
// Cores User Guide" (683490) and LPM's own; the reference is C++'s arithmetic.

#include "Vsums_bench.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstdlib>
#include <random>

namespace {

class Sums : public testing::Test {
protected:
    Sums() {
        dut.enable_i = 1;
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
    void show(unsigned a) {
        dut.a_i = a & 0xFF'FFFF;
        dut.eval();
    }

    // Random words of 24 bits, and those at the limits.
    template <class Check>
    void each(const Check& check) {
        for (const unsigned a : {0u, 1u, 0x7Fu, 0x80u, 0xFFu, 0x80'8080u, 0x7F'7F7Fu, 0xFF'FFFFu,
                                 0xFFF'000u, 0xFFE'001u, 0x800u, 0xFF'80FFu, 0x7F'8080u}) {
            show(a);
            check(a);
        }
        std::mt19937 random{7};
        for (unsigned i = 0; i < 2000; ++i) {
            const unsigned a = random() & 0xFF'FFFF;
            show(a);
            check(a);
        }
    }

    Vsums_bench dut;
};

// Bits `lowest` to `lowest` + `width` - 1 of `word`, as a number with a sign.
int part(unsigned word, unsigned lowest, unsigned width) {
    const int value = static_cast<int>(word >> lowest & ((1u << width) - 1));
    return value >> (width - 1) ? value - (1 << width) : value;
}

TEST_F(Sums, AddUnsignedNumbers) {
    each([&](unsigned a) {
        const unsigned lower = (a & 0xFFF) + (a >> 12);
        const unsigned upper = (a & 0xFFF) + (a >> 12 & 0x3F) + ((a & 0x3F) << 6);
        EXPECT_EQ(dut.four_o, lower + upper);
        EXPECT_EQ(dut.low_o, ((a & 255) + (a >> 8 & 255) + (a >> 16)) & 255);
    });
}

TEST_F(Sums, SubtractTheLastOfSignedNumbers) {
    each([&](unsigned a) {
        EXPECT_EQ(part(dut.signed_o, 0, 10), part(a, 0, 8) + part(a, 8, 8) - part(a, 16, 8));
    });
}

TEST_F(Sums, ShiftEachNumberFartherThanTheOneBefore) {
    each([&](unsigned a) {
        EXPECT_EQ(static_cast<std::int16_t>(dut.wide_o),
                  part(a, 0, 4) + 2 * part(a, 4, 4) + 4 * part(a, 8, 4));
    });
}

TEST_F(Sums, KeepTheUpperBitsAfterTheirPipeline) {
    const auto top = [](unsigned a) { return ((a & 15) + (a & 0xF0) / 4 + (a & 0xF00) / 16) >> 2; };
    unsigned before = 0;
    each([&](unsigned a) {
        clock();
        EXPECT_EQ(dut.top_o, top(before));
        before = a & 0xFFF;
    });
    dut.enable_i = 0;
    const unsigned last = dut.top_o;
    show(0);
    clock(3);
    EXPECT_EQ(dut.top_o, last);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.top_o, 0);
}

TEST_F(Sums, Square) {
    each([&](unsigned a) {
        EXPECT_EQ(dut.square_o, (a & 0xFFF) * (a & 0xFFF));
        EXPECT_EQ(dut.signed_square_o, part(a, 0, 8) * part(a, 0, 8));
        clock();
        EXPECT_EQ(dut.top_square_o, (a & 255) * (a & 255) >> 12);
    });
}

TEST_F(Sums, FindTheRootAndWhatRemains) {
    each([&](unsigned a) {
        const unsigned root = dut.root_o;
        EXPECT_LE(root * root, a);
        EXPECT_GT((root + 1) * (root + 1), a);
        EXPECT_EQ(dut.remainder_o, a - root * root);
    });
}

TEST_F(Sums, FindARootOfAnOddNumberOfBitsThreeClocksLater) {
    for (unsigned a = 0; a < 128 + 2; ++a) {
        show(a % 128);
        clock();
        if (a < 2) continue;
        const unsigned root = dut.odd_root_o;
        EXPECT_LE(root * root, a - 2);
        EXPECT_GT((root + 1) * (root + 1), a - 2);
        EXPECT_EQ(dut.odd_remainder_o, a - 2 - root * root);
    }
}

TEST_F(Sums, TakeTheAbsoluteValue) {
    for (int a = -128; a < 128; ++a) {
        show(static_cast<unsigned>(a) & 255);
        EXPECT_EQ(dut.abs_o, std::abs(a));
        EXPECT_EQ(dut.abs_overflow_o, a == -128);
    }
}

TEST_F(Sums, JoinWordsBitByBit) {
    each([&](unsigned a) {
        EXPECT_EQ(dut.inv_o, ~a & 255);
        EXPECT_EQ(dut.and_o, a & a >> 8 & a >> 16 & 255);
        EXPECT_EQ(dut.or_o, (a | a >> 8 | a >> 16) & 255);
        EXPECT_EQ(dut.xor_o, (a ^ a >> 8 ^ a >> 16) & 255);
    });
}

TEST_F(Sums, LatchWhileTheGateIsOpen) {
    dut.gate_i = 1;
    show(0x5A);
    EXPECT_EQ(dut.latch_o, 0x5A);
    dut.gate_i = 0;
    show(0x11);
    EXPECT_EQ(dut.latch_o, 0x5A);
    dut.aset_i = 1;
    dut.eval();
    EXPECT_EQ(dut.latch_o, 77);
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.latch_o, 0);
}

TEST_F(Sums, ShiftAndSayWhatWasLost) {
    for (unsigned distance = 0; distance < 8; ++distance) {
        for (unsigned a = 0; a < 256; ++a) {
            const int sign = part(a, 0, 8);
            dut.distance_i = distance;
            dut.direction_i = 0;
            show(a);
            EXPECT_EQ(dut.logical_o, a << distance & 255);
            EXPECT_EQ(dut.logical_lost_o, a << distance > 255 ? 2 : 0);
            const int scaled = sign * (1 << distance);
            EXPECT_EQ(dut.arithmetic_o, scaled & 255);
            EXPECT_EQ(dut.arithmetic_lost_o, scaled < -128 || scaled > 127 ? 2 : 0);
            dut.direction_i = 1;
            dut.eval();
            EXPECT_EQ(dut.logical_o, a >> distance);
            EXPECT_EQ(dut.logical_lost_o, a % (1u << distance) != 0);
            EXPECT_EQ(dut.arithmetic_o, (sign >> distance) & 255);
            EXPECT_EQ(dut.arithmetic_lost_o, a % (1u << distance) != 0);
            clock();
            EXPECT_EQ(dut.later_o, a >> distance);
        }
    }
}

TEST_F(Sums, Rotate) {
    for (unsigned distance = 0; distance < 8; ++distance) {
        for (unsigned a = 0; a < 128; ++a) {
            unsigned left = a, right = a;
            for (unsigned i = 0; i < distance; ++i) {
                left = (left << 1 | left >> 6) & 127;
                right = right >> 1 | (right & 1) << 6;
            }
            dut.distance_i = distance;
            dut.direction_i = 0;
            show(a);
            EXPECT_EQ(dut.rotate_o, left);
            dut.direction_i = 1;
            dut.eval();
            EXPECT_EQ(dut.rotate_o, right);
        }
    }
}

TEST_F(Sums, DriveABusThatOthersDriveToo) {
    show(0x12'34);
    EXPECT_EQ(dut.bus_o, 0x34);
    EXPECT_EQ(dut.from_bus_o, 0x34);
    dut.drive_i = 1;
    dut.eval();
    EXPECT_EQ(dut.bus_o, 0x12);
    EXPECT_EQ(dut.from_bus_o, 0x12);
}

}  // namespace
