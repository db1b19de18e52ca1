// linux_devices_test.cpp - a Linux program's keyboard and mouse on USB, and its frame buffer.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::IsEmpty;

class LinuxDevice : public tb::CommandLine {
protected:
    // The program prints this in the course of the steps, which follow its first line.
    void prints(const std::string& what, const std::string& first, const std::string& steps,
                const std::string& text) const {
        const tb::Outcome outcome =
            play(scenario("steps:\n  - wait-serial: " + first + "\n" + steps + "  - delay: 10ms\n"),
                 {"--elf", LINUX_PROGRAMS "devices", "--frames", "none", "--quiet", "--", what});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(file("console.txt"), text);
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
    }
};

TEST_F(LinuxDevice, HasTheKeysOfTheKeyboardAsEvents) {
    prints("keyboard", "Keyboard",
           "  - press-key: {key: Left, for: 50ms}\n  - press-key: {key: [Shift, z], for: 20ms}\n"
           "  - press-key: {key: Esc, for: 10ms}\n",
           "USB Keyboard\n1 105 1\n1 105 0\n1 42 1\n1 44 1\n1 44 0\n1 42 0\n1 1 1\n1 1 0\n");
}

const char* const HAND =
    "  - move-mouse: {right: 2, down: 1, for: 2ms}\n  - delay: 1ms\n  - turn-wheel: 1\n"
    "  - delay: 1ms\n  - click-mouse: right\n";

TEST_F(LinuxDevice, HasTheMouseAsEvents) {
    prints("mouse", "Mouse", HAND,
           "USB Optical Mouse\n2 0 1\n2 0 1\n2 1 1\n2 8 -1\n2 11 -120\n1 273 1\n1 273 0\n");
}

TEST_F(LinuxDevice, HasTheMouseAsPackets) {
    prints("mice", "ready", HAND, "ready -1 1\n08 1 0 0\n28 1 -1 0\n08 0 0 1\n0a 0 0 0\n");
}

TEST_F(LinuxDevice, HasThePixelBufferAsAFrameBuffer) {
    prints("draws", "red", "",
           "320 x 240, 16 bits, red 5 at 11\nf800, 07e0, pan -1\n"
           "5 5 8: 00 01 05 05, 00\n2 -1 No space left on device 0\n");
}

}  // namespace
