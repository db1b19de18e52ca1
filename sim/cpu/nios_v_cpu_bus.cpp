// nios_v_cpu_bus.cpp - NiosVCpu's memory map, and its accesses to the bus
#include <algorithm>

#include "sim/cpu/nios_v_cpu.h"

namespace sim {

using sc_core::sc_time;

// RAM is what grants direct access; everything else uses the bus.  Memory that grants direct reads
// alone is used for fetching instructions alone.
void NiosVCpu::map() {
    for (std::uint64_t address = 0; address <= 0xFFFFFFFF;) {
        tlm::tlm_generic_payload tx;
        tx.set_address(address);
        tx.set_read();
        tlm::tlm_dmi dmi;
        if (socket->get_direct_mem_ptr(tx, dmi))
            core_.map_ram(static_cast<std::uint32_t>(address),
                          static_cast<std::uint32_t>(dmi.get_end_address() + 1 - address),
                          dmi.get_dmi_ptr(), !dmi.is_write_allowed());
        address = dmi.get_end_address() + 1;
    }
}

void NiosVCpu::load() {
    for (const ElfSegment& segment : program_.elf.segments) {
        const std::vector<std::uint8_t> zeros(segment.size - segment.data.size());
        core_.write_ram(segment.physical, segment.data.data(), segment.data.size());
        core_.write_ram(segment.physical + static_cast<std::uint32_t>(segment.data.size()),
                        zeros.data(), zeros.size());
    }
}

// One whose register has answered before and cannot have changed: the same time passes.
bool NiosVCpu::answer_again(bool write, std::uint32_t address, unsigned bytes,
                            std::uint32_t& value) {
    if (!steady_bus_) return false;
    const auto known = answers_.last(address, bytes, write, events_ + steady_bus_->changes());
    if (!known || !known->sure || (write && known->value != value)) return false;
    const sc_time stamp = sc_core::sc_time_stamp();
    const auto end = steady_bus_->again(write, (stamp + time_.ahead()).value());
    if (!end) return false;
    const sc_time ahead = sc_time::from_value(*end) - stamp;
    counts_.on_bus += ahead - time_.ahead();
    time_.ahead() = ahead;
    value = known->value;
    steady_bus_->left_out(write, 1);
    return true;
}

bool NiosVCpu::access(bool write, std::uint32_t address, unsigned bytes, std::uint32_t& value) {
    time_.account();
    sync();
    const sc_time stamp = sc_core::sc_time_stamp(), before = stamp + time_.ahead();
    if (!answer_again(write, address, bytes, value)) {
        const std::uint64_t epoch = events_ + (steady_bus_ ? steady_bus_->changes() : 0);
        bus_answer_ = transport(payload_, write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND,
                                address, &value, bytes, time_.ahead());
        counts_.on_bus += sc_core::sc_time_stamp() + time_.ahead() - before;
        if (sc_core::sc_time_stamp() != stamp) {
            ++events_;
            waited_ = true;
        }
        if (!bus_answer_.empty()) return false;
        const bool plain = !waited_ && steady_bus_ && steady_bus_->is_plain(address, write, value);
        answers_.made(address, bytes, write, value, plain, epoch);
    }
    run_on();
    return true;
}

bool NiosVCpu::read(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
    polls_ = address == polled_ ? polls_ + 1 : 0;
    polled_ = address;
    return access(false, address, bytes, value);
}

bool NiosVCpu::write(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    polls_ = 0;
    return access(true, address, bytes, value);
}

bool NiosVCpu::read_memory(std::uint32_t address, void* data, unsigned bytes) {
    return core_.read_ram(address, data, bytes) || inspect(false, address, data, bytes);
}

bool NiosVCpu::write_memory(std::uint32_t address, const void* data, unsigned bytes) {
    // A write only reads the data, but TLM has one pointer for both directions.
    return core_.write_ram(address, data, bytes) ||
           inspect(true, address, const_cast<void*>(data), bytes);
}

// The program's time stands, also where the target lets SystemC's go on.
bool NiosVCpu::inspect(bool write, std::uint32_t address, void* data, unsigned bytes) {
    const sc_time before = sc_core::sc_time_stamp();
    sc_time no_time;
    inspected_ = true;
    const bool done = transport(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND, address,
                                data, bytes, no_time)
                          .empty();
    inspected_ = false;
    ++events_;
    time_.ahead() -= std::min(time_.ahead(), sc_core::sc_time_stamp() - before);
    return done;
}

}  // namespace sim
