// profile_test.cpp - --profile, and report.json's figures per frame.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;

class ProfileRun : public tb::CommandLine {
protected:
    const std::string path = folder / "callgrind.out";

    std::string profile_of(const std::string& elf, const std::string& steps) const {
        const tb::Outcome outcome =
            play(scenario(steps), {"--cpu", "arm", "--elf", elf, "--system", "linux", "--frames",
                                   "none", "--quiet", "--profile", path});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return folder.get("callgrind.out");
    }
    std::string counted(const std::string& name = "counted") const {
        return profile_of(LINUX_PROGRAMS + name, "duration: 1ms\n");
    }
};

class ProfileOfCounted : public ProfileRun, public ::testing::WithParamInterface<std::string> {};
INSTANTIATE_TEST_SUITE_P(As, ProfileOfCounted, ::testing::Values("counted", "counted_thumb"),
                         [](const auto& given) { return given.param; });

TEST_P(ProfileOfCounted, HasTheInstructionsOfEachFunction) {
    const std::string profile = counted(GetParam());
    EXPECT_THAT(profile, HasSubstr("events: Instructions\nsummary: 224\n"));
    EXPECT_EQ(report()["program"]["instructions"], 224);
    EXPECT_THAT(profile, ::testing::ContainsRegex("fn=\\([0-9]+\\) _start\n0 34\n"));
    EXPECT_THAT(profile, ::testing::ContainsRegex("fn=\\([0-9]+\\) outer\n0 150\n"));
    EXPECT_THAT(profile, ::testing::ContainsRegex("fn=\\([0-9]+\\) inner\n0 20\n"));
    EXPECT_THAT(profile, ::testing::ContainsRegex("fn=\\([0-9]+\\) last\n0 20\n"));
}

TEST_P(ProfileOfCounted, HasTheCallsWithAllThatTheyCost) {
    const std::string profile = counted(GetParam());
    EXPECT_THAT(profile, ::testing::ContainsRegex("\\) _start\n0 34\ncfn=\\([0-9]+\\) outer\n"
                                                  "calls=10 0\n0 190\n"));
    EXPECT_THAT(profile, ::testing::ContainsRegex("\\) outer\n0 150\ncfn=\\([0-9]+\\) inner\n"
                                                  "calls=10 0\n0 20\n"));
}

TEST_F(ProfileRun, IsReadByCallgrindAnnotate) {
    if (output_of("command -v callgrind_annotate").find('/') == std::string::npos)
        GTEST_SKIP() << "callgrind_annotate (valgrind) is not installed";
    counted();
    const std::string table = output_of("callgrind_annotate --inclusive=yes '" + path + "' 2>&1");
    EXPECT_THAT(table, ::testing::ContainsRegex("224 .*PROGRAM TOTALS"));
    EXPECT_THAT(table, ::testing::ContainsRegex("190 .*outer"));
}

TEST_F(ProfileRun, HasTheLibrariesOfADynamicallyLinkedProgram) {
    const std::string profile = profile_of(LINUX_PROGRAMS "hello_pie", "duration: 50ms\n");
    for (const char* library : {"ld-linux-armhf.so.3", "libc.so.6", "libstdc++.so.6"})
        EXPECT_THAT(profile, HasSubstr(std::string{"/"} + library + "\nfl=" + library + "\nfn=("));
    EXPECT_THAT(profile, ::testing::ContainsRegex("libc.so.6\nfl=[^\n]*\nfn=\\([0-9]+\\) exit\n"));
    EXPECT_THAT(profile,
                ::testing::ContainsRegex("cob=[^\n]*libc.so.6\ncfi=libc.so.6\ncfn=\\([0-9]+\\) "));
    EXPECT_THAT(profile, ::testing::ContainsRegex("fn=\\([0-9]+\\) main\n0 [1-9]"));
}

TEST_F(ProfileRun, DoesNotChangeTheRun) {
    const std::vector<std::string> arguments{"--cpu",   "arm",      "--elf", FIRMWARE "collide.elf",
                                             "--quiet", "--frames", "none"};
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), arguments.begin(), arguments.end());
        EXPECT_EQ(play(scenario("duration: 200ms\n"), more).exit_code, 0);
        nlohmann::json all = report();
        all.erase("wall");
        return all.dump();
    };
    EXPECT_EQ(run({}), run({"--profile", path}));
}

TEST_F(ProfileRun, ReportsInstructionsAndBusyTimeOfEachFrame) {
    const tb::Outcome outcome =
        play(scenario("duration: 500ms\n"), {"--cpu", "arm", "--elf", LINUX_PROGRAMS "frames",
                                             "--frames", "none", "--quiet", "--cpi", "2"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const nlohmann::json frames = report()["program"]["frames"];
    EXPECT_EQ(frames["count"], report()["frames"]["shown"].get<int>() - 1);
    // A frame is 800 * 525 clocks of 25 MHz, 16.8 ms: half of it the program sleeps.
    EXPECT_NEAR(frames["busy_share"]["median"].get<double>(), 0.5, 0.02);
    EXPECT_NEAR(frames["instructions"]["median"].get<double>(), 0.0084 * 400e6,
                0.0084 * 400e6 / 50);
}

}  // namespace
