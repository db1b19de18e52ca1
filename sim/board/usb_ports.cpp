#include "sim/board/usb_ports.h"

#include <algorithm>
#include <iterator>

namespace sim {

template <class Kind>
std::vector<UsbPlugged> UsbPlugs::those(std::optional<unsigned> number, Kind is_meant) const {
    std::vector<UsbPlugged> found;
    std::copy_if(all.begin(), all.end(), std::back_inserter(found), [&](const UsbPlugged& one) {
        return is_meant(one.plug) && one.number == number.value_or(one.number);
    });
    return found;
}

std::vector<UsbPlugged> UsbPlugs::of(UsbPlug plug, std::optional<unsigned> number) const {
    return those(number, [&](UsbPlug one) { return one == plug; });
}

std::vector<UsbPlugged> UsbPlugs::gamepads(std::optional<unsigned> number) const {
    return those(number, is_gamepad);
}

unsigned UsbPlugs::free_number() const {
    for (unsigned number = 1; number <= GAMEPADS; ++number)
        if (gamepads(number).empty()) return number;
    return 0;
}

void UsbPlugs::unplug(const UsbPlugged& one) {
    all.erase(std::remove(all.begin(), all.end(), one), all.end());
}

namespace {

bool is_in(const UsbPlugs& plugs, const UsbPlugged& one) {
    return std::find(plugs.all.begin(), plugs.all.end(), one) != plugs.all.end();
}

template <class Gamepad>
std::array<Gamepad, UsbPlugs::GAMEPADS> two(const UsbPlugs& plugs, UsbPlug plug) {
    return {Gamepad{is_in(plugs, {plug, 1})}, Gamepad{is_in(plugs, {plug, 2})}};
}

}  // namespace

UsbPorts::UsbPorts(Agenda& the_agenda, const UsbPlugs& plugs)
    : agenda{the_agenda},
      keyboard{agenda, is_in(plugs, {UsbPlug::KEYBOARD})},
      mouse{is_in(plugs, {UsbPlug::MOUSE})},
      gamepads{two<UsbGamepad>(plugs, UsbPlug::GAMEPAD)},
      snes_gamepads{two<UsbSnesGamepad>(plugs, UsbPlug::SNES_GAMEPAD)} {
    for (const UsbPlugged& one : plugs.all) all_.push_back(&device(one));
    for (UsbDevice* const one : std::initializer_list<UsbDevice*>{
             &keyboard, &mouse, &gamepads[0], &gamepads[1], &snes_gamepads[0], &snes_gamepads[1]})
        if (!one->is_plugged()) all_.push_back(one);
}

UsbPlugs UsbPorts::plugged() const {
    UsbPlugs plugs{{}};
    if (keyboard.is_plugged()) plugs.plug({UsbPlug::KEYBOARD});
    if (mouse.is_plugged()) plugs.plug({UsbPlug::MOUSE});
    for (unsigned i = 0; i < UsbPlugs::GAMEPADS; ++i) {
        if (gamepads[i].is_plugged()) plugs.plug({UsbPlug::GAMEPAD, i + 1});
        if (snes_gamepads[i].is_plugged()) plugs.plug({UsbPlug::SNES_GAMEPAD, i + 1});
    }
    return plugs;
}

UsbDevice& UsbPorts::device(const UsbPlugged& one) {
    switch (one.plug) {
        case UsbPlug::KEYBOARD: return keyboard;
        case UsbPlug::MOUSE: return mouse;
        case UsbPlug::GAMEPAD: return gamepads.at(one.number - 1);
        default: return snes_gamepads.at(one.number - 1);
    }
}

}  // namespace sim
