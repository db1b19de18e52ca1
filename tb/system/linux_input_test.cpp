// linux_input_test.cpp - what a Linux program has of the USB ports as input devices.
#include "tb/system/on_usb.h"

namespace {

using tb::WITH_A_GAMEPAD;
using ::testing::HasSubstr;

class LinuxInput : public tb::OnUsb {};

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

TEST_F(LinuxInput, HasTwoGamepadsAsJoysticks) {
    prints("input", "pads", "usb: [snes-gamepad, gamepad]\n", "ready",
           "  - press-pad-button: {button: A, pad: 1}\n"
           "  - press-pad-button: {button: A, pad: 2}\n"
           "  - hold-pad-button: {button: Left, pad: 1}\n  - delay: 10ms\n"
           "  - hold-pad-button: {button: Start, pad: 1}\n"
           "  - press-pad-button: {button: Up, pad: 2}\n  - release-pad-button: Left\n"
           "  - delay: 10ms\n  - unplug-usb: snes-gamepad\n  - press-pad-button: Home\n"
           "  - delay: 200ms\n",
           R"(USB Gamepad , 3 0079:0011 0110, usb-ffb40000.usb-1.1/input0, 1, repeats ENOSYS 0 0
types 4: 0 1 3 4
keys 96: 288 289 290 291 292 293 294 295 296 297
movements 4:
axes 8: 0 1
lamps 4:
64 4 -1
axis 0: 127 in 0 to 255, 0, 15
axis 17: 0 in 0 to 0, 0, 0
USB Gamepad, 3 0079:0006 0110, usb-ffb40000.usb-1.2/input0, 1, repeats ENOSYS 0 0
types 4: 0 1 3 4
keys 96: 304 305 306 307 308 309 310 311 312 313 314 315 316 317 318
movements 4:
axes 8: 0 1 2 5 16 17
lamps 4:
64 4 -1
axis 0: 128 in 0 to 255, 0, 15
axis 17: 0 in -1 to 1, 0, 0
js0: 2 axes, 10 buttons
js1: 6 axes, 15 buttons
ready
js0 button 1: 1
js0 button 1: 0
js1 button 0: 1
js0 axis 0: -32767
js1 button 0: 0
js0 button 9: 1
js1 axis 5: -32767
js0 axis 0: 0
js1 axis 5: 0
js0 ENODEV
js1 button 12: 1
js1 button 12: 0
/dev/input/by-id
  usb-0079_USB_Gamepad-event-joystick -> ../event1
  usb-0079_USB_Gamepad-joystick -> ../js1
)");
}

TEST_F(LinuxInput, NeedsALinuxProgram) {
    for (const char* step : {"press-key: {key: a, to: usb}", "plug-usb: gamepad"})
        EXPECT_THAT(refuses(std::string{"steps:\n  - "} + step + "\n", LEDS_ELF),
                    HasSubstr("s.yaml:4:5: expected a Linux program, which has the USB ports, "
                              "got none"));
}

}  // namespace
