// Programs whose pc or stack goes where it cannot belong, and one without that (arm/astray.S).
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class AstrayProgram : public tb::ArmTest {
protected:
    AstrayProgram() : ArmTest{ASTRAY_TEST_ELF} {}

    std::string fault_of(const std::string& entry) {
        load(entry);
        run_ms(20);
        return system->cpu.fault().value_or("none");
    }
};

TEST_F(AstrayProgram, FailsInItsData) {
    EXPECT_THAT(fault_of("test_goes_into_data"),
                AllOf(HasSubstr("the program went into its data, .data, at 0."),
                      HasSubstr("PC 0x00020000"), HasSubstr("called from test_goes_into_data")));
}

TEST_F(AstrayProgram, FailsWhereItsDataIsNoInstruction) {
    EXPECT_THAT(
        fault_of("test_comes_to_a_wrong_instruction_in_data"),
        AllOf(HasSubstr("the program went into its data, .data, at 0."), HasSubstr("PC 0x00020004"),
              HasSubstr("called from test_comes_to_a_wrong_instruction_in_data; there: "
                        "undefined instruction: udf #3 at 0.")));
}

TEST_F(AstrayProgram, MayRunCodeThatIsInItsData) {
    EXPECT_EQ(fault_of("test_returns_from_its_data"), "none");
    EXPECT_TRUE(system->cpu.position().sleeping);
    EXPECT_THAT(system->log, ::testing::IsEmpty());
}

TEST_F(AstrayProgram, MayRunWhatItHasWrittenIntoItsData) {
    run_to_end("test_runs_what_it_has_written_into_its_data");
    EXPECT_EQ(system->cpu.core().reg(4), 5u);
    EXPECT_EQ(system->cpu.core().reg(5), 6u) << "written again";
}

TEST_F(AstrayProgram, MayRunWhatItHasWrittenOntoItsStack) {
    run_to_end("test_runs_what_it_has_written_onto_its_stack");
    EXPECT_EQ(system->cpu.core().reg(4), 5u);
    EXPECT_EQ(system->cpu.core().reg(5), 6u);
}

TEST_F(AstrayProgram, FailsAfterAThousandAbortsAtOnePlace) {
    EXPECT_THAT(fault_of("test_goes_back_to_its_abort"),
                AllOf(HasSubstr("data abort: read of 4 bytes at 0x80000000"),
                      HasSubstr("; its handler leads back to it, 1000 times")));
    EXPECT_EQ(system->cpu.counts().aborts, 1000u);
}

TEST_F(AstrayProgram, FailsWhenItsStackHasGrownIntoRegisters) {
    EXPECT_THAT(fault_of("test_stack_below_on_chip_ram"),
                HasSubstr("the stack has grown below its memory (SP 0xFFFEF"));
}

TEST_F(AstrayProgram, FailsWhenItsStackLeavesTheMemory) {
    load("test_stack_below_more_ram");
    run_ms(20);
    EXPECT_THAT(system->cpu.unfinished().value_or("none"),
                AllOf(HasSubstr("data abort: write of 4 bytes at 0xCFFFFF"),
                      HasSubstr("; the stack has grown below its memory (SP 0xD0000000)"),
                      HasSubstr("; never left its handler")));
}

TEST_F(AstrayProgram, FailsWhenItsStackHasGrownIntoItsCode) {
    EXPECT_THAT(fault_of("test_stack_into_code"),
                HasSubstr("the stack has grown into the program's code (SP 0x00010"));
}

TEST_F(AstrayProgram, MaySetItsStacksWhereItWants) {
    EXPECT_EQ(fault_of("test_stacks_that_are_in_their_place"), "none");
    EXPECT_TRUE(system->cpu.position().sleeping);
}

}  // namespace
