// cli_de10_lite_test.cpp - the board by --board or by the scenario: its computer, what is refused.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;

class De10LiteCommand : public tb::CommandLine {
protected:
    tb::Outcome on(const std::string& board, const std::string& elf,
                   const std::string& steps = "") const {
        return play(scenario(steps.empty() ? "duration: 1ms\n" : "steps:\n" + steps),
                    {"--elf", elf, "--board", board, "--frames", "none"});
    }
    // By the scenario's key, and perhaps by --board, too.
    tb::Outcome by_key(const std::string& board, const std::string& steps,
                       const std::vector<std::string>& options = {}) const {
        std::vector<std::string> words{"--elf", NIOS_V_SUMS_ELF, "--frames", "none"};
        words.insert(words.end(), options.begin(), options.end());
        return play(scenario("board: " + board + "\nsteps:\n" + steps), words);
    }
    void refuses(const std::string& board, const std::string& elf, const std::string& why,
                 const std::string& steps = "") const {
        const tb::Outcome outcome = on(board, elf, steps);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr(why));
    }
};

TEST_F(De10LiteCommand, HasTheRegistersOfItsMap) {
    const tb::Outcome outcome = on("de10-lite", DE10_LITE_ELF,
                                   "  - set-voltage: {channel: 2, volts: 3}\n"
                                   "  - expect-leds: {equals: \"1111111111\", timeout: 100ms}\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(folder.get("console.txt") + outcome.err + outcome.out,
                HasSubstr("wrote 0xFF203040: the DE10-Lite Computer has nothing there; on the "
                          "board, too, the interconnect sends it to the SDRAM at 0x03203040"));
}

TEST_F(De10LiteCommand, RefusesAStepForWhatTheBoardHasNot) {
    refuses("de10-lite", NIOS_V_SUMS_ELF,
            "expected a step for what the DE10-Lite has, got one for key 2: it has 0 to 1",
            "  - press: {key: 2}\n");
    refuses("de10-lite", NIOS_V_SUMS_ELF, "got one for input 6 of the AD converter: it has 0 to 5",
            "  - set-voltage: {channel: 6, volts: 1}\n");
    refuses("de1-soc", NIOS_V_SUMS_ELF, "expected a display: monitor, got \"HPS LCD\"",
            "  - take-screenshot: {save-to: lcd.png, of: HPS LCD}\n");
}

TEST_F(De10LiteCommand, HasNoJp2OnADe10Standard) {
    const std::string lit = "  - expect-leds: {equals: \"0000001010\", timeout: 1ms}\n";
    EXPECT_EQ(on("de1-soc", DRIVES_JP2_ELF, lit).exit_code, 0);
    const tb::Outcome outcome = on("de10-standard", DRIVES_JP2_ELF, lit);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err + outcome.out,
                HasSubstr("wrote 0xFF200074: no block is there; on the board, too, the "
                          "interconnect sends it to "));
}

TEST_F(De10LiteCommand, RefusesAProgramForTheArm) {
    refuses("DE10-Lite", SUMS_ELF,
            "board DE10-Lite: its computer has Nios V: expected a program for RISC-V");
}

TEST_F(De10LiteCommand, RefusesABoardForWhichNoComputerIsBuiltIn) {
    refuses("de10-nano", NIOS_V_SUMS_ELF,
            "board DE10-Nano: no computer for it is built in: expected DE1-SoC, DE10-Lite or "
            "DE10-Standard");
}

TEST_F(De10LiteCommand, TakesTheDe1SocsNameAsIfNoneWereGiven) {
    EXPECT_EQ(on("de1-soc", NIOS_V_SUMS_ELF).exit_code, 0);
}

TEST_F(De10LiteCommand, IsTheScenariosBoardUnlessTheOptionNamesAnother) {
    const std::string key_2 = "  - press: {key: 2}\n";
    EXPECT_THAT(by_key("de10-lite", key_2).err,
                HasSubstr("expected a step for what the DE10-Lite has, got one for key 2"));
    EXPECT_EQ(by_key("DE10-Lite", key_2, {"--board", "DE1-SoC"}).exit_code, 0);
    EXPECT_EQ(by_key("DE1-SoC", key_2).exit_code, 0);
    EXPECT_EQ(by_key("DE1-SoC", key_2, {"--board", "de10_lite"}).exit_code, 2);
}

TEST_F(De10LiteCommand, RefusesAWrongBoardAtItsPlaceInTheScenario) {
    const std::string delay = "  - delay: 1ms\n";
    EXPECT_THAT(by_key("DE9", delay).err,
                HasSubstr("s.yaml:3:8: board DE9: there is no such board: expected one of DE1-SoC "
                          "(5CSEMA5F31C6), DE10-Lite"));
    EXPECT_THAT(by_key("DE10-Nano", delay).err,
                HasSubstr("s.yaml:3:8: board DE10-Nano: no computer for it is built in"));
    EXPECT_THAT(by_key("10", delay).err, HasSubstr("s.yaml:3:8: expected a line of text, got 10"));
}

TEST_F(De10LiteCommand, IsTheBoardOfAProjectThatTheScenarioNames) {
    folder.put("top.v", "module top(output [9:0] LED); assign LED = 5; endmodule\n");
    const std::string head = "project: .\nboard: DE10-Nano\nsteps:\n";
    EXPECT_THAT(play(scenario(head + "  - press: {key: 2}\n")).err,
                HasSubstr("expected a step for what the DE10-Nano has, got one for key 2"));
    EXPECT_THAT(play(scenario("project: .\nboard: DE9\nsteps:\n  - delay: 1ms\n")).err,
                HasSubstr("s.yaml:4:8: board DE9: there is no such board"));
}

}  // namespace
