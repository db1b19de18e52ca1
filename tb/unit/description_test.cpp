// A run as JSON, as one process hands it to another.
#include "sim/run/description.h"

#include <gtest/gtest.h>

namespace {

using namespace sim;

RunDescription one_of_everything() {
    RunDescription run;
    run.scenario = "a b/\xff\xc3\xa9\n.yaml";  // a path may have any bytes
    run.scenario_text = "name: x\n";
    run.chip.project.place = "pong.qsf";
    run.chip.project.macros = {"A=1", "\"B\""};
    run.chip.bridged_memory = true;
    run.chip.audio_rate = 48'000;
    run.chip.strict_vga = false;
    run.program.cpu = "arm";
    run.program.elf = "p.elf";
    run.program.cpi = 1.3;
    run.program.shortcuts = false;
    run.program.arguments = {"", "-x", "\xe2\x82\xac"};
    run.outputs.out = "somewhere";
    run.outputs.frames = {FrameChoice::Which::EVERY, 7};
    run.outputs.trace = {"w.fst", SimTime{1}, SimTime{MAX_SIM_TIME}};
    run.outputs.gdb = 0;
    run.outputs.live_socket = 5;
    run.outputs.quiet = true;
    run.duration = SimTime{123'456'789};
    run.seed = 0xFFFF'FFFF'FFFF'FFFF;
    run.command = "de1sim run";
    return run;
}

TEST(RunDescription, ComesBackFromItsJson) {
    const RunDescription before = one_of_everything();
    const RunDescription after = description_from(to_json(before), "x");
    EXPECT_EQ(after.scenario, before.scenario);
    EXPECT_EQ(after.scenario_text, before.scenario_text);
    EXPECT_EQ(after.chip.project.macros, before.chip.project.macros);
    EXPECT_EQ(after.chip.audio_rate, 48'000u);
    EXPECT_EQ(after.chip.strict_vga, false);
    EXPECT_EQ(after.program.arguments, before.program.arguments);
    EXPECT_EQ(after.program.cpi, 1.3);
    EXPECT_EQ(after.outputs.frames.text(), "every:7");
    EXPECT_EQ(after.outputs.trace.to->ps, MAX_SIM_TIME.ps);
    EXPECT_EQ(after.outputs.gdb, 0u);
    EXPECT_FALSE(after.outputs.trace_failure);
    EXPECT_EQ(after.seed, 0xFFFF'FFFF'FFFF'FFFFu);
    EXPECT_EQ(to_json(after), to_json(before));
}

TEST(RunDescription, OfOtherTextIsRefusedWithTheName) {
    for (const char* text : {"", "{}", "[1]", "{\"scenario\": 5}", "\xff", "{\"scenario\": null}"})
        try {
            description_from(text, "run.json");
            FAIL() << text;
        } catch (const std::runtime_error& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.rfind("run.json: expected the description of a run", 0), 0u)
                << message;
        }
}

}  // namespace
