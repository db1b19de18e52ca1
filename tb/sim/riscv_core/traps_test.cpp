// Traps of RiscvCore: what mcause, mtval and mepc are, as the Nios V Processor Reference Manual has
// it ("mtval value After Exception"), and interrupts.
#include "tb/sim/riscv_core/bench.h"

namespace tb::riscv {

using namespace sim;
using namespace riscv_csr;

class RiscvTraps : public RiscvBench {
protected:
    // Runs `words` from address 0 with x1 = `x1`; the trap that comes is at `at`.
    void expect_trap(const std::vector<std::uint32_t>& words, std::uint32_t x1, std::uint32_t cause,
                     std::uint32_t value, std::uint32_t at) {
        start(words);
        core.set_reg(1, x1);
        ASSERT_EQ(core.run(100), RiscvStop::TRAP);
        core.enter(core.trap());
        EXPECT_EQ(csr(MCAUSE), cause);
        EXPECT_EQ(csr(MTVAL), value);
        EXPECT_EQ(csr(MEPC), at);
    }
};

TEST_F(RiscvTraps, IllegalInstructionIsInMtval) {
    expect_trap({NOP, 0xFFFFFFFF}, 0, 2, 0xFFFFFFFF, 4);
}

TEST_F(RiscvTraps, CompressedInstructionIsIllegal) {
    expect_trap({NOP, 0x00010001}, 0, 2, 0x00010001, 4);
}

TEST_F(RiscvTraps, CsrThatIsNotThereIsIllegal) {
    expect_trap({csrrs(2, 0x3A0, 0)}, 0, 2, csrrs(2, 0x3A0, 0), 0);
}

TEST_F(RiscvTraps, WritingAReadOnlyCsrIsIllegal) {
    expect_trap({csrrw(2, MHARTID, 1)}, 0, 2, csrrw(2, MHARTID, 1), 0);
}

TEST_F(RiscvTraps, BreakpointHasItsOwnAddressInMtval) { expect_trap({NOP, EBREAK}, 0, 3, 4, 4); }

TEST_F(RiscvTraps, EnvironmentCallIsElevenWithZero) { expect_trap({NOP, ECALL}, 0, 11, 0, 4); }

TEST_F(RiscvTraps, UnalignedLoadIsFour) { expect_trap({NOP, lw(2, 1, 0)}, 0x102, 4, 0x102, 4); }

TEST_F(RiscvTraps, UnalignedStoreIsSix) { expect_trap({NOP, sw(2, 1, 0)}, 0x101, 6, 0x101, 4); }

TEST_F(RiscvTraps, LoadThatNobodyAnswersIsFive) {
    expect_trap({NOP, lw(2, 1, 0)}, NOBODY, 5, NOBODY, 4);
}

TEST_F(RiscvTraps, StoreThatNobodyAnswersIsSeven) {
    expect_trap({NOP, sw(2, 1, 0)}, NOBODY, 7, NOBODY, 4);
}

TEST_F(RiscvTraps, FetchWithoutMemoryIsOneAtItsTarget) {
    expect_trap({jalr(0, 1)}, NOBODY, 1, NOBODY, NOBODY);
}

TEST_F(RiscvTraps, JumpToHalfAWordIsZeroAtTheJump) {
    expect_trap({NOP, jalr(0, 1)}, 0x102, 0, 0x102, 4);
}

TEST_F(RiscvTraps, BranchToHalfAWordIsZeroAtTheBranch) {
    expect_trap({NOP, jump(0x102)}, 0, 0, 0x106, 4);
}

TEST_F(RiscvTraps, TrappedLoadLeavesItsRegister) {
    expect_trap({addi(2, 0, 7), lw(2, 1, 0)}, NOBODY, 5, NOBODY, 4);
    EXPECT_EQ(core.reg(2), 7u);
}

// ---- Interrupts ---------------------------------------------------------------------------------

class RiscvInterrupts : public RiscvBench {
protected:
    void enable(std::uint32_t lines, std::uint32_t mtvec = 0x1000) {
        core.set_csr(MIE, lines);
        core.set_csr(MTVEC, mtvec);
        core.set_csr(MSTATUS, riscv_mstatus::MIE);
    }
    std::uint32_t taken() {
        const auto trap = core.pending_interrupt();
        return trap ? trap->cause & 31 : 0;
    }
};

TEST_F(RiscvInterrupts, AreNotTakenWhileMasked) {
    core.set_csr(MIE, 1u << 18);
    core.set_pending(1u << 18);
    EXPECT_EQ(taken(), 0u);
    core.set_csr(MSTATUS, riscv_mstatus::MIE);
    EXPECT_EQ(taken(), 18u);
}

TEST_F(RiscvInterrupts, OfThePlatformComeLowestFirst) {
    enable(0xFFFF0088);
    core.set_pending(1u << 7 | 1u << 18 | 1u << 22);
    EXPECT_EQ(taken(), 18u);
}

TEST_F(RiscvInterrupts, OfSoftwareComesBeforeTheTimers) {
    enable(0xFFFF0088);
    core.set_pending(1u << 7 | 1u << 3);
    EXPECT_EQ(taken(), 3u);
}

TEST_F(RiscvInterrupts, EndTheRunBehindTheInstructionThatUnmasksThem) {
    start({NOP, csrrw(0, MSTATUS, 1), NOP});
    core.set_csr(MIE, 1u << 16);
    core.set_pending(1u << 16);
    core.set_reg(1, riscv_mstatus::MIE);
    EXPECT_EQ(core.run(100), RiscvStop::LIMIT);
    EXPECT_EQ(core.pc(), 8u);
}

TEST_F(RiscvInterrupts, AreMaskedInTheHandlerAndAgainAfterMret) {
    start({NOP});
    enable(1u << 16);
    load(0x1000, {MRET});
    core.enter({riscv_cause::INTERRUPT | 16, 0});
    EXPECT_EQ(csr(MSTATUS) & riscv_mstatus::MIE, 0u);
    EXPECT_EQ(core.pc(), 0x1000u);
    core.step();
    EXPECT_EQ(core.pc(), 0u);
    EXPECT_NE(csr(MSTATUS) & riscv_mstatus::MIE, 0u);
}

TEST_F(RiscvInterrupts, GoToTheirVectorWhereMtvecIsVectored) {
    enable(1u << 18, 0x1000 | 1);
    core.enter({riscv_cause::INTERRUPT | 18, 0});
    EXPECT_EQ(core.pc(), 0x1000u + 4 * 18);
}

TEST_F(RiscvInterrupts, OtherTrapsGoToTheBaseOfAVectoredMtvec) {
    enable(0, 0x1000 | 1);
    core.enter({riscv_cause::ECALL, 0});
    EXPECT_EQ(core.pc(), 0x1000u);
}

TEST_F(RiscvInterrupts, PendingAndMaskedLetWfiPass) {
    start({WFI, NOP, ECALL});
    core.set_csr(MIE, 1u << 18);
    core.set_pending(1u << 18);
    EXPECT_EQ(core.run(100), RiscvStop::TRAP);
}

TEST_F(RiscvInterrupts, ThatAreNotEnabledLeaveWfiWaiting) {
    start({WFI, NOP, ECALL});
    core.set_pending(1u << 18);
    EXPECT_EQ(core.run(100), RiscvStop::WFI);
    EXPECT_EQ(core.pc(), 4u);
}

TEST_F(RiscvInterrupts, CannotBeClearedInMip) {
    core.set_pending(1u << 18);
    core.set_csr(MIP, 0);
    EXPECT_EQ(csr(MIP), 1u << 18);
}

}  // namespace tb::riscv
