// on_usb.h - test fixture: a Linux program with what a scenario plugs into the USB ports
#pragma once

#include <string>

#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace tb {

inline const char* const WITH_A_GAMEPAD = "usb: [keyboard, mouse, gamepad]\n";

class OnUsb : public CommandLine {
protected:
    // The program prints this in the course of the steps, which follow its line `first`.
    void prints(const std::string& program, const std::string& what, const std::string& head,
                const std::string& first, const std::string& steps, const std::string& text) const {
        const std::string begin = first.empty() ? "" : "  - wait-serial: " + first + "\n";
        const Outcome outcome =
            play(scenario(head + "steps:\n" + begin + steps + "  - delay: 10ms\n"),
                 {"--elf", LINUX_PROGRAMS + program, "--frames", "none", "--quiet", "--", what});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(file("console.txt"), text);
    }
    std::string refuses(const std::string& lines, const std::string& program) const {
        const Outcome outcome = play(scenario(lines), {"--elf", program, "--quiet"});
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    }
};

}  // namespace tb
