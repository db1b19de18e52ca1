// hands_test.cpp - a scenario's hands at the controls, as a program notices them.
#include <map>

#include "regmap.h"
#include "sim/scenario/scenario_runner.h"
#include "tb/support/whole_board.h"

namespace {

class Hands : public tb::WholeBoard {
protected:
    sim::Observations observations;
    std::map<std::string, int> presses;

    void play(const std::string& steps) {
        const sim::Scenario scenario = sim::parse_scenario(
            "name: a\nversion: 1\nparts:\n"
            "  - button: {name: b, pin: \"GPIO_1[20]\"}\nsteps:\n" +
                steps,
            "a.yaml");
        parts = scenario.parts;
        power_on([this](hal::Mmio& io, hal::Cpu& cpu) { watch(io, cpu); });
        sim::ScenarioRunner runner{"runner", *board, observations, scenario.steps, ""};
        while (!runner.finished()) run_ms(1);
        run_ms(25);
    }

private:
    // Whenever one is down that was not.
    void note(const std::string& control, bool down) {
        presses[control] += down && !std::exchange(down_[control], down);
        down_[control] = down;
    }

    void watch(hal::Mmio& io, hal::Cpu& cpu) {
        constexpr std::uint32_t GPIO1_INPUTS = 0xFF709050, HPS_KEY = 1 << 25, PART = 1 << 16;
        io.write(regmap::KEYPAD_CONTROL, regmap::KEYPAD_CONTROL_EN_MASK);
        bool mouse_is_on = false;
        std::vector<std::uint32_t> packet;
        for (;; cpu.idle()) {
            note("key", io.read(regmap::KEY_DATA) & 1);
            note("switch", io.read(regmap::SW_DATA) & 8);
            note("hps key", !(io.read(GPIO1_INPUTS) & HPS_KEY));
            note("part", !(io.read(regmap::JP2_DATA) & PART));
            const std::uint32_t event = io.read(regmap::KEYPAD_EVENT);
            if (event & regmap::KEYPAD_EVENT_VALID_MASK) {
                note("keypad", event & regmap::KEYPAD_EVENT_PRESSED_MASK);
                io.write(regmap::KEYPAD_EVENT, 0);
            }
            const std::uint32_t code = io.read(regmap::PS2_0_DATA);
            if (code & regmap::PS2_0_DATA_RVALID_MASK) presses["code"] += (code & 0xff) == 0x1C;
            const std::uint32_t byte = io.read(regmap::PS2_1_DATA);
            if (!(byte & regmap::PS2_1_DATA_RVALID_MASK)) continue;
            if (!mouse_is_on && (byte & 0xff) == 0) io.write(regmap::PS2_1_DATA, 0xF4);
            if (mouse_is_on) packet.push_back(byte & 0xff);
            mouse_is_on |= (byte & 0xff) == 0xFA;
            if (packet.size() == 3) {
                note("mouse", packet[0] & 1);
                packet.clear();
            }
        }
    }

    std::map<std::string, bool> down_;
};

TEST_F(Hands, LetGoBetweenTwoPressesOfAControl) {
    const std::string presses_of_each =
        "  - press: {key: [0, hps], for: 10ms}\n"
        "  - press: {key: [0, hps], for: 10ms}\n"
        "  - press: {switch: 3, for: 10ms, bounce: 0ms}\n"
        "  - press: {switch: 3, for: 10ms, bounce: 0ms}\n"
        "  - hold: {switch: 3, bounce: 0ms}\n"
        "  - delay: 1ms\n"
        "  - release: {switch: 3, bounce: 0ms}\n"
        "  - press: {keypad: \"5\", for: 30ms}\n"
        "  - press: {keypad: \"5\", for: 30ms}\n"
        "  - press-button: {button: b, for: 10ms}\n"
        "  - press-button: {button: b, for: 10ms}\n"
        "  - delay: 300ms\n"
        "  - press-key: {key: a, for: 10ms}\n"
        "  - press-key: {key: a, for: 10ms}\n"
        "  - click-mouse: {button: left, for: 30ms}\n"
        "  - click-mouse: {button: left, for: 30ms}\n";
    play(presses_of_each);
    // The keyboard's code stands in the break code, too.
    EXPECT_EQ(presses, (std::map<std::string, int>{{"key", 2},
                                                   {"hps key", 2},
                                                   {"switch", 3},
                                                   {"keypad", 2},
                                                   {"part", 2},
                                                   {"code", 4},
                                                   {"mouse", 2}}));
}

TEST_F(Hands, KeepToThePauseThatIsWritten) {
    play(
        "  - press: {key: 0, for: 1ms}\n"
        "  - delay: 1ms\n"
        "  - press: {key: 0, for: 1ms}\n");
    EXPECT_EQ(presses["key"], 2);
    EXPECT_LT(sc_core::sc_time_stamp(), sc_core::sc_time(30, sc_core::SC_MS));
}

}  // namespace
