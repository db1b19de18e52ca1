// What the Cortex-A9 does at exceptions, by small programs (arm/exceptions.S).
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using namespace tb::arm;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using ArmExceptions = tb::ArmTest;

TEST_F(ArmExceptions, EntersTheUndefinedVectorWithTheNextAddress) {
    run_to_end("test_undefined");
    EXPECT_EQ(record().vector, 1u);
    EXPECT_EQ(record().link, address_of("test_undefined") + 4);
    EXPECT_EQ(record().cpsr & MODE, UND_MODE);
    EXPECT_EQ(result(), 99u) << "goes on after it";
}

TEST_F(ArmExceptions, EntersTheSvcVectorWithTheNextAddress) {
    run_to_end("test_svc");
    EXPECT_EQ(record().vector, 2u);
    EXPECT_EQ(record().link, address_of("test_svc") + 4);
    EXPECT_EQ(record().cpsr & MODE, SVC_MODE);
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmExceptions, AbortAnUnansweredReadWithAddressAndPc) {
    run_to_end("test_read_abort");
    EXPECT_EQ(record().vector, 4u);
    EXPECT_EQ(record().link, address_of("at_read_abort") + 8);
    EXPECT_EQ(record().cpsr & (MODE | I), ABT_MODE | I);
    EXPECT_EQ(record().spsr & MODE, SVC_MODE);
    EXPECT_EQ(record().status, 0x008u) << "synchronous external abort, read";
    EXPECT_EQ(record().address, NOBODY + 4);
}

TEST_F(ArmExceptions, LeavesTheRegistersOfAnAbortedReadAsTheyWere) {
    run_to_end("test_read_abort");
    EXPECT_EQ(result(0), 42u) << "not loaded";
    EXPECT_EQ(result(1), NOBODY) << "no write-back";
}

TEST_F(ArmExceptions, KeepTheBaseOfAnAbortedLdm) {
    run_to_end("test_ldm_abort");
    EXPECT_EQ(record().link, address_of("at_ldm_abort") + 8);
    EXPECT_EQ(record().address, NOBODY);
    EXPECT_EQ(result(0), NOBODY);
    EXPECT_EQ(system->bus.counts().errors, 1u) << "the second word is not asked for";
}

TEST_F(ArmExceptions, AbortAnUnansweredWriteAsAWrite) {
    run_to_end("test_write_abort");
    EXPECT_EQ(record().link, address_of("at_write_abort") + 8);
    EXPECT_EQ(record().status, 0x808u);
    EXPECT_EQ(record().address, NOBODY + 7);
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmExceptions, AbortsInThumbCodeWithTheSameLink) {
    run_to_end("test_thumb_abort", true);
    EXPECT_EQ(record().link, address_of("at_thumb_abort") + 8);
    EXPECT_EQ(record().cpsr & THUMB, 0u);
}

TEST_F(ArmExceptions, LogAnAbortWithAddressPcAndFunction) {
    run_to_end("test_read_abort");
    char pc[32];
    std::snprintf(pc, sizeof pc, "PC 0x%08X in at_read_abort", address_of("at_read_abort"));
    ASSERT_EQ(system->log.size(), 1u);
    EXPECT_THAT(system->log[0], HasSubstr("data abort: read of 4 bytes at 0x80000004"));
    EXPECT_THAT(system->log[0], HasSubstr(pc));
}

TEST_F(ArmExceptions, AbortsAFetchFromWhereNoMemoryIs) {
    run_to_end("test_prefetch_abort");
    EXPECT_EQ(record().vector, 3u);
    EXPECT_EQ(record().link, NOBODY + 4);
    EXPECT_EQ(record().status, 0x008u);
    EXPECT_EQ(record().address, NOBODY);
    EXPECT_EQ(result(), 99u);
}

TEST_F(ArmExceptions, ReportsWhereTheSecondHalfOfAnInstructionIsMissing) {
    run_to_end("test_half_prefetch_abort");
    EXPECT_EQ(record().vector, 3u);
    EXPECT_EQ(record().link, 0x3FFFFFFEu + 4);
    EXPECT_EQ(record().address, 0x40000000u);
}

TEST_F(ArmExceptions, TurnABreakpointIntoAPrefetchAbortWithDebugStatus) {
    run_to_end("test_bkpt");
    EXPECT_EQ(record().vector, 3u);
    EXPECT_EQ(record().link, address_of("at_bkpt") + 4);
    EXPECT_EQ(record().status, 0x002u) << "debug event";
}

TEST_F(ArmExceptions, FindsItsVectorsAtTheTopWithHighVectors) {
    run_to_end("test_high_vectors");
    EXPECT_EQ(record().vector, 2u);
}

TEST_F(ArmExceptions, FailsAProgramWithoutTheVectorThatItNeeds) {
    load("test_no_vector");
    run_ms(1);
    EXPECT_THAT(system->cpu.fault().value_or(""), HasSubstr("supervisor call at 0.0"));
    EXPECT_THAT(system->cpu.fault().value_or(""), HasSubstr("no vector at 0x00200008"));
}

class ArmSemihosting : public ArmExceptions {
protected:
    // Each request's r0 is answered with one more; returns how many there were.
    unsigned requests_of(const std::string& program) {
        load(program);
        unsigned requests = 0;
        system->cpu.set_semihosting([&](sim::ArmCore& core) {
            ++requests;
            core.set_reg(0, core.reg(0) + 1);
        });
        run_ms(1);
        EXPECT_EQ(system->cpu.fault(), std::nullopt);
        return requests;
    }
};

TEST_F(ArmSemihosting, IsARequestBySvc123456) {
    EXPECT_EQ(requests_of("test_semihosting"), 1u);
    EXPECT_EQ(result(), 43u);
}

TEST_F(ArmSemihosting, IsARequestBySvcAbInThumbCode) {
    EXPECT_EQ(requests_of("test_semihosting_in_thumb"), 1u);
    EXPECT_EQ(result(), 43u);
}

TEST_F(ArmSemihosting, IsNoOtherSupervisorCall) {
    EXPECT_EQ(requests_of("test_svc"), 0u);
    EXPECT_EQ(record().vector, 2u);
}

TEST_F(ArmSemihosting, IsASupervisorCallWhereNobodyAnswers) {
    load("test_semihosting");
    run_ms(1);
    EXPECT_EQ(record().vector, 2u);
}

TEST_F(ArmExceptions, FailsAProgramThatAbortsInItsAbortHandler) {
    load("test_abort_in_handler");
    run_ms(1);
    EXPECT_THAT(system->cpu.fault().value_or(""), HasSubstr("for the second time within its"));
}

TEST_F(ArmExceptions, StartsAgainAtTheEntryAfterAWarmReset) {
    run_to_end("test_reset");
    EXPECT_EQ(result(), 2u);
    EXPECT_THAT(system->log, ElementsAre(HasSubstr("warm reset")));
}

TEST_F(ArmExceptions, ReachesDevicesThroughItsTranslationTables) {
    run_to_end("test_mmu");
    EXPECT_EQ(system->probe.values[0], 0x1234u);
    EXPECT_EQ(result(0), 0x1234u);
}

TEST_F(ArmExceptions, AbortsWhatTheTranslationTablesRefuse) {
    run_to_end("test_mmu");
    ASSERT_EQ(system->log.size(), 2u) << "a read and a fetch";
    EXPECT_THAT(system->log[0], HasSubstr("data abort"));
    EXPECT_THAT(system->log[0], HasSubstr("in at_mmu_abort"));
    EXPECT_EQ(result(1), NOBODY) << "no write-back";
    EXPECT_THAT(system->log[1], HasSubstr("prefetch abort"));
    EXPECT_EQ(system->bus.counts().errors, 0u);
}

}  // namespace
