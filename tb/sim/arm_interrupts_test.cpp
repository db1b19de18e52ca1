// How interrupts reach the Cortex-A9, awake and asleep, by small programs (arm/interrupts.S).
#include <gtest/gtest.h>

#include "tb/sim/arm_system.h"

namespace {

using namespace tb::arm;
using sc_core::SC_NS;
using sc_core::sc_time;
using sc_core::SC_US;

using ArmInterrupts = tb::ArmTest;

// ---- Interrupts ---------------------------------------------------------------------------------

TEST_F(ArmInterrupts, TakeASelfSentIrqBeforeTheNextInstruction) {
    run_to_end("test_irq");
    EXPECT_EQ(record().vector, 6u);
    EXPECT_EQ(record().link, address_of("after_irq") + 4);
    EXPECT_EQ(record().cpsr & (MODE | I | F), IRQ_MODE | I | F);
    EXPECT_EQ(result(0), 3u) << "the ID";
    EXPECT_EQ(result(1), 99u) << "goes on where it was";
}

TEST_F(ArmInterrupts, TakesAnFiqWithBothMasked) {
    run_to_end("test_fiq");
    EXPECT_EQ(record().vector, 7u);
    EXPECT_EQ(record().cpsr & (MODE | I | F), FIQ_MODE | I | F);
}

TEST_F(ArmInterrupts, LetsAWaitingIrqInWhenItIsEnabled) {
    run_to_end("test_irq_when_let_in");
    EXPECT_EQ(result(2), 0u) << "while it was masked";
    EXPECT_EQ(result(0), 3u);
    const unsigned most = sim::ArmCore::TELLS_OF_MASKS ? 1 : 64 / 4 + 1;
    EXPECT_LE(result(1), most) << "turns of a loop of 4";
}

TEST_F(ArmInterrupts, TakesATimersIrqWithinAnInstructionOfItsTime) {
    load("test_busy_irq");
    run_ms(2);
    const sc_time taken = written();
    // The timer starts within the first microsecond and runs for a millisecond; the handler's
    // write is its third instruction.
    EXPECT_GT(taken, sc_time(1, sc_core::SC_MS));
    EXPECT_LT(taken, sc_time(1, sc_core::SC_MS) + sc_time(700, SC_NS));
}

// ---- Sleep --------------------------------------------------------------------------------------

TEST_F(ArmInterrupts, SleepsInWfiUntilTheInterrupt) {
    run_to_end("test_wfi");
    ASSERT_EQ(system->probe.writes.size(), 2u);
    EXPECT_LT(system->cpu.counts().instructions, 100u);
    EXPECT_EQ(system->cpu.counts().interrupts, 1u);
    EXPECT_GT(system->cpu.counts().asleep, sc_time(999, SC_US));
}

TEST_F(ArmInterrupts, WakesFromWfiByAnInterruptThatIsMasked) {
    load("test_wfi_masked");
    run_ms(2);
    ASSERT_EQ(system->probe.writes.size(), 1u);
    EXPECT_EQ(system->cpu.counts().interrupts, 0u);
    EXPECT_NEAR(system->probe.writes[0].second.to_seconds() * 1e3, 1.0, 0.001);
}

TEST_F(ArmInterrupts, GoesOnFromWfeWithoutAnInterrupt) {
    run_to_end("test_wfe");
    EXPECT_EQ(result(), 99u);
}

}  // namespace
