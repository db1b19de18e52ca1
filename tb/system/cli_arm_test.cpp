// cli_arm_test.cpp - de1sim --cpu arm: a program's own ELF against the real Verilog.
#include <gmock/gmock.h>

#include <array>

#include "sim/files/png.h"
#include "tb/system/cli.h"

namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::SizeIs;
using ::testing::StartsWith;

class ArmRun : public tb::CommandLine {
protected:
    tb::Outcome arm(const std::string& elf, const std::string& steps,
                    std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(), {"--cpu", "arm", "--elf", elf});
        return play(scenario(steps), arguments);
    }
    static std::array<unsigned, 3> pixel(const sim::Image& image, unsigned x, unsigned y) {
        const std::uint8_t* p = &image.rgb[(y * image.width + x) * 3];
        return {p[0], p[1], p[2]};
    }
    void refused(const tb::Outcome& outcome, const std::string& message) const {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_THAT(files(), IsEmpty());
    }
};

constexpr const char* TURN_SWITCHES =
    "steps:\n"
    "  - wait-serial: ready\n"
    "  - hold: {switch: [1, 3]}\n"
    "  - delay: 40ms\n"
    "  - expect-leds: \"0000001010\"\n"
    "  - release: {switch: [1]}\n"
    "  - delay: 1ms\n"
    "  - expect-leds: \"0000001000\"\n";

TEST_F(ArmRun, LightsLedsByTheSwitchesAndDrawsARectangle) {
    const tb::Outcome outcome = arm(LEDS_ELF, TURN_SWITCHES, {"--frames", "last"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(file("console.txt"), "ready\n");
    const sim::Image image = sim::read_png(out / frame(report()["frames"]["shown"]));
    const std::array<unsigned, 3> red{255, 0, 0}, black{0, 0, 0};
    EXPECT_EQ(pixel(image, 20, 40), red);
    EXPECT_EQ(pixel(image, 199, 119), red);
    EXPECT_EQ(pixel(image, 19, 40), black);
    EXPECT_EQ(pixel(image, 20, 39), black);
    EXPECT_EQ(pixel(image, 200, 119), black);
    EXPECT_EQ(pixel(image, 199, 120), black);
}

TEST_F(ArmRun, IsTheSameToTheByteEveryTime) {
    const auto once = [this] {
        EXPECT_EQ(arm(LEDS_ELF, TURN_SWITCHES).exit_code, 0);
        nlohmann::json all = report();
        all.erase("wall");
        std::string text = all.dump();
        for (const std::string& name : files())
            if (name != "report.json") text += name + file(name);
        return text;
    };
    const std::string first = once();
    EXPECT_TRUE(first == once());
    EXPECT_THAT(files(), IsSupersetOf({"audio.wav", "frames/frame_000001.png", "console.txt"}));
}

TEST_F(ArmRun, ReportsTheProgramItsInstructionsAndItsTime) {
    ASSERT_EQ(arm(LEDS_ELF, "duration: 20ms\n", {"--cpi", "2", "--frames", "none"}).exit_code, 0);
    const nlohmann::json report = this->report();
    EXPECT_EQ(report["cpu"], "arm");
    EXPECT_EQ(report["program"]["elf"], LEDS_ELF);
    EXPECT_EQ(report["program"]["cpi"], 2.0);
    // The whole time is instructions, 2.5 ns each, and waiting.
    const double instructions = report["program"]["instructions"];
    const double on_bus_s = report["program"]["on_bus_s"];
    EXPECT_NEAR(instructions * 2.5e-9 + on_bus_s, 0.02, 0.0001);
}

TEST_F(ArmRun, WakesByTheKeysInterruptAndCountsEachPressOnce) {
    const tb::Outcome outcome = arm(KEY_INTERRUPT_ELF,
                                    "steps:\n  - delay: 5ms\n"
                                    "  - expect-hex: \"     0\"\n"
                                    "  - press: {key: 1, for: 5ms}\n  - delay: 1ms\n"
                                    "  - expect-hex: \"     1\"\n"
                                    "  - press: {key: 0, for: 5ms}\n  - delay: 1ms\n"
                                    "  - press: {key: 1, for: 5ms}\n  - delay: 1ms\n"
                                    "  - expect-hex: \"     2\"\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(report()["program"]["interrupts"], 2u);
    EXPECT_LT(report()["program"]["instructions"], 500u) << "it sleeps";
    EXPECT_EQ(report()["program"]["at"]["waiting_for"], "an interrupt");
}

TEST_F(ArmRun, LogsAHandledAbortAndGoesOn) {
    const tb::Outcome outcome = arm(ABORTS_ELF,
                                    "steps:\n  - delay: 10ms\n  - press: {key: 0, for: 10ms}\n"
                                    "  - expect-leds: \"0000000001\"\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const nlohmann::json log = report()["log"]["first"];
    ASSERT_EQ(log.size(), 2u);
    EXPECT_THAT(log[0], HasSubstr("data abort: read of 4 bytes at 0xFFC00000"));
    EXPECT_THAT(log[0], HasSubstr(" in main"));
    EXPECT_THAT(log[1], HasSubstr("data abort: read of 4 bytes at 0xFF200040"))
        << "its bridge is in reset";
    EXPECT_EQ(report()["program"]["aborts"], 2u);
}

TEST_F(ArmRun, ReportsAnAbortThatHappensOftenOnceAndHowOften) {
    const tb::Outcome outcome = arm(ABORTS_OFTEN_ELF, "steps:\n  - wait-serial: done\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const nlohmann::json log = report()["log"]["first"];
    ASSERT_EQ(log.size(), 2u) << log;
    EXPECT_THAT(log[0], StartsWith("data abort: read of 4 bytes at 0xFFC00000"));
    EXPECT_EQ(log[1], "300 times in all: " + log[0].get<std::string>());
    EXPECT_EQ(report()["program"]["aborts"], 300u);
}

TEST_F(ArmRun, ReportsWhereAHangingProgramWaits) {
    const tb::Outcome outcome = arm(ABORTS_ELF, "duration: 30ms\nsteps:\n  - wait-serial: x\n");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr(" in main"));
    EXPECT_THAT(outcome.err, HasSubstr("waiting for a change of 0xFF200050"));
    const nlohmann::json at = report()["program"]["at"];
    EXPECT_THAT(at["function"], HasSubstr("main"));
    EXPECT_EQ(at["waiting_for"], "a change of 0xFF200050 (KEY_DATA)");
}

TEST_F(ArmRun, FailsAProgramThatAbortsWithoutAVector) {
    const tb::Outcome outcome = arm(NO_VECTORS_ELF, "duration: 1s\n", {"--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("data abort: read of 4 bytes at 0xFFC00000"));
    EXPECT_THAT(outcome.err, HasSubstr("in main_without_vectors"));
    EXPECT_THAT(outcome.err, HasSubstr("no vector at 0x00000010"));
    EXPECT_EQ(report()["end"], "firmware fault");
}

TEST_F(ArmRun, FailsSoonWhereAVectorSpinsForEver) {
    const tb::Outcome outcome =
        arm(DIES_ELF, "steps:\n  - expect-leds: {equals: 1023, timeout: 5s}\n");
    EXPECT_EQ(outcome.exit_code, 1);
    ASSERT_EQ(report()["faults"].size(), 1u);
    const std::string fault = report()["faults"][0];
    EXPECT_THAT(fault,
                ContainsRegex("^undefined instruction: udf #0 at .*; never left its handler: "
                              "at [0-9.]+ ms, PC 0x[0-9A-F]+ in [a-z_+0-9x]+$"));
    EXPECT_THAT(outcome.err, HasSubstr(fault));
    EXPECT_EQ(report()["log"]["lines"], 0u) << "it was said already";
    EXPECT_EQ(report()["end"], "firmware fault");
    EXPECT_LT(report()["simulated_s"], 0.2);
}

TEST_F(ArmRun, NeedsAProgram) {
    refused(play(scenario("duration: 1s\n"), {"--cpu", "arm"}),
            "--cpu: arm needs a program: --elf FILE");
}

TEST_F(ArmRun, RefusesAProgramThatIsNoneInOneLine) {
    folder.put("a.elf", "hello");
    refused(arm(folder / "a.elf", "duration: 1s\n"), "a.elf: is not a program (ELF file)");
    refused(arm("/bin/sh", "duration: 1s\n"), "sh: a 64-bit ELF file (x86-64, this computer's)");
    refused(arm(folder / "none.elf", "duration: 1s\n"), "none.elf: is not there");
}

TEST_F(ArmRun, RefusesNativeOptionsAndImpossibleClocks) {
    scenario("duration: 1s\n");
    refused(play("s.yaml", {"--cpu", "native", "--elf", LEDS_ELF}), "--elf: is for --cpu arm");
    refused(play("s.yaml", {"--cpi", "2"}), "--cpi: is for --cpu arm");
    refused(arm(LEDS_ELF, "duration: 1s\n", {"--ddr3-rate", "100"}),
            "--ddr3-rate: is for a project's design: expected --project, or a scenario with a "
            "project");
    for (const char* cpi : {"0", "-1", "1000", "nan", "one", "1e99"})
        refused(arm(LEDS_ELF, "duration: 1s\n", {"--cpi", cpi}), "--cpi");
}

}  // namespace
