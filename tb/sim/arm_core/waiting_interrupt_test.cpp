// A bus on which an interrupt waits, masked: what run() asks and tells it (ARM DDI 0406C, B1.8.13).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace waiting_interrupt {

using namespace tb::core;
using sim::ArmStop;

class WaitingInterrupt : public SystemTest {
protected:
    WaitingInterrupt() { bench.interrupt_waits = true; }
};

TEST_P(WaitingInterrupt, HasWfiGoOnWithoutLeavingTheTranslatedCode) {
    put(AT, {WFI, {0xEAFFFFFD, 0xE7FD}});  // B to the WFI
    set(15, AT);
    EXPECT_EQ(bench.core.run(1001), ArmStop::LIMIT);
    EXPECT_EQ(bench.core.instructions(), 1001u);
    EXPECT_EQ(bench.core.pc(), AT + (thumb() ? 2 : 4));
    bench.interrupt_waits = false;
    EXPECT_EQ(bench.core.run(1001), ArmStop::WFI);
    EXPECT_EQ(bench.core.instructions(), 1003u);
}

TEST_P(WaitingInterrupt, IsReportedByTheInstructionThatEnablesIt) {
    unsigned reported = 0;
    bench.on_unmasked = [&] { ++reported; };
    bench.interrupt_waits = false;
    become(SVC | I | F);
    reported = 0;
    done(CPSID_I);
    EXPECT_EQ(reported, 0u);
    done(CPSIE_I);
    EXPECT_EQ(reported, 1u);
    done(CPSIE_I);
    EXPECT_EQ(reported, 1u) << "nothing was masked";
    set(1, SVC | I);
    done(msr_cpsr(1));
    EXPECT_EQ(reported, 2u) << "F";
}

TEST_P(WaitingInterrupt, CanStopTheRunAfterThatInstruction) {
    bench.interrupt_waits = false;
    become(SVC | I | F);
    bench.on_unmasked = [&] { bench.core.stop_soon(); };
    put(CPSIE_I);
    set(15, AT);
    EXPECT_EQ(bench.core.run(1000), ArmStop::LIMIT);
    EXPECT_EQ(bench.core.pc(), AT + (thumb() ? 2 : 4));
    EXPECT_EQ(cpsr() & (I | F), F);
}

INSTANTIATE_TEST_SUITE_P(EachWay, WaitingInterrupt, EACH_WAY, name_of_way);

}  // namespace waiting_interrupt
