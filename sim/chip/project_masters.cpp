#include "sim/chip/project_masters.h"

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

constexpr std::uint64_t FS_PER_PS = 1'000;
constexpr std::uint64_t QUEUE_PS = 200'000;  // of what a port's FIFOs hold back
constexpr std::uint32_t FPGAPORTRST = 0x5080;
constexpr std::uint32_t COHERENT_BASE = 0x80000000, COHERENT_SIZE = 0x40000000;
// The processor's own: snoop control unit, interrupt controller, timers, L2 cache.
constexpr std::uint32_t PRIVATE_BASE = 0xFFFEC000, PRIVATE_SIZE = 0x4000;

bool is_within(std::uint32_t address, std::uint32_t base, std::uint32_t size) {
    return address - base < size;
}

}  // namespace

bool ProjectMasters::is_open(unsigned port) const {
    if (port == FPGA2HPS)
        return !(system_.hps.reset_manager.bridges_in_reset() & ResetManager::F2H);
    return system_.hps.sdram_control.value(FPGAPORTRST) >> (8 + port) & 1;
}

bool ProjectMasters::takes(unsigned port, std::uint64_t now_ps) const {
    return busy_until_ps_ <= now_ps + QUEUE_PS && is_open(port);
}

std::uint64_t ProjectMasters::begin(unsigned bytes, std::uint64_t now_ps) {
    busy_until_ps_ = std::max(busy_until_ps_, now_ps) + bytes * byte_fs_ / FS_PER_PS;
    return busy_until_ps_ + LATENCY_PS;
}

ProjectMasters::Answer ProjectMasters::access(unsigned port, bool write, std::uint32_t address,
                                              std::uint8_t* data, unsigned bytes,
                                              std::uint64_t now_ps) {
    if (port == FPGA2HPS && is_within(address, COHERENT_BASE, COHERENT_SIZE))
        address -= COHERENT_BASE;
    if (address <= ProcessorSystem::DDR3_SIZE - bytes) {
        std::uint8_t* const memory = system_.ddr3.bytes() + address;
        write ? std::memcpy(memory, data, bytes) : std::memcpy(data, memory, bytes);
        return Answer::DONE;
    }
    if (port != FPGA2HPS) return Answer::PAST_THE_END;
    if (is_within(address, H2F_BASE, H2F_SIZE) || is_within(address, LW_BASE, LW_SIZE) ||
        is_within(address, PRIVATE_BASE, PRIVATE_SIZE))
        return Answer::NOBODY;
    const std::uint64_t stamp_ps = sc_core::sc_time_stamp().value();
    sc_core::sc_time delay = sc_core::sc_time::from_value(std::max(now_ps, stamp_ps) - stamp_ps);
    return system_.bus.transfer(write, address, data, bytes, delay) ? Answer::DONE : Answer::NOBODY;
}

}  // namespace sim
