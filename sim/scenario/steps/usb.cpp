// usb.cpp - plug-usb, unplug-usb: what is in the USB host ports
#include <fmt/format.h>

#include "sim/board/usb_device.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

constexpr const char* USB_DEVICES[] = {"keyboard", "mouse", "gamepad"};  // as UsbPlug

class PlugUsb : public Action {
public:
    PlugUsb(const Values& v, bool in) : plug_{v.number<UsbPlug>("device")}, in_{in} {}

    std::string describe() const override {
        return fmt::format("{} the USB {}", in_ ? "plug in" : "unplug", name());
    }
    void check(StaticChecks& checks) const override { checks.plug(plug_, in_); }
    void act(BoardControl& board) const override {
        board.act(
            [&device = board.part<UsbDevice>("USB " + name()), in = in_] { device.plug(in); });
    }

private:
    std::string name() const { return USB_DEVICES[static_cast<std::size_t>(plug_)]; }

    UsbPlug plug_;
    bool in_;
};

const ValueType USB_DEVICE =
    word("keyboard, mouse or gamepad", {std::begin(USB_DEVICES), std::end(USB_DEVICES)});

}  // namespace

namespace steps {

std::vector<StepForm> usb() {
    const Field device{"device", USB_DEVICE, Need::REQUIRED, "", "keyboard, mouse or gamepad."};
    return {
        {"plug-usb",
         "Plug a device into a USB host port, for a Linux program: its nodes below /dev/input and "
         "/dev/bus/usb are there, and libusb hears of it.",
         Notation::BOTH,
         {},
         {device},
         [](const Values& values) -> std::unique_ptr<Step> {
             return std::make_unique<PlugUsb>(values, true);
         }},
        {"unplug-usb",
         "Unplug a device from USB: its nodes are gone, and reading one that is open is the error "
         "ENODEV.",
         Notation::BOTH,
         {},
         {device},
         [](const Values& values) -> std::unique_ptr<Step> {
             return std::make_unique<PlugUsb>(values, false);
         }},
    };
}

}  // namespace steps

}  // namespace sim
