// arm_cpu_bus.cpp - ArmCpu's memory map, and its accesses to the bus
#include "sim/cpu/arm_cpu.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "sim/hps/bridge_windows.h"
#include "sim/text/seconds.h"

namespace sim {

using sc_core::sc_time;

namespace {

constexpr std::uint32_t PAGE = 0x1000;

}  // namespace

// RAM is what grants direct access; everything else uses the bus, which answers or refuses it.
// Memory that grants direct reads alone is used for fetching instructions alone.
void ArmCpu::map(std::uint64_t first, std::uint64_t last) {
    const auto within = [&](const Range& range) {
        return range.first >= first && range.first <= last;
    };
    for (const Range& range : mapped_)
        if (within(range))
            core_.unmap(static_cast<std::uint32_t>(range.first), range.last - range.first + 1);
    mapped_.erase(std::remove_if(mapped_.begin(), mapped_.end(), within), mapped_.end());
    for (std::uint64_t address = first; address <= last;) {
        tlm::tlm_generic_payload tx;
        tx.set_address(address);
        tx.set_read();
        tlm::tlm_dmi dmi;
        const bool ram = socket->get_direct_mem_ptr(tx, dmi);
        const auto base = static_cast<std::uint32_t>(address);
        std::uint64_t size = dmi.get_end_address() + 1 - address;
        // The core maps whole pages of 4 KB; blocks that share one are mapped together.
        if (!ram) size = (size + 0xFFF) & ~std::uint64_t{0xFFF};
        if (ram)
            core_.map_ram(base, size, dmi.get_dmi_ptr(), arm_access::ALL, !dmi.is_write_allowed());
        else
            core_.map_bus(base, size, base);
        mapped_.push_back({address, address + size - 1});
        address += size;
    }
}

// Called in the middle of a store to the reset manager; takes effect before the next instruction.
void ArmCpu::direct_access_changed(sc_dt::uint64 first, sc_dt::uint64 last) {
    if (mapped_.empty()) return;  // by a kernel, or not yet
    remap_ = Range{first, last};
    if (running_) core_.stop_soon();
}

void ArmCpu::load() {
    for (const ElfSegment& segment : program_.elf.segments) {
        const std::vector<std::uint8_t> zeros(segment.size - segment.data.size());
        core_.write_ram(segment.physical, segment.data.data(), segment.data.size());
        core_.write_ram(segment.physical + static_cast<std::uint32_t>(segment.data.size()),
                        zeros.data(), zeros.size());
    }
    runaway_.forbid_data();
}

bool ArmCpu::access(tlm::tlm_command command, std::uint32_t address, unsigned bytes, void* data) {
    time_.account();
    sync();
    const sc_time stamp = sc_core::sc_time_stamp(), before = stamp + time_.ahead();
    shortcuts_.access_begins();
    std::string answer = transport(payload_, command, address, data, bytes, time_.ahead());
    counts_.on_bus += sc_core::sc_time_stamp() + time_.ahead() - before;
    if (sc_core::sc_time_stamp() != stamp) {
        shortcuts_.changed();
        waited_ = true;
    }
    if (answer.empty()) return true;
    bus_answer_ = std::move(answer);
    refused_address_ = address;
    refused_bytes_ = bytes;
    return false;
}

bool ArmCpu::is_replayed() {
    if (!shortcuts_.replay()) return false;
    run_on();
    return true;
}

void ArmCpu::show_bursts() {
    shows_bursts_ = true;
    payload_.set_extension(&attributes_);
}

void ArmCpu::describe_access() {
    const ArmCore::OnBus on_bus = core_.on_bus();
    attributes_.cache = on_bus.cache;
    attributes_.prot = on_bus.privileged ? AxiAttributes::PRIVILEGED : 0;
    attributes_.exclusive = on_bus.exclusive;
    attributes_.exclusive_taken = true;
}

// The access is a word of a burst, if need be the first of a new one.
bool ArmCpu::joins(std::uint32_t address, unsigned bytes) {
    if (!shows_bursts_) return false;
    describe_access();
    const bool on_bridge = address - H2F_BASE < H2F_SIZE || address - LW_BASE < LW_SIZE;
    if (bytes != 4 || !on_bridge) return false;
    const std::uint64_t instruction = core_.instructions();
    if (burst_.continues(instruction, address)) return true;
    const unsigned words = burst_.is_of(instruction) ? burst_.later() : core_.on_bus().words,
                   here = std::min(words, (PAGE - address % PAGE) / 4);
    if (here < 2) return false;
    burst_.begin(instruction, address, here, words - here);
    return true;
}

bool ArmCpu::read(std::uint32_t address, unsigned bytes, std::uint32_t& value) {
    drain();
    if (is_replayed()) {
        value = shortcuts_.replayed(address, bytes);
        return true;
    }
    value = 0;
    if (joins(address, bytes)) {
        const bool is_first = address == burst_.address();
        if (is_first && !access(tlm::TLM_READ_COMMAND, address, burst_.bytes(), burst_.data())) {
            burst_.drop();
            return false;
        }
        value = burst_.take();
        if (!is_first) return true;
    } else if (!access(tlm::TLM_READ_COMMAND, address, bytes, &value)) {
        return false;
    }
    shortcuts_.answered(address, bytes, false, value, waited_);
    run_on();
    return true;
}

bool ArmCpu::write(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    drain();
    stores_.forget_page();
    if (is_replayed()) return true;
    if (!joins(address, bytes)) return write_now(address, bytes, value);
    burst_.add(value);
    if (!burst_.is_whole()) return true;
    if (!access(tlm::TLM_WRITE_COMMAND, burst_.address(), burst_.bytes(), burst_.data()))
        return false;
    shortcuts_.answered(address, bytes, true, value, waited_);
    run_on();
    return true;
}

bool ArmCpu::write_now(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    if (!access(tlm::TLM_WRITE_COMMAND, address, bytes, &value)) return false;
    shortcuts_.answered(address, bytes, true, value, waited_);
    run_on();
    return true;
}

// What is no bridge takes it as it takes others.
bool ArmCpu::exclusive_stored() {
    if (!shows_bursts_ || attributes_.exclusive_taken) return true;
    if (!std::exchange(exclusive_failed_, true))
        log_(fmt::format(
            "an exclusive store (STREX) fails, as on the board: the design answers it with OKAY, "
            "not with EXOKAY, so nobody there keeps accesses apart{}",
            accessed()));
    return false;
}

bool ArmCpu::write_normal(std::uint32_t address, unsigned bytes, std::uint32_t value) {
    if (shows_bursts_ && core_.on_bus().exclusive) return write(address, bytes, value);
    if (!stores_.knows_page(address)) {
        drain();
        stores_.forget_page();
        if (is_replayed()) return true;
        if (shows_bursts_) describe_access();
        if (!write_now(address, bytes, value)) return false;
        if (address - H2F_BASE < H2F_SIZE) stores_.answered(address);
        return true;
    }
    const bool continues = stores_.continues(address);
    if (!continues) drain();
    if (shows_bursts_ && stores_.is_empty()) {
        describe_access();
        stored_ = attributes_;
    }
    stores_.add(address, bytes, value);
    const bool full = stores_.is_full();
    if (full) drain();
    if (full || !continues) run_on();
    return true;
}

void ArmCpu::drain() {
    if (stores_.is_empty()) return;
    const StoreBuffer::Burst burst = stores_.remove();
    shortcuts_.changed();  // what it writes may be read elsewhere
    if (shows_bursts_) attributes_ = stored_;
    if (access(tlm::TLM_WRITE_COMMAND, burst.address, burst.bytes, burst.data.data())) return;
    fail(fmt::format("burst of {} bytes refused at 0x{:08X} {} ({})", burst.bytes, burst.address,
                     where(), bus_answer_));
    core_.stop_soon();
}

// For merged stores it is the access that caused the burst to be sent.
std::string ArmCpu::accessed() const {
    const std::uint32_t pc = core_.instruction();
    const std::string function = program_.elf.function(pc);
    return fmt::format(", at {:.6f} ms, PC 0x{:08X}{}{}", seconds(now()) * 1e3, pc,
                       function.empty() ? "" : " in ", function);
}

bool ArmCpu::read_memory(std::uint32_t address, void* data, unsigned bytes) {
    return core_.read_ram(address, data, bytes) ||
           inspect(tlm::TLM_READ_COMMAND, address, data, bytes);
}

bool ArmCpu::write_memory(std::uint32_t address, const void* data, unsigned bytes) {
    // A write only reads the data, but TLM has one pointer for both directions.
    return core_.write_ram(address, data, bytes) ||
           inspect(tlm::TLM_WRITE_COMMAND, address, const_cast<void*>(data), bytes);
}

// The program's time stands, also where the target lets SystemC's go on.
bool ArmCpu::inspect(tlm::tlm_command command, std::uint32_t address, void* data, unsigned bytes) {
    const std::optional<std::uint32_t> on_bus = core_.bus_address(address);
    if (!on_bus) return false;
    const sc_time before = sc_core::sc_time_stamp();
    sc_time no_time;
    inspected_ = true;
    const bool done = transport(command, *on_bus, data, bytes, no_time).empty();
    inspected_ = false;
    time_.ahead() -= std::min(time_.ahead(), sc_core::sc_time_stamp() - before);
    return done;
}

}  // namespace sim
