// How RiscvCore counts instructions and clocks, and where run() ends.
#include "tb/sim/riscv_core/bench.h"

namespace tb::riscv {

using namespace sim;
using namespace riscv_csr;

class RiscvCounting : public RiscvBench {};

TEST_F(RiscvCounting, RunEndsInTheMiddleOfStraightCode) {
    start(std::vector<std::uint32_t>(100, NOP));
    core.run(37);
    EXPECT_EQ(core.pc(), 37u * 4);
    EXPECT_EQ(core.instructions(), 37u);
}

TEST_F(RiscvCounting, RunGoesOnIntoTheNextPage) {
    start(std::vector<std::uint32_t>(3000, NOP));
    core.run(2500);
    EXPECT_EQ(core.pc(), 2500u * 4);
}

TEST_F(RiscvCounting, SeveralRunsCountAsOneDoes) {
    const std::vector<std::uint32_t> loop{addi(1, 1, 1), addi(2, 2, 3), jump(-8)};
    start(loop);
    core.run(10'000);
    const std::uint64_t instructions = core.instructions(), clocks = core.clocks();
    const std::uint32_t x1 = core.reg(1), pc = core.pc();
    RiscvCore other{*this};
    std::vector<std::uint8_t> ram(RAM);
    other.map_ram(0, RAM, ram.data());
    other.write_ram(0, loop.data(), 12);
    other.reset(0);
    while (other.clocks() < 10'000) other.run(std::min<std::uint64_t>(7, 10'000 - other.clocks()));
    EXPECT_EQ(other.instructions(), instructions);
    EXPECT_EQ(other.clocks(), clocks);
    EXPECT_EQ(other.reg(1), x1);
    EXPECT_EQ(other.pc(), pc);
}

TEST_F(RiscvCounting, StepDoesOneInstruction) {
    start({addi(1, 0, 5), addi(1, 1, 5)});
    core.step();
    EXPECT_EQ(core.reg(1), 5u);
    EXPECT_EQ(core.pc(), 4u);
}

TEST_F(RiscvCounting, DeviceSeesTheClocksBeforeItsAccess) {
    start({NOP, NOP, NOP, sw(0, 1, 0), NOP, NOP});
    core.set_reg(1, DEVICE);
    std::uint64_t seen = 0;
    on_access = [&] { seen = core.clocks(); };
    core.run(6);
    EXPECT_EQ(seen, 3u);
    EXPECT_EQ(core.clocks(), 6u);
}

TEST_F(RiscvCounting, RunEndsBehindAnAccessThatSaysSo) {
    start({NOP, sw(0, 1, 0), addi(2, 0, 1), NOP});
    core.set_reg(1, DEVICE);
    on_access = [&] { core.stop_soon(); };
    EXPECT_EQ(core.run(100), RiscvStop::LIMIT);
    EXPECT_EQ(core.pc(), 8u);
    EXPECT_EQ(core.instructions(), 2u);
}

TEST_F(RiscvCounting, AccessCanMakeTheRunLonger) {
    std::vector<std::uint32_t> code(100, NOP);
    code[1] = sw(0, 1, 0);
    start(code);
    core.set_reg(1, DEVICE);
    on_access = [&] { core.stop_after(50); };
    core.run(10);
    EXPECT_EQ(core.instructions(), 51u);
}

TEST_F(RiscvCounting, TrappedInstructionIsNotCounted) {
    start({NOP, NOP, ECALL});
    core.run(100);
    EXPECT_EQ(core.instructions(), 2u);
}

TEST_F(RiscvCounting, MinstretIsOfTheInstructionsBefore) {
    start({NOP, NOP, csrrs(1, MINSTRET, 0)});
    core.run(3);
    EXPECT_EQ(core.reg(1), 2u);
}

TEST_F(RiscvCounting, TakenBranchTakesLonger) {
    start({0x00000463, NOP, NOP, NOP});  // beq x0, x0, .+8
    core.run(2);
    EXPECT_EQ(core.clocks(), 2u);
    EXPECT_EQ(core.pc(), 8u);
}

// ---- A debugger's look at each ------------------------------------------------------------------

class RiscvProbed : public RiscvBench, protected RiscvProbe {
protected:
    bool before(std::uint32_t pc) override { return pc == stop_at; }
    bool touches(std::uint32_t address, unsigned, bool write) override {
        return write && address == watched;
    }

    std::uint32_t stop_at = 1, watched = 1;
};

TEST_F(RiscvProbed, RunEndsBeforeTheBreakpoint) {
    start({NOP, NOP, NOP});
    stop_at = 8;
    core.attach(this);
    EXPECT_EQ(core.run(100), RiscvStop::LIMIT);
    EXPECT_EQ(core.pc(), 8u);
}

TEST_F(RiscvProbed, StepPassesTheBreakpoint) {
    start({NOP, NOP});
    stop_at = 0;
    core.attach(this);
    core.step();
    EXPECT_EQ(core.pc(), 4u);
}

TEST_F(RiscvProbed, RunEndsBeforeTheStoreThatIsWatched) {
    start({addi(1, 0, 0x100), sw(1, 0, 0x100), NOP, NOP});
    watched = 0x100;
    core.attach(this);
    core.run(100);
    EXPECT_EQ(core.pc(), 4u);
    EXPECT_EQ(core.instructions(), 1u);
    std::uint32_t stored = 1;
    core.read_ram(0x100, &stored, sizeof stored);
    EXPECT_EQ(stored, 0u);
}

}  // namespace tb::riscv
