// cli_de10_lite_test.cpp - the DE10-Lite's computer, by --board: its map, and what is refused.
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

TEST_F(De10LiteCommand, RefusesAProgramForTheArm) {
    refuses("DE10-Lite", SUMS_ELF,
            "--board DE10-Lite: its computer has Nios V: expected a program for RISC-V");
}

TEST_F(De10LiteCommand, RefusesABoardForWhichNoComputerIsBuiltIn) {
    refuses("de10-nano", NIOS_V_SUMS_ELF,
            "--board DE10-Nano: no computer for it is built in: expected DE1-SoC, DE10-Lite or "
            "DE10-Standard");
}

TEST_F(De10LiteCommand, TakesTheDe1SocsNameAsIfNoneWereGiven) {
    EXPECT_EQ(on("de1-soc", NIOS_V_SUMS_ELF).exit_code, 0);
}

}  // namespace
