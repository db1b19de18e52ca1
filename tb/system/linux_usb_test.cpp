// linux_usb_test.cpp - what a Linux program has of the USB ports: input devices, and usbfs.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;

class OnUsb : public tb::CommandLine {
protected:
    // The program prints this in the course of the steps, which follow its line `first`.
    void prints(const std::string& program, const std::string& what, const std::string& head,
                const std::string& first, const std::string& steps, const std::string& text) const {
        const std::string begin = first.empty() ? "" : "  - wait-serial: " + first + "\n";
        const tb::Outcome outcome =
            play(scenario(head + "steps:\n" + begin + steps + "  - delay: 10ms\n"),
                 {"--elf", LINUX_PROGRAMS + program, "--frames", "none", "--quiet", "--", what});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(file("console.txt"), text);
    }
    std::string refuses(const std::string& lines, const std::string& program) const {
        const tb::Outcome outcome = play(scenario(lines), {"--elf", program, "--quiet"});
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    }
};

const char* const WITH_A_GAMEPAD = "usb: [keyboard, mouse, gamepad]\n";

// ---- Input devices ------------------------------------------------------------------------------

class LinuxInput : public OnUsb {};

TEST_F(LinuxInput, HasNodesAndLinksOfWhatIsPluggedIn) {
    prints("input", "lists", WITH_A_GAMEPAD, "", "  - delay: 300ms\n", R"(/dev/input
  by-id/
  by-path/
  event0
  event1
  event2
  js0
  mice
  mouse0
/dev/input/by-id
  usb-0079_USB_Gamepad-event-joystick -> ../event2
  usb-0079_USB_Gamepad-joystick -> ../js0
  usb-046d_USB_Optical_Mouse-event-mouse -> ../event1
  usb-046d_USB_Optical_Mouse-mouse -> ../mouse0
  usb-04d9_USB_Keyboard-event-kbd -> ../event0
/dev/input/by-path
  platform-ffb40000.usb-usb-0:1.1:1.0-event-kbd -> ../event0
  platform-ffb40000.usb-usb-0:1.2:1.0-event-mouse -> ../event1
  platform-ffb40000.usb-usb-0:1.2:1.0-mouse -> ../mouse0
  platform-ffb40000.usb-usb-0:1.3:1.0-event-joystick -> ../event2
  platform-ffb40000.usb-usb-0:1.3:1.0-joystick -> ../js0
/sys/class/input
  event0 -> ../../devices
  event1 -> ../../devices
  event2 -> ../../devices
  js0 -> ../../devices
  mice -> ../../devices
  mouse0 -> ../../devices
0
by-path/../by-id/..
  by-id/
  by-path/
  event0
  event1
  event2
  js0
  mice
  mouse0
20660 d40
120777
1-1.3:1.0/0003:0079:0006.0003/input/input2/name
EISDIR ENOTDIR
I: Bus=0003 Vendor=04d9 Product=0001 Version=0111
N: Name="USB Keyboard"
P: Phys=usb-ffb40000.usb-1.1/input0
S: Sysfs=/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.1/1
U: Uniq=
H: Handlers=sysrq kbd leds event0 .
B: PROP=0
B: EV=120013
B: KEY=e080ffdf 18fffff ffffffff fffffffe
B: MSC=10
B: LED=7

I: Bus=0003 Vendor=046d Product=0001 Version=0111
N: Name="USB Optical Mouse"
P: Phys=usb-ffb40000.usb-1.2/input0
S: Sysfs=/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.2/1
U: Uniq=
H: Handlers=mouse0 event1 .
B: PROP=0
B: EV=17
B: KEY=70000 0 0 0 0 0 0 0 0
B: REL=903
B: MSC=10

I: Bus=0003 Vendor=0079 Product=0006 Version=0110
N: Name="USB Gamepad"
P: Phys=usb-ffb40000.usb-1.3/input0
S: Sysfs=/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.3/1
U: Uniq=
H: Handlers=event2 js0 .
B: PROP=0
B: EV=1b
B: KEY=7fff0000 0 0 0 0 0 0 0 0 0
B: ABS=30027
B: MSC=10

)");
}

TEST_F(LinuxInput, SaysWhatADeviceIsAndCanDo) {
    prints("input", "describes", WITH_A_GAMEPAD, "", "  - delay: 500ms\n",
           R"(USB Keyboard, 3 04d9:0001 0111, usb-ffb40000.usb-1.1/input0, 1, repeats 0 250 33
types 4: 0 1 4 17 20
movements 4:
axes 8:
lamps 4: 0 1 2
64 4 -1
no axis: EINVAL
no axis: EINVAL
USB Optical Mouse, 3 046d:0001 0111, usb-ffb40000.usb-1.2/input0, 1, repeats ENOSYS 0 0
types 4: 0 1 2 4
keys 96: 272 273 274
movements 4: 0 1 8 11
axes 8:
lamps 4:
64 4 -1
no axis: EINVAL
no axis: EINVAL
USB Gamepad, 3 0079:0006 0110, usb-ffb40000.usb-1.3/input0, 1, repeats ENOSYS 0 0
types 4: 0 1 3 4
keys 96: 304 305 306 307 308 309 310 311 312 313 314 315 316 317 318
movements 4:
axes 8: 0 1 2 5 16 17
lamps 4:
64 4 -1
axis 0: 128 in 0 to 255, 0, 15
axis 17: 0 in -1 to 1, 0, 0
)");
}

TEST_F(LinuxInput, IsHeardAloneByWhoGrabsIt) {
    prints("input", "grabs", "", "ready",
           "  - press-key: {key: a, to: usb}\n  - delay: 50ms\n  - press-key: b\n"
           "  - delay: 100ms\n",
           R"(EAGAIN
ready 0 EBUSY EINVAL
0 4 4 458756
0 1 30 1
0 0 0 0
EAGAIN
held 96: 30
0
held 96:
100 4 4 458756
100 0 0 0
16
lit 4: 1
)");
}

TEST_F(LinuxInput, RepeatsAKeyThatIsHeld) {
    prints("input", "repeats", "", "ready",
           "  - press-key: {key: a, to: usb, for: 400ms}\n  - delay: 50ms\n"
           "  - press-key: {key: a, for: 400ms}\n",
           "ready\n1, 0 repeated\n0, 5 repeated\n1, 0 repeated\n0, 16 repeated\n");
}

TEST_F(LinuxInput, EndsReadingWhenTheDeviceIsUnplugged) {
    prints("input", "pulls", "", "ready",
           "  - hold-key: {key: a, to: usb}\n  - delay: 10ms\n  - unplug-usb: keyboard\n"
           "  - delay: 10ms\n  - unplug-usb: mouse\n  - plug-usb: mouse\n"
           "  - move-mouse: {right: 5, for: 1ms, to: usb}\n  - plug-usb: keyboard\n"
           "  - delay: 20ms\n",
           R"(ready
0 4 4 458756
0 1 30 1
0 0 0 0
ENODEV
poll 18
name ENODEV
open ENOENT
mouse ENODEV
mice 3 5
/dev/input
  by-id/
  by-path/
  event0
  event1
  mice
  mouse0
)");
}

TEST_F(LinuxInput, HasTheGamepadAsAJoystick) {
    prints("input", "joystick", WITH_A_GAMEPAD, "ready",
           "  - press-pad-button: A\n  - press-pad-button: {button: Start, for: 20ms}\n"
           "  - hold-pad-button: Left\n  - press-pad-button: Up\n  - release-pad-button: Left\n"
           "  - move-stick: {stick: left, right: 50, for: 50ms}\n"
           "  - move-stick: {stick: right, down: -100}\n  - delay: 1ms\n"
           "  - move-stick: {stick: right, right: 5}\n  - delay: 1ms\n  - unplug-usb: gamepad\n",
           R"(12 bytes of a name, USB Gamepad, version 20100, 6 axes, 15 buttons
0 1 2 5 16 17 130 to 13e
ready
from 0 ms
button 0: 1
button 0: 0
button 11: 1
button 11: 0
axis 4: -32767
axis 5: -32767
axis 5: 0
axis 4: 0
axis 0: 16552
axis 0: 0
axis 3: -32767
axis 3: 0
ENODEV
)");
}

TEST_F(LinuxInput, HasTheGamepadAsEvents) {
    prints("input", "gamepad", WITH_A_GAMEPAD, "ready",
           "  - move-stick: {stick: left, right: 50, down: -20}\n  - press-pad-button: B\n",
           R"(ready
3 0 191
3 1 103
0 0 0
4 4 589826
1 305 1
0 0 0
4 4 589826
1 305 0
)");
}

TEST_F(LinuxInput, NeedsALinuxProgram) {
    for (const char* step : {"press-key: {key: a, to: usb}", "plug-usb: gamepad"})
        EXPECT_THAT(refuses(std::string{"steps:\n  - "} + step + "\n", LEDS_ELF),
                    HasSubstr("s.yaml:4:5: expected a Linux program, which has the USB ports, "
                              "got none"));
}

// ---- usbfs --------------------------------------------------------------------------------------

class LinuxUsb : public OnUsb {};

TEST_F(LinuxUsb, ListsItsDevices) {
    prints("usbfs", "lists", WITH_A_GAMEPAD, "", "  - delay: 200ms\n", R"(62656572
1-0:1.0: 09 00
1-1: 1 2 480 1 0424 2512 -
1-1.1: 1 3 1.5 1 04d9 0001 USB Keyboard
1-1.1:1.0: 03 01
1-1.2: 1 4 1.5 1 046d 0001 USB Optical Mouse
1-1.2:1.0: 03 02
1-1.3: 1 5 1.5 1 0079 0006 USB Gamepad
1-1.3:1.0: 03 00
1-1:1.0: 09 00
usb1: 1 1 480 1 1d6b 0002 DWC OTG Controller
nodes: . .. 001 002 003 004 005
)");
}

TEST_F(LinuxUsb, GivesDescriptorsAndTakesRequests) {
    prints("usbfs", "descriptors", "", "", "  - delay: 300ms\n",
           R"(12 01 10 01 00 00 00 08 d9 04 01 00 11 01 00 01
00 01
09 02 22 00 01 01 00 80 32 09 04 00 00 01 03 01
01 00 09 21 11 01 00 01 22 3f 00 07 05 81 03 08
00 0a
EPERM
17, 3 1
1a 03 55 00 53 00 42 00 20 00 4b 00 65 00 79 00
62 00 6f 00 61 00 72 00 64 00
EPIPE EBUSY
driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
05 01 09 06 a1 01 05 07 19 e0 29 e7 15 00 25 01
75 01 95 08 81 02 95 01 75 08 81 01 95 03 75 01
05 08 19 01 29 03 91 02 95 01 75 05 91 01 95 06
75 08 15 00 25 65 05 07 19 00 29 65 81 00 c0
0 1 0 1
)");
}

TEST_F(LinuxUsb, GivesReportsOfAKeyboardThatWasTakenFromItsDriver) {
    prints("usbfs", "keyboard", "", "ready",
           "  - press-key: {key: a, for: 3ms}\n  - delay: 30ms\n"
           "  - press-key: {key: [Ctrl, Esc], to: usb}\n  - wait-serial: waits\n"
           "  - press-key: {key: b, for: 50ms}\n",
           R"(driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
events ENODEV, node ENOENT
reap EAGAIN
submit 0
ready
poll 4, reap 0, 0, 0 ms: 00 00 04 00 00 00 00 00
poll 4, reap 0, 0, 0 ms: 00 00 00 00 00 00 00 00
poll 4, reap 0, 0, 0 ms: 01 00 00 00 00 00 00 00
poll 4, reap 0, 0, 0 ms: 01 00 29 00 00 00 00 00
discard 0, again EINVAL
poll 4, reap 0, -2, 0 ms: none
bulk ETIMEDOUT, 50 ms
waits
01 00 00 00 00 00 00 00
release 0, again EINVAL, attach 1, again EBUSY, node 0
)");
}

TEST_F(LinuxUsb, GivesReportsOfAMouseInBothProtocols) {
    prints("usbfs", "mouse", "", "ready",
           "  - move-mouse: {right: 300, down: -3, for: 1ms}\n  - wait-serial: boot\n"
           "  - click-mouse: {button: left, to: usb, for: 20ms}\n",
           R"(driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
submit 0
submit 0
submit 0
ready
poll 4, reap 0, 0, 0 ms: 00 7f fd 00
poll 4, reap 0, 0, 0 ms: 00 7f 00 00
poll 4, reap 0, 0, 0 ms: 00 2e 00 00
0
submit 0
submit 0
boot
poll 4, reap 0, 0, 0 ms: 01 00 00
poll 4, reap 0, 0, 0 ms: 00 00
)");
}

TEST_F(LinuxUsb, GivesReportsOfAGamepad) {
    prints("usbfs", "gamepad", WITH_A_GAMEPAD, "ready",
           "  - press-pad-button: {button: R, for: 20ms}\n  - hold-pad-button: Up\n"
           "  - delay: 20ms\n  - move-stick: {stick: right, right: 100, down: 100}\n",
           R"(driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
ready
submit 0
poll 4, reap 0, 0, 0 ms: 80 80 80 80 08 80 00
submit 0
poll 4, reap 0, 0, 0 ms: 80 80 80 80 08 00 00
submit 0
poll 4, reap 0, 0, 0 ms: 80 80 80 80 00 00 00
submit 0
poll 4, reap 0, 0, 0 ms: 80 80 ff ff 00 00 00
)");
}

TEST_F(LinuxUsb, EndsTransfersWhenTheDeviceIsUnplugged) {
    prints("usbfs", "pulls", "", "ready",
           "  - hold-key: Space\n  - delay: 20ms\n  - unplug-usb: keyboard\n", R"(driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
submit 0
ready
poll 4, reap 0, 0, 0 ms: 00 00 2c 00 00 00 00 00
poll 18, reap ENODEV
ENODEV ENODEV ENOENT
)");
}

TEST_F(LinuxUsb, TellsOfDevicesThatComeAndGo) {
    prints("usbfs", "hears", "", "ready",
           "  - plug-usb: gamepad\n  - delay: 20ms\n  - unplug-usb: keyboard\n", R"(bind 0 0
ready
from 0 of group 1, 2, user 0
  add@/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.3
  ACTION=add
  DEVPATH=/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.3
  SUBSYSTEM=usb
  MAJOR=189
  MINOR=4
  DEVNAME=bus/usb/001/005
  DEVTYPE=usb_device
  PRODUCT=79/6/110
  TYPE=0/0/0
  BUSNUM=001
  DEVNUM=005
  SEQNUM=3
from 0 of group 1, 2, user 0
  remove@/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.1
  ACTION=remove
  DEVPATH=/devices/platform/soc/ffb40000.usb/usb1/1-1/1-1.1
  SUBSYSTEM=usb
  MAJOR=189
  MINOR=2
  DEVNAME=bus/usb/001/003
  DEVTYPE=usb_device
  PRODUCT=4d9/1/111
  TYPE=0/0/0
  BUSNUM=001
  DEVNUM=003
  SEQNUM=4
)");
}

}  // namespace
