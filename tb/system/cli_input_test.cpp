// cli_input_test.cpp - wrong input: one clear line, exit 2, and nothing half-written.
#include <gmock/gmock.h>

#include "sim/files/png.h"
#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class WrongInput : public tb::CommandLine {
protected:
    void refused(const tb::Outcome& outcome, const std::string& message) const {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_THAT(files(), IsEmpty());
    }
    void usage(const std::vector<std::string>& arguments, const std::string& message) const {
        refused(de1sim(arguments), message);
    }
};

TEST_F(WrongInput, AHugeScenarioIsRefusedUnread) {
    folder.put("s.yaml", std::string(32 << 20, '#'));
    refused(play("s.yaml"), "s.yaml: expected a scenario file, got: is larger than 1048576 bytes");
}

TEST_F(WrongInput, AMisspeltStepIsRefusedWithASuggestion) {
    refused(play(scenario("steps:\n  - dely: 5ms\n")),
            "s.yaml:4:5: expected a step, got \"dely\" (did you mean \"delay\"?)");
}

TEST_F(WrongInput, AMissingGoldenIsRefusedBeforeTheRun) {
    scenario("steps:\n  - expect-frame: {equals: g.png}\n");
    refused(play("s.yaml"), "g.png");
    folder.put("g.png", "GIF89a");
    refused(play("s.yaml"), "g.png");
}

TEST_F(WrongInput, AnOutputFolderThatIsAFileIsRefused) {
    scenario("duration: 100ms\n");
    folder.put("out", "precious");
    refused(play("s.yaml"), out.string() + ": cannot create the folder: Not a directory");
    EXPECT_EQ(folder.get("out"), "precious");
}

TEST_F(WrongInput, AFolderThatCanNotBeMadeIsNamed) {
    scenario("duration: 100ms\n");
    folder.put("file", "");
    refused(de1sim({"run", "s.yaml", "--out", folder / "file/below"}),
            "file/below: cannot create the folder: Not a directory");
    refused(de1sim({"run", "s.yaml", "--out", "/proc/de1sim"}),
            "/proc/de1sim: cannot create the folder: ");
}

TEST_F(WrongInput, ATraceThatCanNotBeWrittenIsNamed) {
    refused(play(scenario("duration: 100ms\n"), {"--trace", folder / "none/a.fst"}),
            "none/a.fst: cannot create: No such file or directory");
}

TEST_F(WrongInput, AVideoThatCanNotBeWrittenIsNamed) {
    scenario("duration: 100ms\n");
    refused(play("s.yaml", {"--video", folder / "none/a.mp4"}),
            "none/a.mp4: cannot create: No such file or directory");
    for (const char* name : {"a.avi", "mp4", "a.mp4/", ""})
        usage({"run", "s.yaml", "--video", name},
              std::string{"--video: expected FILE.mp4 or FILE.webm, got \""} + name + '"');
}

TEST_F(WrongInput, NoArgumentsAreAnsweredWithWhatIsMissing) {
    usage({}, "subcommand is required");
    usage({"run"}, "FILE: expected a scenario or a program");
}

TEST_F(WrongInput, UnknownWordsAreNamed) {
    scenario("duration: 100ms\n");
    usage({"walk", "s.yaml"}, "walk");
    usage({"run", "s.yaml", "--frame", "all"}, "--frame");
    usage({"run", "s.yaml", "again.yaml"}, "again.yaml");
}

TEST_F(WrongInput, ValuesThatMakeNoSenseAreNamed) {
    scenario("duration: 100ms\n");
    const auto wrong = [this](const std::string& option, const std::string& value,
                              const std::string& message) {
        usage({"run", "s.yaml", "--out", out, option + "=" + value}, message);
    };
    for (const char* value : {"some", "every", "every:", "every:0", "every:-1", "every:2x"})
        wrong("--frames", value, "--frames: expected new, all, every:N, last or none, got \"");
    for (const char* value : {"5", "-1s", "0s", "1h", "s", "2000000s"})
        wrong("--duration", value, "--duration: expected a time such as 500ms or 10s, got \"");
    for (const char* value : {"-1", "one", "0x10", "1.5", "18446744073709551616"})
        wrong("--seed", value, "--seed: expected a whole number, got \"");
    for (const char* value : {"44100", "0", "-8000", "fast"})
        wrong("--audio-rate", value, "--audio-rate: ");
    wrong("--cpu", "m68k", "m68k");
}

}  // namespace
