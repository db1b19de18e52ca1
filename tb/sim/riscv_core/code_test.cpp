// Code that changes while it is there.
#include "tb/sim/riscv_core/bench.h"

namespace tb::riscv {

using namespace sim;

class RiscvCode : public RiscvBench {
protected:
    // Stores x1 over the instruction at 12, after `barrier`, and executes that.
    void rewrite(std::uint32_t barrier) {
        start({sw(1, 0, 12), barrier, NOP, addi(2, 0, 1), ECALL});
        core.set_reg(1, addi(2, 0, 2));
        core.run(100);
    }
};

TEST_F(RiscvCode, ThatWasWrittenIsSeenAfterFenceI) {
    rewrite(FENCE_I);
    EXPECT_EQ(core.reg(2), 2u);
}

TEST_F(RiscvCode, ThatADebuggerWritesIsSeenAtOnce) {
    start({addi(2, 0, 1), ECALL});
    core.run(100);
    start({addi(2, 0, 2), ECALL});
    core.run(100);
    EXPECT_EQ(core.reg(2), 2u);
}

TEST_F(RiscvCode, JumpsToAnotherPageAndBack) {
    start({addi(1, 0, 0x7FC), addi(1, 1, 0x7FC), addi(1, 1, 0x7FC), jalr(5, 1), ECALL});
    load(0x17F4, {addi(2, 0, 9), jalr(0, 5)});
    core.run(100);
    EXPECT_EQ(core.reg(2), 9u);
    EXPECT_EQ(core.pc(), 16u);
}

TEST_F(RiscvCode, RegisterZeroStaysZero) {
    start({addi(0, 0, 5), csrrs(0, riscv_csr::MISA, 0), lw(0, 0, 0), jalr(0, 1), NOP});
    core.set_reg(1, 16);
    core.run(4);
    EXPECT_EQ(core.reg(0), 0u);
}

}  // namespace tb::riscv
