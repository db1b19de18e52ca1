// cli_fault_test.cpp - runs that do not end well: interrupted, out of disk, wrong firmware.
#include <gmock/gmock.h>

#include <cstdint>

#include "sim/files/png.h"
#include "tb/system/cli.h"

namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class FailingRun : public tb::CommandLine {
protected:
    // Every frame from the first on is there, and can be read to its end.
    void expect_whole_frames(unsigned count) const {
        for (unsigned number = 1; number <= count; ++number)
            EXPECT_EQ(sim::read_png(out / frame(number)).width, 640u);
        EXPECT_THAT(files(), Not(Contains(frame(count + 1))));
    }
};

TEST_F(FailingRun, InterruptedLeavesWholeFilesAndSaysSo) {
    tb::Command command;
    command.interrupt_when = [this] { return std::filesystem::exists(out / frame(6)); };
    const tb::Outcome outcome = play(scenario("duration: 1000s\n"), {"--frames", "all"}, command);
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_THAT(outcome.out, HasSubstr("interrupted"));
    EXPECT_TRUE(report()["interrupted"]);
    EXPECT_EQ(report()["end"], "interrupted");
    EXPECT_THAT(file("junit.xml"), HasSubstr("interrupted"));
    EXPECT_THAT(files(), Each(Not(EndsWith(".part"))));
    EXPECT_THAT(files(), Contains("audio.wav"));
    EXPECT_GE(report()["frames"]["shown"], 6u);
    expect_whole_frames(report()["frames"]["shown"]);
}

TEST_F(FailingRun, OnAFullDiskLeavesNothingHalfWritten) {
    scenario("duration: 300ms\n");
    const struct {
        std::uint64_t bytes;
        const char *frames, *stopped_at;
    } cases[] = {
        {1000, "all", "frame_000001.png"}, {1000, "last", ".png"}, {1000, "none", "audio.wav"}};
    for (const auto& c : cases) {
        tb::Command command;
        command.disk_full = c.bytes;
        const tb::Outcome outcome = play("s.yaml", {"--frames", c.frames}, command);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr(c.stopped_at));
        EXPECT_THAT(outcome.err, HasSubstr(": cannot write: "));
        EXPECT_THAT(files(), IsEmpty());
    }
}

TEST_F(FailingRun, OnADiskFullOfWaveformsLeavesNoHalfTrace) {
    scenario("duration: 60ms\n");
    tb::Command command;
    command.disk_full = 20'000;
    const std::filesystem::path trace = folder / "trace.fst";
    const tb::Outcome outcome =
        play("s.yaml", {"--quiet", "--frames", "none", "--trace", trace}, command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
    EXPECT_THAT(outcome.err, HasSubstr("trace.fst: cannot write: it was cut off"));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("trace.fst")));
}

TEST_F(FailingRun, WithoutASwapEndsAtItsDuration) {
    const tb::Outcome outcome =
        play(scenario("duration: 150ms\nsteps:\n  - delay: 100ms\n"), {}, {}, NEVER_SWAPS);
    EXPECT_EQ(outcome.exit_code, 0);  // the scenario has no expectations
    EXPECT_THAT(outcome.err, HasSubstr("the picture never changed: the firmware did not swap"));
    EXPECT_NEAR(report()["simulated_s"].get<double>(), 0.15, 1e-9);
    EXPECT_EQ(report()["frames"]["shown"], 8u);
    EXPECT_LE(report()["frames"]["swapped"], 1u);
}

TEST_F(FailingRun, WithoutASwapMissesTheExpectedSwap) {
    const tb::Outcome outcome = play(scenario("duration: 150ms\nsteps:\n"
                                              "  - wait-frame: 2\n"
                                              "  - wait-frame: {frame: next-swap, timeout: 50ms}\n"
                                              "  - wait-serial: ready\n"),
                                     {"--quiet"}, {}, NEVER_SWAPS);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err,
                HasSubstr("s.yaml:6: wait for the next new picture within 50ms: not met"));
    const nlohmann::json expectations = report()["expectations"];
    ASSERT_EQ(expectations.size(), 3u);
    EXPECT_TRUE(expectations[0]["met"]);
    EXPECT_FALSE(expectations[1]["met"]);
    EXPECT_FALSE(expectations[2]["met"]);
    EXPECT_EQ(expectations[2]["detail"], "the run ended before");
}

TEST_F(FailingRun, EndsAtAWrongAddressAndNamesIt) {
    const tb::Outcome outcome =
        play(scenario("duration: 1s\n"), {"--quiet", "--frames", "all"}, {}, BAD_ADDRESS);
    EXPECT_EQ(outcome.exit_code, 1);
    const std::string fault = "data abort: read of 4 bytes at 0xFFC00000 at 50.0";
    EXPECT_THAT(outcome.err, HasSubstr(fault));
    EXPECT_EQ(report()["end"], "firmware fault");
    EXPECT_FALSE(report()["passed"]);
    EXPECT_THAT(report()["faults"][0].get<std::string>(), HasSubstr(fault));
    EXPECT_EQ(report()["bus"]["errors"], 1u);
    EXPECT_THAT(file("junit.xml"), HasSubstr(fault));
    expect_whole_frames(report()["frames"]["shown"]);
}

TEST_F(FailingRun, WithAWrongPictureLeavesThreePictures) {
    const sim::Image black{640, 480, std::vector<std::uint8_t>(640 * 480 * 3)};
    sim::write_png(folder / "black.png", black);
    const tb::Outcome outcome =
        play(scenario("steps:\n  - delay: 100ms\n  - expect-frame: {equals: black.png}\n"),
             {"--frames", "all"});
    EXPECT_EQ(outcome.exit_code, 1);
    const std::string stem = (out / "mismatch/line5_black_").string();
    for (const char* what : {"actual", "expected", "difference"})
        EXPECT_THAT(outcome.err, HasSubstr(stem + what + ".png"));
    EXPECT_EQ(sim::read_png(stem + "expected.png"), black);
    const sim::Image actual = sim::read_png(stem + "actual.png");
    EXPECT_EQ(actual, sim::read_png(out / frame(report()["frames"]["shown"])));
    EXPECT_EQ(sim::read_png(stem + "difference.png"), sim::difference_image(black, actual));
    EXPECT_THAT(report()["expectations"][0]["detail"].get<std::string>(), HasSubstr(stem));
}

}  // namespace
