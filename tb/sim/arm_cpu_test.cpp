// The Cortex-A9 and its exceptions, time and interrupts, by small programs (arm/cpu_test.S).
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using sc_core::SC_NS;
using sc_core::sc_time;
using sc_core::SC_US;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint32_t NOBODY = 0x80000000;
constexpr std::uint32_t SVC_MODE = 0x13, IRQ_MODE = 0x12, FIQ_MODE = 0x11, ABT_MODE = 0x17,
                        UND_MODE = 0x1b, MODE = 0x1f, I = 0x80, F = 0x40, THUMB = 0x20;

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

TEST_F(ArmCpu, TellsProgramsWhereItsPrivatePeripheralsAre) {
    run_to_end("test_boot");
    EXPECT_EQ(result(5), 0xFFFEC000u);
}

TEST_F(ArmCpu, StartsThumbProgramsByTheEntrysLowestBit) {
    run_to_end("test_thumb_abort", true);
    EXPECT_EQ(record().spsr & THUMB, THUMB);
}

// ---- Exceptions ---------------------------------------------------------------------------------

TEST_F(ArmCpu, EntersTheUndefinedVectorWithTheNextAddress) {
    run_to_end("test_undefined");
    EXPECT_EQ(record().vector, 1u);
    EXPECT_EQ(record().link, address_of("test_undefined") + 4);
    EXPECT_EQ(record().cpsr & MODE, UND_MODE);
    EXPECT_EQ(result(), 99u) << "goes on behind it";
}

TEST_F(ArmCpu, EntersTheSvcVectorWithTheNextAddress) {
    run_to_end("test_svc");
    EXPECT_EQ(record().vector, 2u);
    EXPECT_EQ(record().link, address_of("test_svc") + 4);
    EXPECT_EQ(record().cpsr & MODE, SVC_MODE);
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmCpu, AbortsAReadThatNobodyAnswersWithItsAddressAndPc) {
    run_to_end("test_read_abort");
    EXPECT_EQ(record().vector, 4u);
    EXPECT_EQ(record().link, address_of("at_read_abort") + 8);
    EXPECT_EQ(record().cpsr & (MODE | I), ABT_MODE | I);
    EXPECT_EQ(record().spsr & MODE, SVC_MODE);
    EXPECT_EQ(record().status, 0x008u) << "synchronous external abort, read";
    EXPECT_EQ(record().address, NOBODY + 4);
}

TEST_F(ArmCpu, LeavesTheRegistersOfAnAbortedReadAsTheyWere) {
    run_to_end("test_read_abort");
    EXPECT_EQ(result(0), 42u) << "not loaded";
    EXPECT_EQ(result(1), NOBODY) << "no write-back";
}

TEST_F(ArmCpu, LeavesTheBaseOfAnAbortedMultipleReadAsItWas) {
    run_to_end("test_ldm_abort");
    EXPECT_EQ(record().link, address_of("at_ldm_abort") + 8);
    EXPECT_EQ(record().address, NOBODY);
    EXPECT_EQ(result(0), NOBODY);
    EXPECT_EQ(system->bus.counts().errors, 1u) << "the second word is not asked for";
}

TEST_F(ArmCpu, AbortsAWriteThatNobodyAnswersAndSaysThatItWasOne) {
    run_to_end("test_write_abort");
    EXPECT_EQ(record().link, address_of("at_write_abort") + 8);
    EXPECT_EQ(record().status, 0x808u);
    EXPECT_EQ(record().address, NOBODY + 7);
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmCpu, AbortsInThumbCodeWithTheSameLink) {
    run_to_end("test_thumb_abort", true);
    EXPECT_EQ(record().link, address_of("at_thumb_abort") + 8);
    EXPECT_EQ(record().cpsr & THUMB, 0u);
}

TEST_F(ArmCpu, LogsAnAbortInOneLineWithAddressPcAndFunction) {
    run_to_end("test_read_abort");
    char pc[32];
    std::snprintf(pc, sizeof pc, "PC 0x%08X in at_read_abort", address_of("at_read_abort"));
    ASSERT_EQ(system->log.size(), 1u);
    EXPECT_THAT(system->log[0], HasSubstr("data abort: read of 4 bytes at 0x80000004"));
    EXPECT_THAT(system->log[0], HasSubstr(pc));
}

TEST_F(ArmCpu, AbortsAFetchFromWhereNoMemoryIs) {
    run_to_end("test_prefetch_abort");
    EXPECT_EQ(record().vector, 3u);
    EXPECT_EQ(record().link, NOBODY + 4);
    EXPECT_EQ(record().status, 0x008u);
    EXPECT_EQ(record().address, NOBODY);
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmCpu, TakesABreakpointInstructionAsAPrefetchAbortOfItsOwnKind) {
    run_to_end("test_bkpt");
    EXPECT_EQ(record().vector, 3u);
    EXPECT_EQ(record().link, address_of("at_bkpt") + 4);
    EXPECT_EQ(record().status, 0x002u) << "debug event";
}

TEST_F(ArmCpu, FindsItsVectorsAtTheTopWhenToldSo) {
    run_to_end("test_high_vectors");
    EXPECT_EQ(record().vector, 2u);
}

TEST_F(ArmCpu, FailsAProgramWithoutTheVectorThatItNeeds) {
    load("test_no_vector");
    run_ms(1);
    EXPECT_THAT(system->cpu.fault().value_or(""), HasSubstr("supervisor call at 0.0"));
    EXPECT_THAT(system->cpu.fault().value_or(""), HasSubstr("no vector at 0x00200008"));
}

TEST_F(ArmCpu, FailsAProgramThatAbortsInItsAbortHandler) {
    load("test_abort_in_handler");
    run_ms(1);
    EXPECT_THAT(system->cpu.fault().value_or(""), HasSubstr("for the second time within its"));
}

TEST_F(ArmCpu, StartsAgainAtTheEntryAfterAWarmReset) {
    run_to_end("test_reset");
    EXPECT_EQ(result(), 2u);
    EXPECT_THAT(system->log, ElementsAre(HasSubstr("warm reset")));
}

TEST_F(ArmCpu, ReachesDevicesThroughItsTranslationTables) {
    run_to_end("test_mmu");
    EXPECT_EQ(system->probe.values[0], 0x1234u);
    EXPECT_EQ(result(0), 0x1234u);
}

TEST_F(ArmCpu, AbortsWhatTheTranslationTablesRefuse) {
    run_to_end("test_mmu");
    ASSERT_EQ(system->log.size(), 2u) << "a read and a fetch";
    EXPECT_THAT(system->log[0], HasSubstr("data abort"));
    EXPECT_THAT(system->log[0], HasSubstr("in at_mmu_abort"));
    EXPECT_EQ(result(1), NOBODY) << "no write-back";
    EXPECT_THAT(system->log[1], HasSubstr("prefetch abort"));
    EXPECT_EQ(system->bus.counts().errors, 0u);
}

// ---- Interrupts ---------------------------------------------------------------------------------

TEST_F(ArmCpu, TakesAnIrqThatItSendsItselfBeforeTheNextInstruction) {
    run_to_end("test_irq");
    EXPECT_EQ(record().vector, 6u);
    EXPECT_EQ(record().link, address_of("after_irq") + 4);
    EXPECT_EQ(record().cpsr & (MODE | I | F), IRQ_MODE | I | F);
    EXPECT_EQ(result(0), 3u) << "the ID";
    EXPECT_EQ(result(1), 99u) << "goes on where it was";
}

TEST_F(ArmCpu, TakesAnFiqWithBothMasked) {
    run_to_end("test_fiq");
    EXPECT_EQ(record().vector, 7u);
    EXPECT_EQ(record().cpsr & (MODE | I | F), FIQ_MODE | I | F);
}

TEST_F(ArmCpu, LetsAWaitingIrqInWithin64InstructionsOfItsBeingEnabled) {
    run_to_end("test_irq_when_let_in");
    EXPECT_EQ(result(2), 0u) << "while it was masked";
    EXPECT_EQ(result(0), 3u);
    EXPECT_LE(result(1), 64u / 4 + 1) << "turns of a loop of 4";
}

TEST_F(ArmCpu, TakesATimersIrqWithinAnInstructionOfItsTime) {
    load("test_busy_irq");
    run_ms(2);
    ASSERT_EQ(system->probe.writes.size(), 1u);
    const sc_time taken = system->probe.writes[0].second;
    // The timer starts within the first microsecond and runs for a millisecond; the handler's
    // write is its third instruction.
    EXPECT_GT(taken, sc_time(1, sc_core::SC_MS));
    EXPECT_LT(taken, sc_time(1, sc_core::SC_MS) + sc_time(700, SC_NS));
}

// ---- Sleep --------------------------------------------------------------------------------------

TEST_F(ArmCpu, SleepsInWfiUntilTheInterrupt) {
    run_to_end("test_wfi");
    ASSERT_EQ(system->probe.writes.size(), 2u);
    EXPECT_LT(system->cpu.counts().instructions, 100u);
    EXPECT_EQ(system->cpu.counts().interrupts, 1u);
    EXPECT_GT(system->cpu.counts().asleep, sc_time(999, SC_US));
}

TEST_F(ArmCpu, WakesFromWfiByAnInterruptThatIsMasked) {
    load("test_wfi_masked");
    run_ms(2);
    ASSERT_EQ(system->probe.writes.size(), 1u);
    EXPECT_EQ(system->cpu.counts().interrupts, 0u);
    EXPECT_NEAR(system->probe.writes[0].second.to_seconds() * 1e3, 1.0, 0.001);
}

TEST_F(ArmCpu, GoesOnFromWfeWithoutAnInterrupt) {
    run_to_end("test_wfe");
    EXPECT_EQ(result(), 99u);
}

// ---- Time ---------------------------------------------------------------------------------------

TEST_F(ArmCpu, TakesOneClockOf800MhzAnInstruction) {
    load("test_time");
    run_ms(1);
    // 1000 turns of two, and the store; the store's own access takes 10 ns.
    EXPECT_EQ(between_writes(), sc_time(2001 * 1.25 + 10, SC_NS));
}

TEST_F(ArmCpu, TakesTheClocksAnInstructionThatItIsTold) {
    load("test_time", 2.5);
    run_ms(1);
    EXPECT_EQ(between_writes(), sc_time(2001 * 2.5 * 1.25 + 10, SC_NS));
}

TEST_F(ArmCpu, SeesAPolledRegisterChangeAMicrosecondLateAtMost) {
    load("test_poll");
    sim::Alarm change{"change", [this] { system->probe.values[8] = 1; }};
    change.set(20'000'300);
    run_ms(1);
    ASSERT_EQ(system->probe.writes.size(), 1u);
    const sc_time late = system->probe.writes[0].second - sc_time(20'000'300, sc_core::SC_PS);
    EXPECT_LT(late, sc_time(1100, SC_NS));
}

TEST_F(ArmCpu, ReadsAPolledRegisterRarelyWhenNothingChanges) {
    load("test_poll");
    run_ms(10);
    EXPECT_LT(system->probe.reads, 10'100u);
    EXPECT_TRUE(system->cpu.position().polling);
    EXPECT_EQ(system->cpu.position().address, 0xFF200008u);
    EXPECT_THAT(system->cpu.position().function, HasSubstr("test_poll"));
}

TEST_F(ArmCpu, ReadsARunningCounterTenTimesAMicrosecondAtMost) {
    load("test_poll_counter");
    run_ms(1);
    EXPECT_LT(system->bus.counts().reads, 10'000u);
    EXPECT_GT(system->bus.counts().reads, 8'000u);
}

TEST_F(ArmCpu, SaysWhereAHangingProgramIs) {
    load("test_hang");
    run_ms(1);
    EXPECT_EQ(system->cpu.position().function, "test_hang");
    EXPECT_FALSE(system->cpu.position().polling);
    EXPECT_EQ(system->cpu.counts().instructions, 800'000u);
}

// ---- Those who look in --------------------------------------------------------------------------

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
    bool before(std::uint32_t pc) override { return pc == address && stopped_at.empty(); }
    std::uint64_t on_quantum(sim::ArmCore& core, std::uint64_t limit) override {
        if (core.pc() == address) stopped_at.push_back(core.reg(3));
        return limit;
    }
};

TEST_F(ArmCpu, StopsBeforeTheInstructionThatAProbeNames) {
    load("test_read_abort");
    Breakpoint breakpoint;
    breakpoint.address = address_of("at_read_abort");
    system->cpu.core().attach(&breakpoint);
    system->cpu.attach(&breakpoint);
    run_ms(1);
    EXPECT_THAT(breakpoint.stopped_at, ElementsAre(NOBODY));
    EXPECT_EQ(record().vector, 4u) << "and goes on";
}

}  // namespace
