#include "sim/cpu/native_cpu.h"

#include <fmt/format.h>

#include "hal/clock.h"
#include "hal/console.h"
#include "sim/text/seconds.h"

namespace sim {

using sc_core::sc_time;

NativeCpu::NativeCpu(const sc_core::sc_module_name& name, Firmware firmware)
    : Processor{name}, firmware_{std::move(firmware)} {
    SC_HAS_PROCESS(NativeCpu);
    SC_THREAD(run);
    set_stack_size(STACK_BYTES);
}

void NativeCpu::run() {
    try {
        hal::Clock{*this}.start();
        firmware_(*this, *this);
    } catch (const Abort&) {  // which fault() reports
    }
}

void NativeCpu::access(tlm::tlm_command command, std::uint32_t address, void* data,
                       unsigned bytes) {
    if (ahead_ >= sc_core::sc_time_to_pending_activity()) {
        wait(ahead_);
        ahead_ = sc_core::SC_ZERO_TIME;
    }
    const std::string answer = transport(payload_, command, address, data, bytes, ahead_);
    if (answer.empty()) return;

    const sc_time now = sc_core::sc_time_stamp() + ahead_;
    fail(fmt::format("data abort: {} of {} bytes at 0x{:08X} at {:.6f} ms ({})",
                     command == tlm::TLM_READ_COMMAND ? "read" : "write", bytes, address,
                     seconds(now) * 1e3, answer));
    throw Abort{};
}

std::uint32_t NativeCpu::read(std::uint32_t address) {
    std::uint32_t value = 0;
    access(tlm::TLM_READ_COMMAND, address, &value, sizeof value);
    return value;
}

void NativeCpu::write(std::uint32_t address, std::uint32_t value) {
    access(tlm::TLM_WRITE_COMMAND, address, &value, sizeof value);
}

void NativeCpu::write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) {
    if (count == 0) return;
    // A write only reads the data, but TLM has one pointer for both directions.
    access(tlm::TLM_WRITE_COMMAND, address, const_cast<std::uint32_t*>(words), 4 * count);
}

void NativeCpu::idle() {
    wait(ahead_ + sc_time{50, sc_core::SC_US});
    ahead_ = sc_core::SC_ZERO_TIME;
}

std::uint32_t NativeCpu::micros() { return hal::Clock{*this}.micros(); }

void NativeCpu::print(const char* text) { hal::Console{*this}.print(text); }

}  // namespace sim
