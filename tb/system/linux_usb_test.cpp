// linux_usb_test.cpp - what a Linux program has of the USB ports by usbfs.
#include "tb/system/on_usb.h"

namespace {

using tb::WITH_A_GAMEPAD;

class LinuxUsb : public tb::OnUsb {};

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

TEST_F(LinuxUsb, LetsLibudevFollowTheLinksToADevice) {
    prints("usbfs", "walks", "", "", "  - delay: 200ms\n", R"(sys folder
bus folder
usb folder
devices folder
ELOOP
1-1 link
.. folder
.. folder
.. folder
devices folder
platform folder
soc folder
ffb40000.usb folder
usb1 folder
1-1 folder
62656572 /sys/devices/platform/soc/ffb40000.usb/usb1/1-1 0
EOPNOTSUPP ENOENT EOPNOTSUPP
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

TEST_F(LinuxUsb, GivesEightBytesOfASnesGamepadAtEachPoll) {
    prints("usbfs", "snes", "usb: snes-gamepad\n", "", "  - delay: 300ms\n", R"(driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
12 01 00 01 00 00 00 08 79 00 11 00 06 01 00 02
00 01
09 02 22 00 01 01 00 80 32 09 04 00 00 01 03 00
00 00 09 21 10 01 21 01 22 65 00 07 05 81 03 08
00 0a
05 01 09 04 a1 01 a1 02 75 08 95 05 15 00 26 ff
00 35 00 46 ff 00 09 30 09 30 09 30 09 30 09 31
81 02 75 04 95 01 25 07 46 3b 01 65 14 09 00 81
42 65 00 75 01 95 0a 25 01 45 01 05 09 19 01 29
0a 81 02 06 00 ff 75 01 95 0a 25 01 45 01 09 01
81 02 c0 a1 02 75 08 95 04 46 ff 00 26 ff 00 09
02 91 02 c0 c0
1a 03 55 00 53 00 42 00 20 00 47 00 61 00 6d 00
65 00 70 00 61 00 64 00 20 00
ten reports in 80 ms
01 7f 7f 7f 7f 0f 00 00
01 7f 7f 7f 7f 0f 00
01 7f 7f 7f 7f 0f 00 00 01 7f 7f 7f 7f 0f 00 00
01 7f 7f 7f
)");
}

TEST_F(LinuxUsb, TellsTwoGamepadsApart) {
    prints("usbfs", "pads", "usb: [snes-gamepad, snes-gamepad, keyboard]\n", "ready",
           "  - press-pad-button: {button: A, pad: 2, for: 40ms}\n"
           "  - hold-pad-button: {button: X, pad: 1}\n"
           "  - hold-pad-button: {button: Left, pad: 1}\n"
           "  - hold-pad-button: {button: Start, pad: 1}\n"
           "  - press-pad-button: {button: Down, pad: 2, for: 40ms}\n"
           "  - delay: 40ms\n  - unplug-usb: {device: snes-gamepad, pad: 2}\n  - delay: 40ms\n",
           R"(driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
driver usbhid
claim EBUSY, detach 0, again ENODATA, claim 0
pad 1: 01 7f 7f 7f 7f 0f 00 00
pad 2: 01 7f 7f 7f 7f 0f 00 00
ready
pad 2: 01 7f 7f 7f 7f 2f 00 00
pad 2: 01 7f 7f 7f ff 0f 00 00
pad 1: 01 7f 7f 00 7f 1f 20 00
pad 2: 01 7f 7f 7f 7f 0f 00 00
pad 2 ESHUTDOWN
)");
}

TEST_F(LinuxUsb, NumbersDevicesInTheOrderOfTheList) {
    prints("usbfs", "lists", "usb: [gamepad, keyboard, snes-gamepad]\n", "", "  - delay: 200ms\n",
           R"(62656572
1-0:1.0: 09 00
1-1: 1 2 480 1 0424 2512 -
1-1.1: 1 3 1.5 1 0079 0006 USB Gamepad
1-1.1:1.0: 03 00
1-1.2: 1 4 1.5 1 04d9 0001 USB Keyboard
1-1.2:1.0: 03 01
1-1.3: 1 5 1.5 1 0079 0011 USB Gamepad )"
           R"(
1-1.3:1.0: 03 00
1-1:1.0: 09 00
usb1: 1 1 480 1 1d6b 0002 DWC OTG Controller
nodes: . .. 001 002 003 004 005
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
