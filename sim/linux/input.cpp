#include "sim/linux/input.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/board/scan_codes.h"
#include "sim/linux/event_file.h"
#include "sim/linux/joystick_file.h"
#include "sim/linux/mice_file.h"

namespace sim {

namespace {

constexpr std::uint32_t KEYBOARD_PAGE = 0x70000, BUTTON_PAGE = 0x90000;  // of HID usages
constexpr int WHEEL_STEP = 120;

// Linux's numbers of keys, by the names of ours, in rows of consecutive numbers.
struct KeyRow {
    std::uint16_t first;
    std::vector<std::string> names;
};

const std::vector<KeyRow>& key_rows() {
    static const std::vector<KeyRow> rows{
        {1, {"Esc",        "1",           "2",       "3",          "4",          "5",
             "6",          "7",           "8",       "9",          "0",          "-",
             "=",          "Backspace",   "Tab",     "q",          "w",          "e",
             "r",          "t",           "y",       "u",          "i",          "o",
             "p",          "[",           "]",       "Enter",      "Ctrl",       "a",
             "s",          "d",           "f",       "g",          "h",          "j",
             "k",          "l",           ";",       "'",          "`",          "Shift",
             "\\",         "z",           "x",       "c",          "v",          "b",
             "n",          "m",           ",",       ".",          "/",          "RightShift",
             "NumpadStar", "Alt",         "Space",   "CapsLock",   "F1",         "F2",
             "F3",         "F4",          "F5",      "F6",         "F7",         "F8",
             "F9",         "F10",         "NumLock", "ScrollLock", "Numpad7",    "Numpad8",
             "Numpad9",    "NumpadMinus", "Numpad4", "Numpad5",    "Numpad6",    "NumpadPlus",
             "Numpad1",    "Numpad2",     "Numpad3", "Numpad0",    "NumpadPoint"}},
        {87, {"F11", "F12"}},
        {96, {"NumpadEnter", "RightCtrl", "NumpadSlash", "PrintScreen", "RightAlt"}},
        {102,
         {"Home", "Up", "PageUp", "Left", "Right", "End", "Down", "PageDown", "Insert", "Delete"}},
        {119, {"Pause"}},
        {125, {"Win", "RightWin", "Menu"}},
    };
    return rows;
}

// 0: Linux has none for it.
std::uint16_t key_number(std::uint16_t scan_code) {
    for (const Key& key : keys()) {
        if (key.code != scan_code) continue;
        for (const KeyRow& row : key_rows()) {
            const auto at = std::find(row.names.begin(), row.names.end(), key.name);
            if (at != row.names.end())
                return static_cast<std::uint16_t>(row.first + (at - row.names.begin()));
        }
    }
    return 0;
}

// As %lx of each word of 32 bits, from the first that is not 0.
std::string bitmap(const std::vector<std::uint8_t>& bits) {
    std::string text;
    for (std::size_t at = bits.size(); at >= 4; at -= 4) {
        std::uint32_t word = 0;
        for (std::size_t i = 1; i <= 4; ++i) word = word << 8 | bits[at - i];
        if (word != 0 || !text.empty()) text += fmt::format(text.empty() ? "{:x}" : " {:x}", word);
    }
    return text.empty() ? "0" : text;
}

const char* kind_of(UsbPlug plug) {
    return plug == UsbPlug::KEYBOARD ? "kbd" : plug == UsbPlug::MOUSE ? "mouse" : "joystick";
}

// Of a gamepad: its first button and its axes, as the drivers number them.
std::uint16_t first_button(UsbPlug plug) {
    return plug == UsbPlug::GAMEPAD ? input_event::BTN_GAMEPAD : input_event::BTN_JOYSTICK;
}

std::vector<std::uint16_t> axes_of(UsbPlug plug) {
    using namespace input_event;
    if (plug == UsbPlug::SNES_GAMEPAD) return {ABS_X, ABS_Y};
    return {ABS_X, ABS_Y, ABS_Z, ABS_RZ, ABS_HAT0X, ABS_HAT0Y};
}

void send_axes(InputDevice& device, const UsbGamepad& gamepad) {
    const std::vector<std::uint16_t> axes = axes_of(gamepad.about().plug);
    const std::vector<int> places = gamepad.axes();
    for (std::size_t i = 0; i < axes.size(); ++i)
        device.event(input_event::ABS, axes[i], places[i]);
}

void send_button(InputDevice& device, std::uint16_t first, unsigned which, bool down) {
    using namespace input_event;
    device.event(MSC, MSC_SCAN, static_cast<int>(BUTTON_PAGE + which + 1));
    device.event(KEY, static_cast<std::uint16_t>(first + which), down);
}

void describe_gamepad(InputDevice& device, const UsbGamepad& gamepad) {
    using namespace input_event;
    const UsbPlug plug = gamepad.about().plug;
    const unsigned buttons = plug == UsbPlug::GAMEPAD ? 15 : 10;
    for (unsigned i = 0; i < buttons; ++i)
        device.can(KEY, {static_cast<std::uint16_t>(first_button(plug) + i)});
    for (const std::uint16_t axis : axes_of(plug))
        device.has_axis(axis, axis < ABS_HAT0X ? InputDevice::Axis{0, 0, 255, 0, 255 >> 4, 0}
                                               : InputDevice::Axis{0, -1, 1, 0, 0, 0});
    send_axes(device, gamepad);
}

}  // namespace

// ---- The drivers --------------------------------------------------------------------------------

void LinuxInput::send(const UsbDevice& usb, const Event& event) {
    for (auto& [number, one] : bound_) {
        if (one.usb != &usb) continue;
        event(*one.device);
        one.device->report();
    }
}

void LinuxInput::attach(UsbPorts& ports) {
    using namespace input_event;
    agenda_ = &ports.agenda;
    ports.keyboard.on_key([this, &usb = ports.keyboard](std::uint16_t key, bool down) {
        const std::uint16_t number = key_number(key);
        if (number == 0) return;
        send(usb, [&](InputDevice& device) {
            device.event(MSC, MSC_SCAN, static_cast<int>(KEYBOARD_PAGE + hid_usage(key)));
            device.event(KEY, number, down);
        });
    });
    UsbMouse::Listener mouse;
    mouse.move = [this, &usb = ports.mouse](int right, int up) {
        if (right == 0 && up == 0) return;
        send(usb, [&](InputDevice& device) {
            device.event(REL, REL_X, right);
            device.event(REL, REL_Y, -up);
        });
    };
    mouse.turn = [this, &usb = ports.mouse](int notches) {
        if (notches == 0) return;
        send(usb, [&](InputDevice& device) {
            device.event(REL, REL_WHEEL, -notches);
            device.event(REL, REL_WHEEL_HI_RES, -notches * WHEEL_STEP);
        });
    };
    mouse.button = [this, &usb = ports.mouse](MouseButton which, bool down) {
        send(usb, [&](InputDevice& device) {
            send_button(device, BTN_LEFT, static_cast<unsigned>(which), down);
        });
    };
    ports.mouse.on_hand(std::move(mouse));
    for (UsbGamepad& gamepad : ports.gamepads) attach(gamepad);
    for (UsbGamepad& gamepad : ports.snes_gamepads) attach(gamepad);
}

void LinuxInput::attach(UsbGamepad& gamepad) {
    UsbGamepad::Listener listener;
    listener.button = [this, &gamepad](unsigned number, bool down) {
        send(gamepad, [&](InputDevice& device) {
            send_button(device, first_button(gamepad.about().plug), number, down);
        });
    };
    listener.axes = [this, &gamepad] {
        send(gamepad, [&](InputDevice& device) { send_axes(device, gamepad); });
    };
    gamepad.on_hand(std::move(listener));
}

void LinuxInput::bind(const UsbDevice& usb, const std::string& port, const std::string& folder) {
    using namespace input_event;
    const UsbDevice::About& about = usb.about();
    const unsigned number = next_input_++;
    const auto device = std::make_shared<InputDevice>(
        InputDevice::About{about.name, fmt::format("usb-ffb40000.usb-{}/input0", port.substr(2)),
                           fmt::format("{}/0003:{:04X}:{:04X}.{:04X}/input/input{}", folder,
                                       about.vendor, about.product, number + 1, number),
                           about.vendor, about.product, about.hid},
        *agenda_, notify_);
    device->can(MSC, {MSC_SCAN});
    if (about.plug == UsbPlug::KEYBOARD) {
        for (const KeyRow& row : key_rows())
            for (unsigned i = 0; i < row.names.size(); ++i)
                device->can(KEY, {static_cast<std::uint16_t>(row.first + i)});
        device->can(LED, {0, 1, 2});
        device->can(REP, {0, 1});
    } else if (about.plug == UsbPlug::MOUSE) {
        device->can(KEY, {BTN_LEFT, BTN_LEFT + 1, BTN_LEFT + 2});
        device->can(REL, {REL_X, REL_Y, REL_WHEEL, REL_WHEEL_HI_RES});
        for (const auto& mice : mice_) device->add(mice);
    } else {
        describe_gamepad(*device, static_cast<const UsbGamepad&>(usb));
    }
    unsigned event = 0, joystick = 0;
    while (bound_.count(event)) ++event;
    const auto is_taken = [&](const auto& one) {
        return is_gamepad(one.second.usb->about().plug) && one.second.joystick == joystick;
    };
    while (std::any_of(bound_.begin(), bound_.end(), is_taken)) ++joystick;
    bound_[event] = {&usb, device, port, joystick};
}

void LinuxInput::unbind(const UsbDevice& usb) {
    const auto at = std::find_if(bound_.begin(), bound_.end(),
                                 [&](const auto& one) { return one.second.usb == &usb; });
    if (at == bound_.end()) return;
    const auto device = at->second.device;
    bound_.erase(at);
    device->disconnect();
}

// ---- The files ----------------------------------------------------------------------------------

std::shared_ptr<InputDevice> LinuxInput::first_mouse() const {
    for (const auto& [number, one] : bound_)
        if (one.usb->about().plug == UsbPlug::MOUSE) return one.device;
    return nullptr;
}

std::shared_ptr<LinuxDevice> LinuxInput::open(const std::string& path) {
    const auto listening = [](auto device, auto file) {
        if (device) device->add(file);
        return file;
    };
    for (const auto& [number, one] : bound_) {
        if (path == fmt::format("/dev/input/event{}", number))
            return listening(one.device, std::make_shared<EventFile>(one.device, number));
        if (is_gamepad(one.usb->about().plug) &&
            path == fmt::format("/dev/input/js{}", one.joystick))
            return listening(one.device, std::make_shared<JoystickFile>(one.device, one.joystick));
    }
    const auto mouse = first_mouse();
    if (path == "/dev/input/mouse0" && mouse)
        return listening(mouse, std::make_shared<MiceFile>(mouse, FIRST_MOUSE));
    if (path != "/dev/input/mice") return nullptr;
    const auto mice = std::make_shared<MiceFile>(nullptr, MICE);
    mice_.erase(
        std::remove_if(mice_.begin(), mice_.end(), [](const auto& file) { return file.expired(); }),
        mice_.end());
    mice_.push_back(mice);
    return listening(mouse, mice);
}

void LinuxInput::describe(const Bound& one, unsigned number, OwnFiles& files) const {
    const UsbPlug plug = one.usb->about().plug;
    const InputDevice::About& about = one.device->about();
    const std::string event = fmt::format("event{}", number);
    const std::string by_id = fmt::format("/dev/input/by-id/usb-{:04x}_", about.vendor) + [&] {
        std::string name = about.name;
        if (name.back() == ' ') name.pop_back();
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    }();
    const std::string by_path =
        fmt::format("/dev/input/by-path/platform-ffb40000.usb-usb-0:{}:1.0", one.port.substr(2));
    const auto add_links = [&](const std::string& ending, const std::string& file) {
        files.add_link(by_id + ending, "../" + file);
        files.add_link(by_path + ending, "../" + file);
    };
    const auto add_node = [&](const std::string& name, unsigned minor) {
        files.add("/dev/input/" + name);
        files.add_text(about.folder + "/" + name + "/dev", fmt::format("13:{}\n", minor));
        files.add_text(about.folder + "/" + name + "/uevent",
                       fmt::format("MAJOR=13\nMINOR={}\nDEVNAME=input/{}\n", minor, name));
        files.add_link(about.folder + "/" + name + "/device",
                       "../../" + about.folder.substr(about.folder.rfind('/') + 1));
        files.add_link("/sys/class/input/" + name, "../.." + about.folder.substr(4) + "/" + name);
    };
    add_node(event, 64 + number);
    add_links(fmt::format("-event-{}", kind_of(plug)), event);
    if (plug == UsbPlug::MOUSE) {
        add_node("mouse0", FIRST_MOUSE);
        add_links("-mouse", "mouse0");
    }
    if (is_gamepad(plug)) {
        const std::string joystick = fmt::format("js{}", one.joystick);
        add_node(joystick, one.joystick);
        add_links("-joystick", joystick);
    }
    files.add_text(about.folder + "/name", about.name + "\n");
    files.add_text(about.folder + "/phys", about.place + "\n");
    files.add_text(about.folder + "/uniq", "\n");
    files.add_text(about.folder + "/id/bustype", "0003\n");
    files.add_text(about.folder + "/id/vendor", fmt::format("{:04x}\n", about.vendor));
    files.add_text(about.folder + "/id/product", fmt::format("{:04x}\n", about.product));
    files.add_text(about.folder + "/id/version", fmt::format("{:04x}\n", about.version));
}

void LinuxInput::list(OwnFiles& files) const {
    using namespace input_event;
    std::string text;
    for (const auto& [number, one] : bound_) {
        const UsbPlug plug = one.usb->about().plug;
        const InputDevice& device = *one.device;
        const InputDevice::About& about = device.about();
        describe(one, number, files);
        text += fmt::format(
            "I: Bus=0003 Vendor={:04x} Product={:04x} Version={:04x}\nN: Name=\"{}\"\nP: Phys={}\n"
            "S: Sysfs={}\nU: Uniq=\nH: Handlers={}event{} {}\nB: PROP=0\nB: EV={}\n",
            about.vendor, about.product, about.version, about.name, about.place,
            about.folder.substr(4),
            plug == UsbPlug::KEYBOARD ? "sysrq kbd leds "
            : plug == UsbPlug::MOUSE  ? "mouse0 "
                                      : "",
            number, is_gamepad(plug) ? fmt::format("js{} ", one.joystick) : "",
            bitmap(device.bits(SYN)));
        const std::pair<std::uint16_t, const char*> kinds[] = {
            {KEY, "KEY"}, {REL, "REL"}, {ABS, "ABS"}, {MSC, "MSC"}, {LED, "LED"}};
        for (const auto& [type, name] : kinds)
            if (device.has(type))
                text += fmt::format("B: {}={}\n", name, bitmap(device.bits(type)));
        text += "\n";
    }
    files.add_text("/proc/bus/input/devices", text);
    files.add("/dev/input/mice");
    files.add_link("/sys/class/input/mice", "../../devices/virtual/input/mice");
    files.add_text("/sys/devices/virtual/input/mice/dev", fmt::format("13:{}\n", MICE));
}

}  // namespace sim
