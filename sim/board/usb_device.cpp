#include "sim/board/usb_device.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::uint8_t IN = 0x80, DEVICE = 1, CONFIGURATION = 2, TEXT = 3, INTERFACE = 4,
                       ENDPOINT = 5, HID = 0x21, REPORT = 0x22;

std::uint8_t low(std::size_t value) { return static_cast<std::uint8_t>(value); }
std::uint8_t high(std::size_t value) { return static_cast<std::uint8_t>(value >> 8); }

UsbBytes text_descriptor(const std::string& text) {
    UsbBytes bytes{low(2 + 2 * text.size()), TEXT};
    for (const char character : text) {
        bytes.push_back(static_cast<std::uint8_t>(character));
        bytes.push_back(0);
    }
    return bytes;
}

}  // namespace

// ---- Descriptors --------------------------------------------------------------------------------

UsbBytes UsbDevice::device_descriptor() const {
    return {18,
            DEVICE,
            low(about_.usb),
            high(about_.usb),
            0,
            0,
            0,
            PACKET,
            low(about_.vendor),
            high(about_.vendor),
            low(about_.product),
            high(about_.product),
            low(about_.release),
            high(about_.release),
            0,
            about_.name_index,
            0,
            1};
}

UsbBytes UsbDevice::hid_descriptor() const {
    const std::size_t bytes = about_.report_descriptor.size();
    return {9, HID,    low(about_.hid), high(about_.hid), about_.country,
            1, REPORT, low(bytes),      high(bytes)};
}

UsbBytes UsbDevice::configuration() const {
    constexpr std::uint8_t BYTES = 9 + 9 + 9 + 7, FROM_THE_BUS = 0x80, MA_100 = 50, INTERRUPT = 3,
                           INTERVAL_MS = 10;  // the host takes the power of 2 below
    UsbBytes all{9, CONFIGURATION, BYTES, 0, 1, 1, 0, FROM_THE_BUS, MA_100};
    const UsbBytes interface { 9, INTERFACE, 0, 0, 1, 3, about_.subclass, about_.protocol, 0 };
    const UsbBytes endpoint{7, ENDPOINT, 1 | IN, INTERRUPT, PACKET, 0, INTERVAL_MS};
    for (const UsbBytes& more : {interface, hid_descriptor(), endpoint})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::optional<UsbBytes> UsbDevice::descriptor(std::uint8_t type, std::uint8_t index) const {
    constexpr std::uint8_t ENGLISH[] = {0x09, 0x04};
    switch (type) {
        case DEVICE: return device_descriptor();
        case CONFIGURATION: return index == 0 ? std::optional{configuration()} : std::nullopt;
        case HID: return hid_descriptor();
        case REPORT: return about_.report_descriptor;
        case TEXT:
            if (index == 0) return UsbBytes{4, TEXT, ENGLISH[0], ENGLISH[1]};
            return index == about_.name_index ? std::optional{text_descriptor(about_.name)}
                                              : std::nullopt;
        default: return std::nullopt;
    }
}

// ---- Control transfers --------------------------------------------------------------------------

std::optional<UsbBytes> UsbDevice::control(const UsbSetup& setup, const UsbBytes& data) {
    constexpr std::uint8_t STATUS = 0, CLEAR_FEATURE = 1, GET_DESCRIPTOR = 6, GET_CONFIGURATION = 8,
                           SET_CONFIGURATION = 9, GET_INTERFACE = 10, SET_INTERFACE = 11,
                           CLASS = 0x20, GET_REPORT = 1, GET_IDLE = 2, GET_PROTOCOL = 3,
                           SET_REPORT = 9, SET_IDLE = 10, SET_PROTOCOL = 11, OUTPUT = 2;
    const auto answer = [&](std::optional<UsbBytes> bytes) {
        if (bytes) bytes->resize(std::min<std::size_t>(bytes->size(), setup.length));
        return bytes;
    };
    const bool in = setup.type & IN;
    if (setup.type & CLASS) {
        const std::uint8_t kind = high(setup.value);
        switch (setup.request) {
            case GET_REPORT: return in ? answer(report(boot_)) : std::nullopt;
            case GET_IDLE: return in ? answer(UsbBytes{idle_}) : std::nullopt;
            case GET_PROTOCOL: return in ? answer(UsbBytes{low(!boot_)}) : std::nullopt;
            case SET_REPORT:
                if (in || kind != OUTPUT || data.empty()) return std::nullopt;
                lamps_ = data[0];
                return data;
            case SET_IDLE: idle_ = kind; return data;
            case SET_PROTOCOL:
                if (about_.subclass == 0 || setup.value > 1) return std::nullopt;
                boot_ = setup.value == 0;
                return data;
            default: return std::nullopt;
        }
    }
    switch (setup.request) {
        case STATUS: return in ? answer(UsbBytes{0, 0}) : std::nullopt;
        case CLEAR_FEATURE: return data;
        case GET_DESCRIPTOR:
            return in ? answer(descriptor(high(setup.value), low(setup.value))) : std::nullopt;
        case GET_CONFIGURATION: return answer(UsbBytes{configured_});
        case SET_CONFIGURATION:
            if (setup.value > 1) return std::nullopt;
            configured_ = low(setup.value);
            return data;
        case GET_INTERFACE: return answer(UsbBytes{0});
        case SET_INTERFACE: return setup.value == 0 ? std::optional{data} : std::nullopt;
        default: return std::nullopt;
    }
}

// ---- The endpoint -------------------------------------------------------------------------------

void UsbDevice::changed() {
    if (is_plugged_ && !has_report() && has_news()) load();
}

void UsbDevice::load() {
    loaded_ = last_ = report(boot_);
    told();
    reported_();
}

UsbBytes UsbDevice::take_report() {
    if (about_.reports_always) return report(boot_);
    UsbBytes taken = std::move(*loaded_);
    loaded_.reset();
    if (has_news()) load();
    return taken;
}

void UsbDevice::reset() {
    boot_ = false;
    idle_ = lamps_ = 0;
    configured_ = 1;
    loaded_.reset();
    last_ = report(boot_);
    told();
}

void UsbDevice::plug(bool in) {
    if (is_plugged_ == in) return;
    is_plugged_ = in;
    reset();
    plugged_();
}

}  // namespace sim
