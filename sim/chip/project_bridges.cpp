#include "sim/chip/project_bridges.h"

#include <algorithm>
#include <cstring>

namespace sim {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

// The University Program's PS/2 controller lets a write wait 15 ms for a device.
constexpr std::uint64_t LONGEST_PS = 20'000'000'000;  // 20 ms
constexpr unsigned WORD = 8;                          // bytes of a BridgeAccess

sc_time picoseconds(std::uint64_t ps) { return sc_time::from_value(ps); }  // resolution: 1 ps

std::uint64_t next_event_ps() {
    return (sc_time_stamp() + sc_core::sc_time_to_pending_activity()).value();
}

}  // namespace

ProjectBridges::ProjectBridges(const sc_core::sc_module_name& name, ProjectChip& fpga)
    : sc_module{name}, lw{"lw"}, h2f{"h2f"}, fpga_{fpga} {
    lw.register_b_transport(this, &ProjectBridges::lightweight_transport);
    h2f.register_b_transport(this, &ProjectBridges::full_transport);
}

// Not past SystemC's next event: where that comes first, SystemC goes on to it.
bool ProjectBridges::access(const project::BridgeAccess& access, sc_time& delay) {
    project::Model& model = fpga_.model();
    fpga_.run_to((sc_time_stamp() + delay).value());
    model.begin(access);
    const std::uint64_t end_ps = model.time_ps() + LONGEST_PS;
    for (;;) {
        const std::uint64_t until_ps = std::min(end_ps, next_event_ps());
        if (model.run_to_answer(until_ps)) break;
        if (until_ps == end_ps || fpga_.end()) {
            missing_ = model.waits_for();
            return false;
        }
        wait(picoseconds(until_ps) - sc_time_stamp());
    }
    delay = std::max(picoseconds(model.time_ps()), sc_time_stamp()) - sc_time_stamp();
    fpga_.notify_processor();
    return true;
}

void ProjectBridges::lightweight_transport(tlm::tlm_generic_payload& tx, sc_time& delay) {
    transport(false, tx, delay);
}

void ProjectBridges::full_transport(tlm::tlm_generic_payload& tx, sc_time& delay) {
    transport(true, tx, delay);
}

void ProjectBridges::transport(bool full, tlm::tlm_generic_payload& tx, sc_time& delay) {
    if (tx.get_command() == tlm::TLM_IGNORE_COMMAND || tx.get_byte_enable_ptr()) {
        tx.set_response_status(tlm::TLM_COMMAND_ERROR_RESPONSE);
        return;
    }
    const unsigned width = std::min(fpga_.model().bridge_width(full) / 8, WORD);
    if (width == 0) {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
        return;
    }
    const bool write = tx.get_command() == tlm::TLM_WRITE_COMMAND;
    auto address = static_cast<std::uint32_t>(tx.get_address());
    std::uint8_t* data = tx.get_data_ptr();
    if (closed_) wait(never_);
    busy_ = true;
    bool answered = true;
    for (unsigned left = tx.get_data_length(); left && answered;) {
        const unsigned at = address % WORD, now = std::min(left, width - address % width);
        project::BridgeAccess beat{full, write, address - at, 0, 0};
        beat.byte_enable = static_cast<std::uint8_t>(((1u << now) - 1) << at);
        if (write) std::memcpy(reinterpret_cast<std::uint8_t*>(&beat.data) + at, data, now);
        // A narrow bridge sees which of its words is meant.
        beat.address = address / width * width;
        answered = access(beat, delay);
        if (!write && answered) {
            const std::uint64_t word = fpga_.model().answer();
            std::memcpy(data, reinterpret_cast<const std::uint8_t*>(&word) + at, now);
        }
        address += now;
        data += now;
        left -= now;
    }
    busy_ = false;
    tx.set_response_status(answered ? tlm::TLM_OK_RESPONSE : tlm::TLM_INCOMPLETE_RESPONSE);
}

}  // namespace sim
