// cli_trace_test.cpp - --trace records the program that was started, and no other.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class Trace : public tb::CommandLine {
protected:
    const std::filesystem::path trace = folder / "trace.fst";

    // The report without the host's time.
    nlohmann::json outcome_of(const std::string& program,
                              std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--frames", "none", "--quiet"});
        exit_code = play("s.yaml", arguments, {}, program).exit_code;
        nlohmann::json all = report();
        all.erase("wall");
        return all;
    }
    mutable int exit_code = -1;
};

TEST_F(Trace, OfFirmwareThatNeverSwapsIsOfThatFirmware) {
    scenario("duration: 60ms\n");
    const nlohmann::json plain = outcome_of(NEVER_SWAPS, {});
    EXPECT_EQ(outcome_of(NEVER_SWAPS, {"--trace", trace}), plain);
    EXPECT_EQ(file("console.txt"), "");  // the demo's firmware prints something
    EXPECT_TRUE(std::filesystem::exists(trace));
}

TEST_F(Trace, OfFirmwareThatFaultsFaultsAsItDoesWithout) {
    scenario("duration: 60ms\n");
    const nlohmann::json plain = outcome_of(BAD_ADDRESS, {});
    EXPECT_EQ(exit_code, 1);
    EXPECT_EQ(outcome_of(BAD_ADDRESS, {"--trace", trace}), plain);
    EXPECT_EQ(exit_code, 1);
    EXPECT_TRUE(std::filesystem::exists(trace));
}

// As the netlist's programs are: in one folder with the demo's tracing build.
TEST_F(Trace, IsRefusedByAProgramWithoutATracingBuild) {
    const std::filesystem::path lone = folder / "de1sim-lone";
    std::filesystem::copy_file(DE1SIM, lone);
    std::filesystem::copy_file(std::string{DE1SIM} + "-trace", folder / "de1sim-trace");
    const tb::Outcome outcome = play(scenario("duration: 20ms\n"), {"--trace", trace}, {}, lone);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
    EXPECT_THAT(outcome.err, HasSubstr("de1sim: --trace: de1sim-lone has no tracing build: " +
                                       lone.string() + "-trace: No such file or directory"));
    EXPECT_THAT(files(), IsEmpty());
    EXPECT_FALSE(std::filesystem::exists(trace));
}

}  // namespace
