#include "sim/hps/l4_watchdog.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t WATCHDOG_TICK_PS = 40'000;  // 25 MHz
constexpr std::uint32_t KICK = 0x76, LONGEST = 0xFF, FULL_COUNT = 0x7FFFFFFF;
constexpr std::uint32_t WDT_PARAMETERS = 0x10FF0254, WDT_VERSION = 0x3130362A,
                        WDT_TYPE = 0x44570120;

}  // namespace

enum L4Watchdog::Offset : std::uint32_t {
    CONTROL = 0x00,
    RANGE = 0x04,
    CURRENT = 0x08,
    RESTART = 0x0C,
    STATUS = 0x10,
    EOI = 0x14,
    RESET_RANGE = 0xEC,
    RESET_COUNT = 0xF0,
    COMPONENT_PARAMETERS = 0xF4,
    COMPONENT_VERSION = 0xF8,
    COMPONENT_TYPE = 0xFC
};
enum L4Watchdog::Bit : std::uint32_t { ENABLE = 1, INTERRUPT_FIRST = 2, PULSE = 0x1C };

L4Watchdog::L4Watchdog(const sc_core::sc_module_name& module_name, std::function<void(bool)> line,
                       std::function<void()> end)
    : Registers{module_name}, line_{std::move(line)}, end_{std::move(end)}, alarm_{"alarm", [this] {
                                                                                       rung();
                                                                                   }} {
    reset();
}

void L4Watchdog::reset() {
    control_ = INTERRUPT_FIRST;
    range_ = LONGEST;
    countdown_.set(0, FULL_COUNT, WATCHDOG_TICK_PS, false, std::nullopt);
    alarm_.set(std::nullopt);
    if (interrupts_) interrupt(false);
}

void L4Watchdog::start(std::uint32_t range, std::uint64_t now_ps) {
    countdown_.set(now_ps, (0x10000u << (range & 0xF)) - 1, WATCHDOG_TICK_PS, true, std::nullopt);
    alarm_.set(countdown_.zero_ps(1));
}

void L4Watchdog::interrupt(bool up) {
    interrupts_ = up;
    line_(up);
}

void L4Watchdog::rung() {
    if ((control_ & INTERRUPT_FIRST) && !interrupts_) {
        start(range_, sc_core::sc_time_stamp().value());
        interrupt(true);
    } else {
        reset();
        end_();
    }
}

std::uint32_t L4Watchdog::read(std::uint32_t offset, const sc_core::sc_time& now) {
    switch (offset) {
        case CONTROL: return control_;
        case RANGE: return range_;
        case CURRENT: return countdown_.count(now.value());
        case STATUS: return interrupts_;
        case EOI: interrupt(false); return 0;
        case RESET_RANGE: return LONGEST;
        case RESET_COUNT: return FULL_COUNT;
        case COMPONENT_PARAMETERS: return WDT_PARAMETERS;
        case COMPONENT_VERSION: return WDT_VERSION;
        case COMPONENT_TYPE: return WDT_TYPE;
        default: return 0;
    }
}

void L4Watchdog::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    const bool runs = control_ & ENABLE;
    if (offset == CONTROL) {
        control_ = (value & (ENABLE | INTERRUPT_FIRST | PULSE)) | (control_ & ENABLE);
        if (!runs && (control_ & ENABLE)) start(range_ >> 4, now.value());
    } else if (offset == RANGE) {
        range_ = value & 0xFF;
    } else if (offset == RESTART && (value & 0xFF) == KICK) {
        interrupt(false);
        if (runs) start(range_, now.value());
    }
}

}  // namespace sim
