// cli_output_test.cpp - the files that de1sim writes, and its messages.
#include <gmock/gmock.h>
#include <sndfile.h>

#include "sim/files/png.h"
#include "sim/files/sha256.h"
#include "tb/system/cli.h"

namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

using Names = std::set<std::string>;

// The monitor's n-th frame is whole where n + 1 begins, 16.8 ms each: five in 100 ms.
constexpr unsigned FRAMES_IN_100_MS = 5;

class CommandLineRun : public tb::CommandLine {
protected:
    Names frame_files() const {
        Names names;
        for (const std::string& name : files())
            if (name.rfind("frames/", 0) == 0) names.insert(name);
        return names;
    }
    // The report's bytes without the host's time, which comes last.
    std::string report_of_the_run() const {
        const std::string all = file("report.json");
        const std::size_t wall = all.find("\"wall\":");
        EXPECT_NE(wall, std::string::npos);
        return all.substr(0, wall);
    }
};

TEST_F(CommandLineRun, OfHelpNamesEveryOptionAndTheExitCodes) {
    const tb::Outcome help = de1sim({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_THAT(help.out, HasSubstr("Exit code: 0 all expectations met"));
    const tb::Outcome run_help = de1sim({"run", "--help"});
    EXPECT_EQ(run_help.exit_code, 0);
    for (const char* option :
         {"--cpu", "--out", "--frames", "--duration", "--seed", "--trace", "--quiet"})
        EXPECT_THAT(run_help.out, HasSubstr(option));
}

TEST_F(CommandLineRun, OfVersionIsOneLine) {
    const tb::Outcome version = de1sim({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_THAT(version.out,
                MatchesRegex("de1sim [0-9]+\\.[0-9]+\\.[0-9]+ \\((commit [0-9a-f]+(-dirty)?, )?"
                             "[a-z]+ for the ARM(, .*)?\\)\n"));
}

TEST_F(CommandLineRun, WritesTheFilesThatItPromisesAndNoOthers) {
    EXPECT_EQ(play(scenario("duration: 100ms\n"), {"--frames", "all"}).exit_code, 0);
    Names expected{"audio.wav", "console.txt", "junit.xml", "report.json"};
    for (unsigned number = 1; number <= FRAMES_IN_100_MS; ++number) expected.insert(frame(number));
    EXPECT_EQ(files(), expected);
    EXPECT_EQ(file("console.txt"), "ready\r\n");

    SF_INFO sound{};
    SNDFILE* wav = sf_open((out / "audio.wav").c_str(), SFM_READ, &sound);
    ASSERT_TRUE(wav) << sf_strerror(nullptr);
    sf_close(wav);
    EXPECT_EQ(sound.format, SF_FORMAT_WAV | SF_FORMAT_PCM_16);
    EXPECT_EQ(sound.channels, 2);
    EXPECT_EQ(sound.samplerate, 8000);
    EXPECT_EQ(sound.frames, report()["audio"]["samples"]);
}

TEST_F(CommandLineRun, PlaysAtTheRateThatWasChosen) {
    scenario("duration: 100ms\n");
    EXPECT_EQ(play("s.yaml", {"--frames", "none", "--audio-rate", "48000"}).exit_code, 0);
    EXPECT_NEAR(report()["audio"]["rate_hz"], 48'000, 0.01);
    EXPECT_NEAR(report()["audio"]["samples"], 4'800, 2);
    SF_INFO sound{};
    SNDFILE* wav = sf_open((out / "audio.wav").c_str(), SFM_READ, &sound);
    ASSERT_TRUE(wav) << sf_strerror(nullptr);
    sf_close(wav);
    EXPECT_EQ(sound.samplerate, 48'000);
}

TEST_F(CommandLineRun, WritesTheFramesThatWereChosen) {
    scenario("duration: 100ms\n");
    Names all;
    for (unsigned number = 1; number <= FRAMES_IN_100_MS; ++number) all.insert(frame(number));
    EXPECT_EQ(play("s.yaml", {"--frames", "all"}).exit_code, 0);
    EXPECT_EQ(frame_files(), all);
    EXPECT_EQ(play("s.yaml", {"--frames", "every:2"}).exit_code, 0);
    EXPECT_EQ(frame_files(), (Names{frame(2), frame(4)}));
    EXPECT_EQ(play("s.yaml", {"--frames", "last"}).exit_code, 0);
    EXPECT_EQ(frame_files(), Names{frame(FRAMES_IN_100_MS)});
    EXPECT_EQ(play("s.yaml", {"--frames", "none"}).exit_code, 0);
    EXPECT_EQ(frame_files(), Names{});
}

TEST_F(CommandLineRun, RemovesAnEarlierRunsFilesButNobodyElses) {
    scenario("duration: 100ms\n");
    for (const char* name : {"frames", "mismatch"}) std::filesystem::create_directories(out / name);
    const Names old{frame(99), "audio-2.wav", "mismatch/line7_a_actual.png"};
    const Names others{"frames/frame_1.png", "frames/holiday.png", "notes.txt", "audio.mp3"};
    for (const Names& names : {old, others})
        for (const std::string& name : names) folder.put("out/" + name, "old");
    EXPECT_EQ(play("s.yaml").exit_code, 0);
    EXPECT_THAT(files(), IsSupersetOf(others));
    for (const std::string& name : old) EXPECT_THAT(files(), Not(Contains(name)));
}

TEST_F(CommandLineRun, EndsAtTheDurationOfTheCommandLine) {
    const tb::Outcome outcome = play(scenario("duration: 1000s\nsteps:\n  - delay: 900s\n"),
                                     {"--duration", "70ms", "--frames", "none"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_DOUBLE_EQ(report()["simulated_s"], 0.07);
    EXPECT_EQ(report()["end"], "duration reached");
}

// A key pressed just before the program looks: whether it is seen in that frame or in the next
// depends on how long its contact bounces, hence on the seed.
constexpr const char* KEY_PRESS =
    "steps:\n  - delay: 58.5ms\n  - press: {keypad: \"1\", for: 30ms}\n  - delay: 60ms\n";

TEST_F(CommandLineRun, IsTheSameByteForByteASecondTime) {
    scenario(KEY_PRESS);
    EXPECT_EQ(play("s.yaml").exit_code, 0);
    const std::string first_report = report_of_the_run();
    std::map<std::string, std::string> first;
    for (const std::string& name : files()) first[name] = file(name);
    EXPECT_EQ(play("s.yaml").exit_code, 0);
    EXPECT_EQ(report_of_the_run(), first_report);
    EXPECT_EQ(files().size(), first.size());
    first.erase("report.json");
    for (const auto& [name, bytes] : first) EXPECT_TRUE(file(name) == bytes) << name;
}

TEST_F(CommandLineRun, ReportsTheHashOfEachNewPictureByItsFrame) {
    scenario(KEY_PRESS);
    EXPECT_EQ(play("s.yaml").exit_code, 0);
    const nlohmann::json run = report();
    std::map<std::string, std::string> reported;
    for (const auto& [number, hash] : run["frames"]["pictures"].items())
        reported[frame(static_cast<unsigned>(std::stoul(number)))] = hash;
    std::map<std::string, std::string> written;
    for (const std::string& name : frame_files())
        written[name] = sim::sha256_hex(sim::read_png(out / name).rgb);
    EXPECT_GT(written.size(), 1u);
    EXPECT_EQ(reported, written);
}

TEST_F(CommandLineRun, BouncesTheKeysByTheSeed) {
    scenario(KEY_PRESS);
    const auto last_picture = [this](const char* seed) {
        EXPECT_EQ(play("s.yaml", {"--frames", "none", "--seed", seed}).exit_code, 0);
        EXPECT_EQ(report()["seed"], std::stoul(seed));
        return report()["frames"]["last_sha256"].get<std::string>();
    };
    EXPECT_NE(last_picture("1"), last_picture("2"));
}

TEST_F(CommandLineRun, WithATraceGivesTheSameFilesAndAnFst) {
    scenario("duration: 100ms\n");
    EXPECT_EQ(play("s.yaml", {"--frames", "last"}).exit_code, 0);
    const std::string picture = file(frame(FRAMES_IN_100_MS));
    const std::string untraced = report_of_the_run();

    const std::filesystem::path trace = folder / "trace.fst";
    EXPECT_EQ(play("s.yaml", {"--frames", "last", "--trace", trace}).exit_code, 0);
    EXPECT_TRUE(file(frame(FRAMES_IN_100_MS)) == picture);
    EXPECT_EQ(report_of_the_run(), untraced);
    // A header block: type 0, and its length of 329 bytes.
    EXPECT_EQ(folder.get("trace.fst").substr(0, 9), std::string("\0\0\0\0\0\0\0\1\x49", 9));
    if (output_of("command -v fst2vcd").find("exit") == std::string::npos) {
        EXPECT_THAT(output_of("fst2vcd '" + trace.string() + "' | head -c 100000"),
                    HasSubstr("vga_hs_no"));
    }
}

TEST_F(CommandLineRun, PrintsNothingWhenQuietAndAllIsWell) {
    const tb::Outcome outcome = play(scenario("duration: 100ms\n"), {"--quiet"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(CommandLineRun, PrintsItsProgressInPlainLinesWithoutATerminal) {
    const tb::Outcome outcome = play(scenario("duration: 1100ms\n"), {"--frames", "none"});
    EXPECT_THAT(tb::lines_of(outcome.err),
                ElementsAre(MatchesRegex(" *1\\.00 s of 1\\.10 s, 59 frames, .* x real time")));
    EXPECT_THAT(outcome.out, StartsWith("ready\r\ntest: "));
    EXPECT_THAT(outcome.err, Not(HasSubstr("\r")));
}

TEST_F(CommandLineRun, DrawsABarOnATerminal) {
    if (!tb::has_terminals()) GTEST_SKIP() << "no terminal can be had here: /dev/pts is missing";
    tb::Command command;
    command.on_terminal = true;
    const tb::Outcome outcome = play(scenario("duration: 300ms\n"), {"--frames", "none"}, command);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, MatchesRegex("(\r\x1b\\[K\\[#*\\.*\\] [^\r\n]* s of 0\\.30 s, "
                                          "[^\r\n]* x real time)+\r\x1b\\[K"));
}

}  // namespace
