// usb_snes_gamepad.h - the USB gamepad in the shape of a SNES controller, 0079:0011: a HID.
//
//   byte 0 - 2  01 7F 7F
//   3, 4        the d-pad: 0 left, FF right; 0 up, FF down; 7F released
//   5           F; X, A, B, Y from bit 4
//   6           L, R, -, -, Select, Start, from bit 0
//   7           0
//
// It has a report at each poll, whether something has changed or not.  There are many of that
// number, which differ in name, power and descriptors: this is the one of which the Linux driver
// hid-dr corrects the report descriptor, which names four axes X.
//
// Source: `lsusb -v` of such a gamepad; Linux 6.1, drivers/hid/hid-dr.c; public programs that read
// it with libusb.
#pragma once

#include "sim/board/usb_gamepad.h"

namespace sim {

class UsbSnesGamepad final : public UsbGamepad {
public:
    explicit UsbSnesGamepad(bool is_plugged);

    std::vector<int> axes() const override;  // of the d-pad, from 0 to 255

private:
    UsbBytes report(bool boot) const override;
};

}  // namespace sim
