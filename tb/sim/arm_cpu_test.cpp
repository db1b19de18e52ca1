// The Cortex-A9 boots and takes its time, by small programs (arm/time.S).
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using namespace tb::arm;
using sc_core::SC_NS;
using sc_core::sc_time;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ArmCpu : public tb::ArmTest {
protected:
    // From one write of the probe's first register to the next.
    sc_time between_writes() const {
        const auto& writes = system->probe.writes;
        return writes.size() < 2 ? sc_core::SC_ZERO_TIME : writes[1].second - writes[0].second;
    }
};

// ---- Boot ---------------------------------------------------------------------------------------

TEST_F(ArmCpu, StartsInSvcModeWithInterruptsOffAndAStack) {
    run_to_end("test_boot");
    EXPECT_EQ(result(0 + 2), 0x40800000u) << "2.0f * 2.0f";
    EXPECT_EQ(system->cpu.core().cpsr() & (MODE | I | F), SVC_MODE | I | F);
    EXPECT_EQ(result(1), 6u) << "NEON: 3 + 3";
}

TEST_F(ArmCpu, FindsItsProgramAtTheSegmentsPhysicalAddresses) {
    for (sim::ElfSegment& segment : elf.segments) segment.address += 0x10000000;
    run_to_end("test_boot");
    EXPECT_EQ(result(1), 6u);
}

TEST_F(ArmCpu, GivesProgramsTheBaseOfItsPrivatePeripherals) {
    run_to_end("test_boot");
    EXPECT_EQ(result(5), 0xFFFEC000u);
}

TEST_F(ArmCpu, StartsThumbProgramsByTheEntrysLowestBit) {
    run_to_end("test_thumb_abort", true);
    EXPECT_EQ(record().spsr & THUMB, THUMB);
}

// ---- Time ---------------------------------------------------------------------------------------

TEST_F(ArmCpu, TakesOneClockOf800MhzAnInstruction) {
    load("test_time");
    run_ms(1);
    // 1000 turns of two, and the store; the store's own access takes 10 ns.
    EXPECT_EQ(between_writes(), sc_time(2001 * 1.25 + 10, SC_NS));
}

TEST_F(ArmCpu, SpendsTheClocksPerInstructionThatAreSet) {
    load("test_time", 2.5);
    run_ms(1);
    EXPECT_EQ(between_writes(), sc_time(2001 * 2.5 * 1.25 + 10, SC_NS));
}

TEST_F(ArmCpu, SeesAPolledRegisterChangeInTheNextRound) {
    load("test_poll");
    sim::Alarm change{"change", [this] { system->probe.values[8] = 1; }};
    change.set(20'000'300);
    run_ms(1);
    const sc_time late = written() - sc_time(20'000'300, sc_core::SC_PS);
    EXPECT_LT(late, sc_time(40, SC_NS));
}

TEST_F(ArmCpu, ReadsAPolledRegisterRarelyWhenNothingChanges) {
    load("test_poll");
    run_ms(10);
    EXPECT_LT(system->probe.reads, 500u);
    EXPECT_EQ(system->cpu.position().polled, 0xFF200008u);
    EXPECT_THAT(system->cpu.position().function, HasSubstr("test_poll"));
}

TEST_F(ArmCpu, CountsTheReadsThatItLeavesOut) {
    load("test_poll");
    run_ms(10);
    const std::uint64_t round_ps = 3 * 1250 + 10'000;  // of test_poll
    EXPECT_NEAR(static_cast<double>(system->bus.counts().reads) * round_ps, 10e9, 10e6);
    EXPECT_NEAR(static_cast<double>(system->cpu.counts().instructions) * round_ps, 30e9, 30e6);
}

TEST_F(ArmCpu, SeesTheEndOfAPolledTimerAtOnce) {
    load("test_poll_timer");
    run_ms(1);
    const sc_time waited = written();
    EXPECT_GE(waited, sc_time(20, sc_core::SC_US));
    EXPECT_LT(waited, sc_time(20'200, SC_NS));
}

TEST_F(ArmCpu, DoesNotCallAProgramWaitingThatHasGoneOn) {
    load("test_poll_and_hang");
    run_ms(1);
    EXPECT_EQ(system->bus.counts().reads, 100u);
    EXPECT_FALSE(system->cpu.position().polled);
}

TEST_F(ArmCpu, ReportsWhereAHangingProgramIs) {
    load("test_hang");
    run_ms(1);
    EXPECT_EQ(system->cpu.position().function, "test_hang");
    EXPECT_FALSE(system->cpu.position().polled);
    EXPECT_EQ(system->cpu.counts().instructions, 800'000u);
}

// ---- Inspectors ---------------------------------------------------------------------------------

struct Kernel : sim::ArmInspector {
    unsigned calls = 0;
    std::uint64_t longest = 0;
    void on_start(sim::ArmCore& core) override { core.set_reg(7, 1234); }
    std::uint64_t on_quantum(sim::ArmCore&, std::uint64_t limit) override {
        return longest ? std::min(limit, longest) : limit;
    }
    bool on_svc(sim::ArmCore& core) override {
        ++calls;
        EXPECT_EQ(core.reg(7), 1234u);
        return true;
    }
};

TEST_F(ArmCpu, LetsAnInspectorTakeASupervisorCall) {
    load("test_svc");
    Kernel kernel;
    system->cpu.attach(&kernel);
    run_ms(1);
    EXPECT_EQ(kernel.calls, 1u);
    EXPECT_EQ(record().vector, 0u) << "the program's own vector is not entered";
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmCpu, StepsByOneInstructionWithoutChangingTheResult) {
    load("test_time");
    Kernel kernel;
    kernel.longest = 1;
    system->cpu.attach(&kernel);
    run_ms(1);
    EXPECT_EQ(between_writes(), sc_time(2001 * 1.25 + 10, SC_NS));
}

struct Breakpoint : sim::ArmProbe, sim::ArmInspector {
    std::uint32_t address = 0;
    std::vector<std::uint32_t> stopped_at;
    bool before(std::uint32_t) override { return stopped_at.empty(); }
    std::uint64_t on_quantum(sim::ArmCore& core, std::uint64_t limit) override {
        if (core.pc() == address) stopped_at.push_back(core.reg(3));
        return limit;
    }
};

TEST_F(ArmCpu, StopsBeforeTheInstructionThatAProbeNames) {
    load("test_read_abort");
    Breakpoint breakpoint;
    breakpoint.address = address_of("at_read_abort");
    system->cpu.core().attach(&breakpoint, {breakpoint.address});
    system->cpu.attach(&breakpoint);
    run_ms(1);
    EXPECT_THAT(breakpoint.stopped_at, ElementsAre(NOBODY));
    EXPECT_EQ(record().vector, 4u) << "and goes on";
}

}  // namespace
