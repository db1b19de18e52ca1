// linux_devices_test.cpp - what the board's Linux gives to its programs: timers, I2C, the LED.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;

class LinuxDevices : public tb::CommandLine {
protected:
    tb::Outcome run(const std::string& program, const std::string& steps,
                    std::vector<std::string> arguments = {}) const {
        std::vector<std::string> words = {
            "--elf", LINUX_PROGRAMS + program, "--frames", "none", "--quiet", "--"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return play(scenario("steps:\n" + steps), words);
    }
    std::string console() const { return file("console.txt"); }
};

TEST_F(LinuxDevices, TickByTimers) {
    const tb::Outcome outcome = run("timers", "  - wait-serial: slept over 6\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(console(),
              "20 ticks in 200 ms\n"
              "left 1.4 s, by alarm 1 s\n"
              "0 ticks without\n"
              "early -1: Resource temporarily unavailable\n"
              "polled 3, slept over 6\n");
}

TEST_F(LinuxDevices, EndAProgramByAnAlarmThatItDoesNotHandle) {
    const tb::Outcome outcome = run("timers", "  - delay: 10ms\n", {"dies"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("the program was ended by SIGALRM: a timer expired, at 2."));
}

TEST_F(LinuxDevices, HaveTheAccelerometerAndTheLed) {
    const tb::Outcome outcome = run("i2c",
                                    "  - tilt-board: {right: 30}\n"
                                    "  - wait-serial: operating\n"
                                    "  - expect-hps-led: lit\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(console(), HasSubstr("0x1D: Remote I/O error\n"
                                     "id E5\n"
                                     "rate 0A\n"));
    EXPECT_THAT(console(), HasSubstr("x -128 y 0 z 222\nblock z 222\nlit\noperating\n"));
}

}  // namespace
