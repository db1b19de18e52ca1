// linux_gpio_test.cpp - the processor's pins and LED below /sys, as a Linux program has them.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::IsEmpty;

class LinuxGpio : public tb::CommandLine {
protected:
    // gpio WHAT prints this, and what the steps expect is met.
    void prints(const std::string& what, const std::string& steps, const std::string& text) const {
        const tb::Outcome outcome =
            play(scenario(steps),
                 {"--elf", LINUX_PROGRAMS "gpio", "--frames", "none", "--quiet", "--", what});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(file("console.txt"), text);
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
    }
};

TEST_F(LinuxGpio, HasTheBoardsPinsAndRefusesWhatLinuxRefuses) {
    prints("refusals", "duration: 100ms\n",
           "export gpiochip427 gpiochip454 gpiochip483 unexport \n"
           "ff709000.gpio, 29 pins from 454\n"
           "512 > export: Invalid argument\n426 > export: Invalid argument\n"
           "-1 > export: Invalid argument\nkey > export: Invalid argument\n"
           "99999999999 > export: Numerical result out of range\n"
           "479 > unexport: Invalid argument\n0x1df\n > export: done\n"
           "479 > export: Device or resource busy\n478 > export: Device or resource busy\n"
           "1 > value: Operation not permitted\n"
           "up > direction: Invalid argument\nup > edge: Invalid argument\n"
           "falling > edge: done\nout > direction: Input/output error\nnone > edge: done\n"
           "high > direction: done\nrising > edge: Input/output error\n"
           "no Permission denied Permission denied\n"
           "479 > unexport: done\n-1 No such device, gone\n");
}

TEST_F(LinuxGpio, TellsOfEdgesOfTheKey) {
    std::string steps = "steps:\n  - wait-serial: after\n";
    for (int i = 0; i < 6; ++i) steps += "  - press: {key: hps, for: 20ms}\n  - delay: 20ms\n";
    prints("key", steps,
           "done in both\n1 a before it is read, 1, 0 after\n"
           "1 a 0\n1 a 1\n1 a 0\n1 a 1\n1 1 0\n1 1 0\ndone 1 1\n1 a 0\n1 a 0\n");
}

TEST_F(LinuxGpio, LightsTheLedByItsDriverOrAsAPin) {
    const std::string lit = "  - expect-hps-led: {equals: lit, timeout: 100ms}\n",
                      dark = "  - expect-hps-led: {equals: dark, timeout: 100ms}\n";
    prints("led",
           "steps:\n" + lit + dark + lit + dark + lit + dark + "  - wait-serial: end\n" + dark,
           "[none] timer heartbeat default-on 0 -1\ndone 1\n1 1\n"
           "done No such device -1 done\n"
           "leds > bind: Device or resource busy\nhigh > direction: done\n1\n0 > value: done\n"
           "1, 0 > value: done\nleds > bind: done\nend\n");
}

TEST_F(LinuxGpio, LetsTriggersMoveTheLed) {
    prints("triggers", "duration: 2s\n",
           "disco > trigger: Invalid argument\ntimer > trigger: done\n"
           "none [timer] heartbeat default-on, 20 and 30 ms\nheartbeat > trigger: done\n"
           "0 > brightness: done\n[none] timer heartbeat default-on\n");
    const auto changes = report()["shown"]["hps_led"]["changes"]["first"];
    ASSERT_GE(changes.size(), 12u);
    const auto spans = [&](std::size_t from, std::size_t count) {
        std::vector<int> all;  // ms
        for (std::size_t i = from; i < from + count; ++i)
            all.push_back(static_cast<int>(1000 * (changes[i + 1]["time_s"].get<double>() -
                                                   changes[i]["time_s"].get<double>()) +
                                           0.5));
        return all;
    };
    EXPECT_THAT(spans(1, 5), testing::ElementsAre(30, 20, 30, 20, 30));
    EXPECT_THAT(spans(changes.size() - 4, 3), testing::ElementsAre(70, 245, 70));
}

}  // namespace
