#include "sim/linux/gpio.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "sim/hps/hps_gpio.h"
#include "sim/hps/peripherals.h"

namespace sim {

namespace {

constexpr const char* GPIO_CLASS = "/sys/class/gpio/";
constexpr unsigned RISING = 1, FALLING = 2;
constexpr const char* EDGES[] = {"none", "rising", "falling", "both"};
constexpr unsigned FIRST_GPIO_ID = 196;  // of the GIC

}  // namespace

const std::array<LinuxGpio::Chip, 3>& LinuxGpio::chips() {
    constexpr std::uint32_t STEP = 0x1000;
    static const std::array<Chip, 3> all{{
        {483, 29, Peripherals::GPIO1_BASE - STEP, FIRST_GPIO_ID, "ff708000.gpio"},
        {454, 29, Peripherals::GPIO1_BASE, FIRST_GPIO_ID + 1, "ff709000.gpio"},
        {427, 27, Peripherals::GPIO1_BASE + STEP, FIRST_GPIO_ID + 2, "ff70a000.gpio"},
    }};
    return all;
}

const LinuxGpio::Chip* LinuxGpio::chip_of(long number) {
    for (const Chip& chip : chips())
        if (number >= static_cast<long>(chip.base) &&
            number < static_cast<long>(chip.base + chip.pins))
            return &chip;
    return nullptr;
}

// ---- The files ----------------------------------------------------------------------------------

std::string LinuxGpio::folder_of(const Chip& chip) {
    return fmt::format("/sys/devices/platform/soc/{}/", chip.name);
}

void LinuxGpio::add(Attributes& all, const Chip& chip) const {
    const std::string folder = fmt::format("{}gpio/gpiochip{}/", folder_of(chip), chip.base);
    all[folder + "base"] = {[&chip] { return fmt::format("{}\n", chip.base); }};
    all[folder + "label"] = {[&chip] { return std::string{chip.name} + "\n"; }};
    all[folder + "ngpio"] = {[&chip] { return fmt::format("{}\n", chip.pins); }};
}

void LinuxGpio::add(Attributes& all, unsigned number, Pin& pin) {
    const std::string folder = fmt::format("{}gpiochip{}/gpio/gpio{}/", folder_of(pin.chip),
                                           &pin.chip - chips().data(), number);
    all[folder + "direction"] = {
        [this, &pin] { return std::string{is_output(pin) ? "out\n" : "in\n"}; },
        [this, &pin](const std::string& text) { return set_direction(pin, text); }, pin.changes};
    all[folder + "value"] = {[this, &pin] {
                                 const bool high = read(pin, HpsGpio::PINS) & pin.bit;
                                 return std::string{high != pin.active_low ? "1\n" : "0\n"};
                             },
                             [this, &pin](const std::string& text) { return set_value(pin, text); },
                             pin.changes};
    all[folder + "edge"] = {[&pin] { return std::string{EDGES[pin.edges]} + "\n"; },
                            [this, &pin](const std::string& text) { return set_edge(pin, text); },
                            pin.changes};
    all[folder + "active_low"] = {
        [&pin] { return std::string{pin.active_low ? "1\n" : "0\n"}; },
        [this, &pin](const std::string& text) { return set_active_low(pin, text); }, pin.changes};
}

LinuxGpio::Attributes LinuxGpio::attributes() {
    Attributes all;
    all[std::string{GPIO_CLASS} + "export"] = {
        {}, [this](const std::string& text) { return export_pin(text); }};
    all[std::string{GPIO_CLASS} + "unexport"] = {
        {}, [this](const std::string& text) { return unexport_pin(text); }};
    for (const Chip& chip : chips()) add(all, chip);
    for (auto& [number, pin] : pins_) add(all, number, pin);
    return all;
}

void LinuxGpio::list(OwnFiles& files) {
    constexpr const char* ROOT = "../../devices/platform/soc";
    for (const auto& [path, attribute] : attributes()) files.add(path);
    for (const Chip& chip : chips())
        files.add_link(fmt::format("{}gpiochip{}", GPIO_CLASS, chip.base),
                       fmt::format("{}/{}/gpio/gpiochip{}", ROOT, chip.name, chip.base));
    for (const auto& [number, pin] : pins_)
        files.add_link(fmt::format("{}gpio{}", GPIO_CLASS, number),
                       fmt::format("{}/{}/gpiochip{}/gpio/gpio{}", ROOT, pin.chip.name,
                                   &pin.chip - chips().data(), number));
}

std::shared_ptr<AttributeFile> LinuxGpio::open(const std::string& path) {
    if (path.rfind(GPIO_CLASS, 0) != 0 && path.find(".gpio/") == std::string::npos) return nullptr;
    Attributes all = attributes();
    const auto found = all.find(path);
    if (found == all.end()) return nullptr;
    return std::make_shared<AttributeFile>(path, std::move(found->second));
}

// ---- What is written ----------------------------------------------------------------------------

int LinuxGpio::export_pin(const std::string& text) {
    long number = 0;
    if (const int error = attribute::number_in(text, 0, number)) return error;
    const Chip* const chip = chip_of(number);
    if (!chip) return -EINVAL;
    const auto pin = static_cast<unsigned>(number);
    if (is_exported(pin) || outside_.is_taken(pin)) return -EBUSY;
    pins_.emplace(pin, Pin{*chip, 1u << (pin - chip->base)});
    return 0;
}

int LinuxGpio::unexport_pin(const std::string& text) {
    long number = 0;
    if (const int error = attribute::number_in(text, 0, number)) return error;
    if (number < 0) return -EINVAL;
    const auto found = pins_.find(static_cast<unsigned>(number));
    if (found == pins_.end()) return -EINVAL;
    Pin& pin = found->second;
    pin.edges = 0;
    await_edges(pin);
    ++pin.changes->count;
    pin.changes->gone = true;
    pins_.erase(found);
    return 0;
}

std::uint32_t LinuxGpio::read(const Pin& pin, std::uint32_t offset) const {
    return outside_.change(pin.chip.registers + offset, 0, 0);
}

void LinuxGpio::change(const Pin& pin, std::uint32_t offset, bool on) const {
    outside_.change(pin.chip.registers + offset, pin.bit, on ? pin.bit : 0);
}

bool LinuxGpio::is_output(const Pin& pin) const { return read(pin, HpsGpio::DIRECTION) & pin.bit; }

void LinuxGpio::drive(unsigned number, bool high) const {
    const Chip& chip = *chip_of(number);
    const Pin pin{chip, 1u << (number - chip.base)};
    change(pin, HpsGpio::DATA, high);
    change(pin, HpsGpio::DIRECTION, true);
}

int LinuxGpio::set_direction(Pin& pin, const std::string& text) {
    const bool high = attribute::is_word(text, "high");
    if (high || attribute::is_word(text, "low") || attribute::is_word(text, "out")) {
        if (pin.edges) return -EIO;
        change(pin, HpsGpio::DATA, high);
        change(pin, HpsGpio::DIRECTION, true);
        return 0;
    }
    if (!attribute::is_word(text, "in")) return -EINVAL;
    change(pin, HpsGpio::DIRECTION, false);
    return 0;
}

int LinuxGpio::set_value(Pin& pin, const std::string& text) {
    long value = 0;
    if (!is_output(pin)) return -EPERM;
    if (const int error = attribute::number_in(text, 0, value)) return error;
    change(pin, HpsGpio::DATA, (value != 0) != pin.active_low);
    return 0;
}

int LinuxGpio::set_edge(Pin& pin, const std::string& text) {
    unsigned edges = 0;
    while (edges < std::size(EDGES) && !attribute::is_word(text, EDGES[edges])) ++edges;
    if (edges == std::size(EDGES)) return -EINVAL;
    if (edges != 0 && is_output(pin)) return -EIO;
    if (edges != 0)
        if (const int error = outside_.listen(pin.chip.interrupt)) return error;
    if (std::exchange(pin.edges, edges) != edges) await_edges(pin);
    return 0;
}

int LinuxGpio::set_active_low(Pin& pin, const std::string& text) {
    long value = 0;
    if (const int error = attribute::number_in(text, 0, value)) return error;
    const bool active_low = value != 0;
    if (std::exchange(pin.active_low, active_low) != active_low) await_edges(pin);
    return 0;
}

// ---- Edges --------------------------------------------------------------------------------------

// As the chip's driver has it: an interrupt for one edge, and for both that one which comes next.
void LinuxGpio::await_edges(const Pin& pin) const {
    change(pin, HpsGpio::ENABLE, false);
    if (pin.edges == 0) return;
    const bool rises = pin.edges == (RISING | FALLING) ? !(read(pin, HpsGpio::PINS) & pin.bit)
                                                       : (pin.edges == RISING) != pin.active_low;
    change(pin, HpsGpio::TYPE, true);
    change(pin, HpsGpio::POLARITY, rises);
    change(pin, HpsGpio::MASK, false);
    change(pin, HpsGpio::EOI, true);
    change(pin, HpsGpio::ENABLE, true);
}

void LinuxGpio::interrupt(unsigned number) {
    for (auto& [own, pin] : pins_) {
        if (pin.chip.interrupt != number || !(read(pin, HpsGpio::STATUS) & pin.bit)) continue;
        if (pin.edges == (RISING | FALLING))
            change(pin, HpsGpio::POLARITY, !(read(pin, HpsGpio::PINS) & pin.bit));
        change(pin, HpsGpio::EOI, true);
        ++pin.changes->count;
    }
}

}  // namespace sim
