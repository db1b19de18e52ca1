// continued_test.cpp - a scenario with more steps, written for another folder, says the same
#include "sim/scenario/continued.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tb/support/temp_folder.h"

namespace {

using namespace sim;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> says(const Scenario& scenario) {
    std::vector<std::string> all;
    for (const ScenarioStep& step : scenario.steps) all.push_back(step.text);
    return all;
}

std::string parts_of(const Scenario& scenario) {
    std::string all;
    for (const PartPlan& part : scenario.parts) {
        all += part.kind + " " + part.name + ":";
        for (const auto& pins : {part.shared, part.pins})
            for (const auto& pin : pins) all += " " + std::to_string(pin);
        all += fmt::format(", {} x {}\n", part.columns, part.rows);
    }
    return all;
}

TEST(Continued, ReadsLikeEachScenarioOfTheRepository) {
    unsigned count = 0;
    const TempFolder folder;
    for (const char* part : {"tb", "sw", "rtl", "sim"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(
                 std::filesystem::path{REPOSITORY} / part)) {
            if (entry.path().extension() != ".yaml") continue;
            SCOPED_TRACE(entry.path());
            std::optional<Scenario> before;
            try {
                before = load_scenario(entry.path());
            } catch (const ScenarioError&) {  // one that is wrong on purpose, or no scenario
                continue;
            }
            folder.put("again.yaml", continued(*before, 99, folder.path(), {}));
            const Scenario after = load_scenario(folder / "again.yaml");
            EXPECT_EQ(after.name, before->name);
            EXPECT_EQ(after.board_name, before->board_name);
            EXPECT_EQ(after.seed, 99u);
            EXPECT_EQ(says(after), says(*before));
            EXPECT_EQ(parts_of(after), parts_of(*before));
            EXPECT_EQ(after.ps2.first, before->ps2.first);
            EXPECT_EQ(after.ps2.second, before->ps2.second);
            EXPECT_EQ(std::filesystem::weakly_canonical(after.program),
                      std::filesystem::weakly_canonical(before->program));
            EXPECT_EQ(std::filesystem::weakly_canonical(after.project),
                      std::filesystem::weakly_canonical(before->project));
            ++count;
        }
    EXPECT_GT(count, 40u);
}

TEST(Continued, HasTheMoreStepsAfterItsOwnAndNoDuration) {
    const Scenario before = parse_scenario(
        "name: \"a: b\"\nversion: 1\nduration: 1s\nsteps:\n"
        "  - hold: {keypad: \"5\"}  # a comment\n  - type-serial: \"x\\u001b\\n\"\n",
        "/a/b/c.yaml");
    const Scenario after = parse_scenario(
        continued(before, 1, "/a", {"delay: 3ms", "release: {keypad: 5}"}), "/a/d.yaml");
    EXPECT_EQ(after.name, "a: b");
    EXPECT_FALSE(after.duration);
    EXPECT_THAT(says(after), ElementsAre("hold keypad 5", "type \"x\\x1b\\x0a\"", "wait 3ms",
                                         "release keypad 5"));
}

TEST(Continued, NamesFilesAsSeenFromTheOtherFolder) {
    const Scenario before = parse_scenario(
        "name: a\nversion: 1\nprogram: ../p, q.elf\nsteps:\n  - show-picture: sub/face.png\n"
        "  - expect-frame: {equals: /else/where.png}\n",
        "/a/b/c.yaml");
    const std::string text = continued(before, 1, "/a/out", {});
    EXPECT_THAT(text, HasSubstr("program: \"../p, q.elf\""));
    EXPECT_THAT(text, HasSubstr("- {show-picture: \"../b/sub/face.png\"}"));
    EXPECT_THAT(text, HasSubstr("equals: /else/where.png"));
    EXPECT_THAT(text, Not(HasSubstr("duration")));
}

TEST(Continued, MayHaveNoStepsOfItsOwn) {
    Scenario nothing;
    nothing.text = "name: live\nversion: 1\n";
    const Scenario after =
        parse_scenario(continued(nothing, 5, "/a", {"delay: 3ms"}), "/a/live.yaml");
    EXPECT_EQ(after.name, "live");
    EXPECT_EQ(after.seed, 5u);
    EXPECT_THAT(says(after), ElementsAre("wait 3ms"));
}

}  // namespace
