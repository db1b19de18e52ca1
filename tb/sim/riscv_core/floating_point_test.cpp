// Floating point of RISC-V: what Unicorn cannot be asked, and the style of Nios V.
#include "tb/sim/riscv_core/bench.h"

namespace tb::riscv {

using namespace sim;

namespace {

constexpr std::uint32_t ONE = 0x3F800000, QUIET = 0x7FC00000, SIGNALLING = 0x7F800001,
                        INFINITE = 0x7F800000, SMALLEST = 0x00000001, SMALL = 0x00800000,
                        HALF = 0x3F000000, ZERO = 0, MINUS_ZERO = 0x80000000;

}  // namespace

TEST(RiscvFpu, LowerOfANumberAndASignallingNanIsTheNumber) {
    RiscvFpu fpu{RiscvFpu::Style::IEEE};
    EXPECT_EQ(fpu.lower(ONE, SIGNALLING), ONE);
    EXPECT_EQ(fpu.flags, RiscvFpu::INVALID);
}

TEST(RiscvFpu, HigherOfTwoNansIsTheCanonicalOne) {
    RiscvFpu fpu{RiscvFpu::Style::IEEE};
    EXPECT_EQ(fpu.higher(0xFFC12345, 0x7FC00001), QUIET);
    EXPECT_EQ(fpu.flags, 0u);
}

TEST(RiscvFpu, MinusZeroIsLowerThanZero) {
    RiscvFpu fpu{RiscvFpu::Style::IEEE};
    EXPECT_EQ(fpu.lower(ZERO, MINUS_ZERO), MINUS_ZERO);
    EXPECT_EQ(fpu.higher(MINUS_ZERO, ZERO), ZERO);
}

TEST(RiscvFpu, InfinityTimesZeroIsInvalidThoughANanIsAdded) {
    RiscvFpu fpu{RiscvFpu::Style::IEEE};
    EXPECT_EQ(fpu.fused(INFINITE, ZERO, QUIET, RiscvFpu::NEAREST), QUIET);
    EXPECT_EQ(fpu.flags, RiscvFpu::INVALID);
}

TEST(NiosVFpu, SubnormalOperandCountsAsZero) {
    RiscvFpu fpu{RiscvFpu::Style::NIOS_V};
    EXPECT_EQ(fpu.add(SMALLEST, SMALLEST, RiscvFpu::NEAREST), ZERO);
}

TEST(NiosVFpu, SubnormalResultIsZero) {
    RiscvFpu fpu{RiscvFpu::Style::NIOS_V};
    EXPECT_EQ(fpu.multiply(SMALL, HALF, RiscvFpu::NEAREST), ZERO);
}

// (1 + 2^-12)^2 - (1 + 2^-11) is 2^-24, which a product that is rounded has lost.
TEST(NiosVFpu, FusedProductIsRoundedFirst) {
    constexpr std::uint32_t A = 0x3F800800, C = 0xBF801000;
    RiscvFpu ieee{RiscvFpu::Style::IEEE}, nios{RiscvFpu::Style::NIOS_V};
    EXPECT_EQ(ieee.fused(A, A, C, RiscvFpu::NEAREST), 0x33800000u);
    EXPECT_EQ(nios.fused(A, A, C, RiscvFpu::NEAREST), ZERO);
}

TEST(NiosVFpu, OtherRoundingModeInFrmIsIllegal) {
    struct : RiscvBus {
        bool read(std::uint32_t, unsigned, std::uint32_t&) override { return false; }
        bool write(std::uint32_t, unsigned, std::uint32_t) override { return false; }
        std::uint64_t cycles() override { return 0; }
    } bus;
    RiscvCore core{bus, RiscvFpu::Style::NIOS_V};
    EXPECT_FALSE(core.set_csr(riscv_csr::FRM, RiscvFpu::TO_ZERO));
    EXPECT_TRUE(core.set_csr(riscv_csr::FRM, RiscvFpu::NEAREST));
}

}  // namespace tb::riscv
