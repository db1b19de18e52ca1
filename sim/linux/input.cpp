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

}  // namespace

// ---- The drivers --------------------------------------------------------------------------------

LinuxInput::Bound* LinuxInput::bound(UsbPlug plug) {
    const auto found = bound_.find(plug);
    return found == bound_.end() ? nullptr : &found->second;
}

void LinuxInput::attach(UsbPorts& ports) {
    using namespace input_event;
    agenda_ = &ports.agenda;
    ports.keyboard.on_key([this](std::uint16_t key, bool down) {
        Bound* const one = bound(UsbPlug::KEYBOARD);
        const std::uint16_t number = key_number(key);
        if (!one || number == 0) return;
        one->device->event(MSC, MSC_SCAN, static_cast<int>(KEYBOARD_PAGE + hid_usage(key)));
        one->device->event(KEY, number, down);
        one->device->report();
    });
    const auto button = [this](UsbPlug plug, std::uint16_t first, unsigned which, bool down) {
        Bound* const one = bound(plug);
        if (!one) return;
        one->device->event(MSC, MSC_SCAN, static_cast<int>(BUTTON_PAGE + which + 1));
        one->device->event(KEY, static_cast<std::uint16_t>(first + which), down);
        one->device->report();
    };
    UsbMouse::Listener mouse;
    mouse.move = [this](int right, int up) {
        Bound* const one = bound(UsbPlug::MOUSE);
        if (!one || (right == 0 && up == 0)) return;
        one->device->event(REL, REL_X, right);
        one->device->event(REL, REL_Y, -up);
        one->device->report();
    };
    mouse.turn = [this](int notches) {
        Bound* const one = bound(UsbPlug::MOUSE);
        if (!one || notches == 0) return;
        one->device->event(REL, REL_WHEEL, -notches);
        one->device->event(REL, REL_WHEEL_HI_RES, -notches * WHEEL_STEP);
        one->device->report();
    };
    mouse.button = [button](MouseButton which, bool down) {
        button(UsbPlug::MOUSE, BTN_LEFT, static_cast<unsigned>(which), down);
    };
    ports.mouse.on_hand(std::move(mouse));
    UsbGamepad::Listener gamepad;
    gamepad.button = [button](unsigned number, bool down) {
        button(UsbPlug::GAMEPAD, BTN_GAMEPAD, number, down);
    };
    gamepad.axes = [this, &pad = ports.gamepad] {
        if (!bound(UsbPlug::GAMEPAD)) return;
        axes(pad);
        bound(UsbPlug::GAMEPAD)->device->report();
    };
    ports.gamepad.on_hand(std::move(gamepad));
}

void LinuxInput::axes(const UsbGamepad& gamepad) {
    using namespace input_event;
    InputDevice& device = *bound(UsbPlug::GAMEPAD)->device;
    const auto sticks = gamepad.sticks();
    std::size_t next = 0;
    for (const std::uint16_t axis : {ABS_X, ABS_Y, ABS_Z, ABS_RZ})
        device.event(ABS, axis, sticks[next++]);
    device.event(ABS, ABS_HAT0X, gamepad.pad()[0]);
    device.event(ABS, ABS_HAT0Y, gamepad.pad()[1]);
}

void LinuxInput::bind(const UsbDevice& usb, const std::string& port, const std::string& folder) {
    using namespace input_event;
    const UsbDevice::About& about = usb.about();
    const unsigned number = next_input_++;
    const auto device = std::make_shared<InputDevice>(
        InputDevice::About{about.name, fmt::format("usb-ffb40000.usb-{}/input0", port.substr(2)),
                           fmt::format("{}/0003:{:04X}:{:04X}.{:04X}/input/input{}", folder,
                                       about.vendor, about.product, number + 1, number),
                           about.vendor, about.product, about.release},
        *agenda_, notify_);
    device->can(MSC, {MSC_SCAN});
    bound_[about.plug] = {device, port, number};
    switch (about.plug) {
        case UsbPlug::KEYBOARD:
            for (const KeyRow& row : key_rows())
                for (unsigned i = 0; i < row.names.size(); ++i)
                    device->can(KEY, {static_cast<std::uint16_t>(row.first + i)});
            device->can(LED, {0, 1, 2});
            device->can(REP, {0, 1});
            break;
        case UsbPlug::MOUSE:
            device->can(KEY, {BTN_LEFT, BTN_LEFT + 1, BTN_LEFT + 2});
            device->can(REL, {REL_X, REL_Y, REL_WHEEL, REL_WHEEL_HI_RES});
            for (const auto& mice : mice_) device->add(mice);
            break;
        case UsbPlug::GAMEPAD:
            for (unsigned i = 0; i < UsbGamepad::BUTTONS; ++i)
                device->can(KEY, {static_cast<std::uint16_t>(BTN_GAMEPAD + i)});
            for (const std::uint16_t axis : {ABS_X, ABS_Y, ABS_Z, ABS_RZ})
                device->has_axis(axis, {0, 0, 255, 0, 255 >> 4, 0});
            for (const std::uint16_t axis : {ABS_HAT0X, ABS_HAT0Y})
                device->has_axis(axis, {0, -1, 1, 0, 0, 0});
            axes(static_cast<const UsbGamepad&>(usb));
            break;
    }
    unsigned lowest = 0;
    while (numbers_.count(lowest)) ++lowest;
    numbers_[lowest] = about.plug;
}

void LinuxInput::unbind(const UsbDevice& usb) {
    const UsbPlug plug = usb.about().plug;
    Bound* const one = bound(plug);
    if (!one) return;
    const auto device = one->device;
    bound_.erase(plug);
    for (auto at = numbers_.begin(); at != numbers_.end();)
        at = at->second == plug ? numbers_.erase(at) : std::next(at);
    device->disconnect();
}

// ---- The files ----------------------------------------------------------------------------------

std::shared_ptr<LinuxDevice> LinuxInput::open(const std::string& path) {
    const auto listening = [](auto device, auto file) {
        if (device) device->add(file);
        return file;
    };
    for (const auto& [number, plug] : numbers_)
        if (path == fmt::format("/dev/input/event{}", number)) {
            const auto device = bound(plug)->device;
            return listening(device, std::make_shared<EventFile>(device, number));
        }
    Bound* const mouse = bound(UsbPlug::MOUSE);
    Bound* const gamepad = bound(UsbPlug::GAMEPAD);
    if (path == "/dev/input/mouse0" && mouse)
        return listening(mouse->device, std::make_shared<MiceFile>(mouse->device, FIRST_MOUSE));
    if (path == "/dev/input/js0" && gamepad)
        return listening(gamepad->device, std::make_shared<JoystickFile>(gamepad->device, 0));
    if (path != "/dev/input/mice") return nullptr;
    const auto mice = std::make_shared<MiceFile>(nullptr, MICE);
    mice_.erase(
        std::remove_if(mice_.begin(), mice_.end(), [](const auto& file) { return file.expired(); }),
        mice_.end());
    mice_.push_back(mice);
    return listening(mouse ? mouse->device : nullptr, mice);
}

void LinuxInput::describe(const Bound& one, UsbPlug plug, unsigned number, OwnFiles& files) const {
    const InputDevice::About& about = one.device->about();
    const std::string event = fmt::format("event{}", number);
    const std::string by_id = fmt::format("/dev/input/by-id/usb-{:04x}_", about.vendor) + [&] {
        std::string name = about.name;
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
    if (plug == UsbPlug::GAMEPAD) {
        add_node("js0", 0);
        add_links("-joystick", "js0");
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
    for (const auto& [number, plug] : numbers_) {
        const Bound& one = bound_.at(plug);
        const InputDevice& device = *one.device;
        const InputDevice::About& about = device.about();
        describe(one, plug, number, files);
        text += fmt::format(
            "I: Bus=0003 Vendor={:04x} Product={:04x} Version={:04x}\nN: Name=\"{}\"\nP: Phys={}\n"
            "S: Sysfs={}\nU: Uniq=\nH: Handlers={}event{} {}\nB: PROP=0\nB: EV={}\n",
            about.vendor, about.product, about.version, about.name, about.place,
            about.folder.substr(4),
            plug == UsbPlug::KEYBOARD ? "sysrq kbd leds "
            : plug == UsbPlug::MOUSE  ? "mouse0 "
                                      : "",
            number, plug == UsbPlug::GAMEPAD ? "js0 " : "", bitmap(device.bits(SYN)));
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
