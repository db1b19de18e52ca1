#include "sim/linux/led.h"

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr const char* LED_FOLDER = "/sys/devices/platform/leds/leds/hps_led0/";
constexpr const char* LED_DRIVER = "/sys/bus/platform/drivers/leds-gpio/";
constexpr std::uint64_t NS_PER_MS = 1'000'000;
// On, off, on, off, in ms: the kernel's, without load.
constexpr std::uint64_t HEARTBEAT_MS[] = {70, 245, 70, 875};

}  // namespace

const std::map<std::string, LinuxLed::Trigger>& LinuxLed::triggers() {
    static const std::map<std::string, Trigger> all{{"none", Trigger::NONE},
                                                    {"timer", Trigger::TIMER},
                                                    {"heartbeat", Trigger::HEARTBEAT},
                                                    {"default-on", Trigger::DEFAULT_ON}};
    return all;
}

// ---- The files ----------------------------------------------------------------------------------

LinuxLed::Attributes LinuxLed::attributes() {
    Attributes all;
    for (const bool on : {false, true})
        all[std::string{LED_DRIVER} + (on ? "bind" : "unbind")] = {
            {}, [this, on](const std::string& text) { return bind(text, on); }};
    if (!bound_) return all;
    const auto add = [&](const char* name, std::function<std::string()> show,
                         std::function<int(const std::string&)> store) {
        all[std::string{LED_FOLDER} + name] = {std::move(show), std::move(store), changes_};
    };
    add(
        "brightness", [this] { return fmt::format("{}\n", brightness_); },
        [this](const std::string& text) { return set_brightness(text); });
    add("max_brightness", [] { return fmt::format("{}\n", MOST); }, {});
    add(
        "trigger", [this] { return trigger_text(); },
        [this](const std::string& text) { return set_trigger(text); });
    if (trigger_ == Trigger::TIMER)
        for (const unsigned which : {0u, 1u})
            add(
                which == 0 ? "delay_on" : "delay_off",
                [this, which] { return fmt::format("{}\n", delays_ms_[which]); },
                [this, which](const std::string& text) { return set_delay(which, text); });
    return all;
}

void LinuxLed::list(OwnFiles& files) {
    for (const auto& [path, attribute] : attributes()) files.add(path);
    files.add_folder("/sys/class/leds");
    if (!bound_) return;
    files.add_link("/sys/class/leds/hps_led0", "../../devices/platform/leds/leds/hps_led0");
    files.add_link(std::string{LED_DRIVER} + "leds", "../../../../devices/platform/leds");
}

std::shared_ptr<AttributeFile> LinuxLed::open(const std::string& path) {
    if (path.find("leds") == std::string::npos) return nullptr;
    Attributes all = attributes();
    const auto found = all.find(path);
    if (found == all.end()) return nullptr;
    return std::make_shared<AttributeFile>(path, std::move(found->second));
}

// "[none] timer heartbeat default-on"
std::string LinuxLed::trigger_text() const {
    std::string text;
    for (const char* name : {"none", "timer", "heartbeat", "default-on"}) {
        const bool present = triggers().at(name) == trigger_;
        text += (text.empty() ? "" : " ") + (present ? fmt::format("[{}]", name) : name);
    }
    return text + "\n";
}

// ---- What is written ----------------------------------------------------------------------------

void LinuxLed::set(long brightness) {
    brightness_ = std::min(brightness, MOST);
    outside_.light(brightness_ != 0);
}

int LinuxLed::set_brightness(const std::string& text) {
    long brightness = 0;
    if (const int error = attribute::number_in(text, 10, brightness)) return error;
    if (brightness < 0) return -EINVAL;
    if (brightness == 0) begin(Trigger::NONE);
    if (trigger_ == Trigger::TIMER) {
        blink_brightness_ = std::min(brightness, MOST);
        if (brightness_ != 0) set(brightness);
    } else {
        set(brightness);
    }
    return 0;
}

int LinuxLed::set_trigger(const std::string& text) {
    for (const auto& [name, trigger] : triggers()) {
        if (!attribute::is_word(text, name.c_str())) continue;
        begin(trigger);
        return 0;
    }
    return -EINVAL;
}

int LinuxLed::set_delay(unsigned which, const std::string& text) {
    long delay_ms = 0;
    if (const int error = attribute::number_in(text, 10, delay_ms)) return error;
    if (delay_ms < 0) return -EINVAL;
    delays_ms_[which] = delay_ms;
    begin_blinking();
    return 0;
}

int LinuxLed::bind(const std::string& text, bool on) {
    if (!attribute::is_word(text, "leds") || on == bound_) return -ENODEV;
    if (on && !outside_.is_pin_free()) return -EBUSY;
    if (!on) {
        begin(Trigger::NONE);
        set(0);
        changes_->gone = true;
    }
    bound_ = on;
    if (on) changes_ = std::make_shared<AttributeFile::Changes>();
    return 0;
}

// ---- Triggers -----------------------------------------------------------------------------------

void LinuxLed::begin(Trigger trigger) {
    if (trigger_ != Trigger::NONE) set(0);
    trigger_ = trigger;
    next_ns_ = NEVER;
    phase_ = 0;
    delays_ms_[0] = delays_ms_[1] = 500;
    blink_brightness_ = MOST;
    if (trigger == Trigger::DEFAULT_ON) set(MOST);
    if (trigger == Trigger::TIMER) begin_blinking();
    if (trigger == Trigger::HEARTBEAT) {
        next_ns_ = outside_.now_ns();
        expire();
    }
}

// A time of 0 is for ever.
void LinuxLed::begin_blinking() {
    phase_ = 0;
    next_ns_ = NEVER;
    if (delays_ms_[0] == 0) return set(0);
    if (delays_ms_[1] == 0) return set(blink_brightness_);
    next_ns_ = outside_.now_ns();
    expire();
}

void LinuxLed::expire() {
    while (next_ns_ <= outside_.now_ns()) {
        const bool on = phase_ % 2 == 0, heart = trigger_ == Trigger::HEARTBEAT;
        set(!on ? 0 : heart ? MOST : blink_brightness_);
        next_ns_ += NS_PER_MS * (heart ? HEARTBEAT_MS[phase_]
                                       : static_cast<std::uint64_t>(delays_ms_[on ? 0 : 1]));
        phase_ = (phase_ + 1) % std::size(HEARTBEAT_MS);
    }
}

}  // namespace sim
