// usb.cpp - plug-usb, unplug-usb: what is in the USB host ports
#include <optional>

#include <fmt/format.h>

#include "sim/board/usb_ports.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

constexpr const char* USB_DEVICES[] = {"keyboard", "mouse", "gamepad", "snes-gamepad"};  // UsbPlug

class PlugUsb : public Action {
public:
    PlugUsb(const Values& v, bool in) : plug_{v.number<UsbPlug>("device")}, in_{in} {
        if (v.find("pad")) pad_ = v.number<unsigned>("pad");
    }

    std::string describe() const override {
        return fmt::format("{} the USB {}{}", in_ ? "plug in" : "unplug",
                           USB_DEVICES[static_cast<std::size_t>(plug_)],
                           pad_ ? fmt::format(", pad {}", *pad_) : "");
    }
    void check(StaticChecks& checks) const override { checks.plug(plug_, pad_, in_); }
    void act(BoardControl& board) const override {
        auto& ports = board.part<UsbPorts>("USB ports");
        board.act([&device = ports.device(meant(ports.plugged())), in = in_] { device.plug(in); });
    }

private:
    UsbPlugged meant(const UsbPlugs& plugged) const {
        if (!in_) return plugged.of(plug_, pad_).front();
        return {plug_, is_gamepad(plug_) ? pad_.value_or(plugged.free_number()) : 0};
    }

    UsbPlug plug_;
    std::optional<unsigned> pad_;
    bool in_;
};

const ValueType USB_DEVICE = word("keyboard, mouse, gamepad or snes-gamepad",
                                  {std::begin(USB_DEVICES), std::end(USB_DEVICES)});

}  // namespace

namespace steps {

std::vector<StepForm> usb() {
    const Field device{"device", USB_DEVICE, Need::REQUIRED, "",
                       "keyboard, mouse, gamepad or snes-gamepad."};
    return {
        {"plug-usb",
         "Plug a device into a USB host port, for a Linux program: its nodes below /dev/input and "
         "/dev/bus/usb are there, and libusb hears of it.",
         Notation::BOTH,
         {},
         {device,
          {"pad", PAD, Need::OPTIONAL, "",
           "The gamepad's number for other steps; without it the lowest that is free."}},
         [](const Values& values) -> std::unique_ptr<Step> {
             return std::make_unique<PlugUsb>(values, true);
         }},
        {"unplug-usb",
         "Unplug a device from USB: its nodes are gone, and reading one that is open is the error "
         "ENODEV.",
         Notation::BOTH,
         {},
         {device,
          {"pad", PAD, Need::OPTIONAL, "",
           "Which of two gamepads of a kind, by its number: 1 is the first of usb."}},
         [](const Values& values) -> std::unique_ptr<Step> {
             return std::make_unique<PlugUsb>(values, false);
         }},
    };
}

}  // namespace steps

}  // namespace sim
