#include "sim/chip/nios_v_devices.h"

#include <algorithm>
#include <iterator>

#include "regmap.h"

namespace sim {

namespace {

constexpr std::uint64_t TICK_PS = 10'000;  // 100 MHz
constexpr std::uint32_t TIMER_OFFSET = 0x2100;
constexpr std::uint32_t ADDRESSES[] = {regmap::PIXEL_BUFFER,    regmap::PIXEL_BACK_BUFFER,
                                       regmap::TEXT_BUFFER,     regmap::TEXT_BACK_BUFFER,
                                       regmap::VIDEO_IN_BUFFER, regmap::VIDEO_IN_BACK_BUFFER};

// With one half of `value` replaced.
std::uint64_t with(std::uint64_t value, bool upper, std::uint32_t half) {
    return upper ? (value & 0xFFFFFFFF) | std::uint64_t{half} << 32
                 : (value & 0xFFFFFFFF00000000) | half;
}

}  // namespace

// ---- The timer ----------------------------------------------------------------------------------

MachineTimer::MachineTimer(const sc_core::sc_module_name& module_name,
                           std::function<void(std::uint32_t)> lines)
    : Registers{module_name}, lines_{std::move(lines)}, alarm_{"alarm", [this] {
                                                                   update(sc_core::sc_time_stamp()
                                                                              .value());
                                                               }} {}

std::uint64_t MachineTimer::count(std::uint64_t now_ps) const {
    return now_ps / TICK_PS + written_;
}

std::uint32_t MachineTimer::read(std::uint32_t offset, const sc_core::sc_time& now) {
    const std::uint64_t time = count(now.value());
    switch (offset) {
        case 0x00: return static_cast<std::uint32_t>(time);
        case 0x04: return static_cast<std::uint32_t>(time >> 32);
        case 0x08: return static_cast<std::uint32_t>(compare_);
        case 0x0C: return static_cast<std::uint32_t>(compare_ >> 32);
        case 0x10: return software_;
        default: return 0;
    }
}

void MachineTimer::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    const std::uint64_t time = count(now.value());
    switch (offset) {
        case 0x00:
        case 0x04: written_ += with(time, offset == 0x04, value) - time; break;
        case 0x08:
        case 0x0C: compare_ = with(compare_, offset == 0x0C, value); break;
        case 0x10: software_ = value & 1; break;
        default: return;
    }
    update(now.value());
}

void MachineTimer::update(std::uint64_t now_ps) {
    const std::uint64_t time = count(now_ps);
    const bool reached = time >= compare_;
    constexpr std::uint64_t FAR = std::uint64_t{1} << 50;  // ticks, of which the ps fit
    if (reached || compare_ - time > FAR)
        alarm_.set({});
    else
        alarm_.set((now_ps / TICK_PS + (compare_ - time)) * TICK_PS);
    const std::uint32_t levels = std::uint32_t{software_} << SOFTWARE | std::uint32_t{reached}
                                                                            << TIMER;
    if (levels == levels_) return;
    levels_ = levels;
    lines_(levels);
}

// ---- The window ---------------------------------------------------------------------------------

NiosVWindow::NiosVWindow(const sc_core::sc_module_name& module_name)
    : sc_module{module_name}, socket{"socket"}, fpga{"fpga"}, timer{"timer"} {
    socket.register_b_transport(this, &NiosVWindow::transport);
}

void NiosVWindow::transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
    const auto offset = static_cast<std::uint32_t>(tx.get_address());
    if (offset - TIMER_OFFSET < MachineTimer::SIZE) {
        tx.set_address(offset - TIMER_OFFSET);
        timer->b_transport(tx, delay);
        return;
    }
    fpga->b_transport(tx, delay);
    const std::uint32_t address = regmap::LW_BASE + offset,
                        last = address + tx.get_data_length() - 1;
    const bool is_address =
        std::find(std::begin(ADDRESSES), std::end(ADDRESSES), last & ~3u) != std::end(ADDRESSES);
    if (tx.is_read() && is_address && last % 4 == 3)
        tx.get_data_ptr()[tx.get_data_length() - 1] &= 0x3F;
}

}  // namespace sim
