// led.h - /sys/class/leds/hps_led0 of the board's Linux: HPS_LED, by the driver leds-gpio.
//
//   brightness            0 - 255, any but 0 is on; 0 ends a trigger, too
//   max_brightness        255
//   trigger               none, timer, heartbeat (70 ms twice in 1.26 s), default-on
//   delay_on, delay_off   ms, 500 at first; only while the trigger is timer
//
// "leds" written to /sys/bus/platform/drivers/leds-gpio/unbind ends the driver, so that the pin can
// be exported (gpio.h); written to bind it begins again.
//
// Source: github.com/intel/meta-de10-nano, recipes-demo/de10-nano-gpio-apps/files/
// README_gpio-leds.txt: names, brightness and triggers on that board; Linux 4.14, drivers/leds:
// led-class.c, led-core.c, led-triggers.c, leds-gpio.c, trigger/.
//
// Not handled: the images' trigger heartbeat from the boot on: none is set; the heartbeat's rate by
// the load; triggers by the card, the processors, oneshot and others.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "sim/linux/attribute_file.h"
#include "sim/linux/own_files.h"

namespace sim {

class LinuxLed {
public:
    static constexpr std::uint64_t NEVER = ~std::uint64_t{0};

    struct Outside {
        std::function<void(bool lit)> light;
        std::function<bool()> is_pin_free;
        std::function<std::uint64_t()> now_ns;
    };
    explicit LinuxLed(Outside outside) : outside_{std::move(outside)} {}

    void list(OwnFiles& files);
    // By a path without links; nullptr: it is none of its.
    std::shared_ptr<AttributeFile> open(const std::string& path);

    bool is_bound() const { return bound_; }
    std::uint64_t next_ns() const { return next_ns_; }  // when a trigger moves it, or NEVER
    void expire();                                      // what is due

private:
    enum class Trigger { NONE, TIMER, HEARTBEAT, DEFAULT_ON };
    using Attributes = std::map<std::string, AttributeFile::Attribute>;  // by path

    static const std::map<std::string, Trigger>& triggers();
    Attributes attributes();
    std::string trigger_text() const;
    int set_brightness(const std::string& text);
    int set_trigger(const std::string& text);
    int set_delay(unsigned which, const std::string& text);
    int bind(const std::string& text, bool on);
    void begin(Trigger trigger);
    void begin_blinking();
    void set(long brightness);

    const Outside outside_;
    static constexpr long MOST = 255;

    bool bound_ = true;
    long brightness_ = 0, blink_brightness_ = MOST;
    Trigger trigger_ = Trigger::NONE;
    long delays_ms_[2] = {500, 500};  // on, off
    unsigned phase_ = 0;
    std::uint64_t next_ns_ = NEVER;
    std::shared_ptr<AttributeFile::Changes> changes_ = std::make_shared<AttributeFile::Changes>();
};

}  // namespace sim
