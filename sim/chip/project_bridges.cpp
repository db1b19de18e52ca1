#include "sim/chip/project_bridges.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "sim/chip/axi_bursts.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

// The University Program's PS/2 controller lets a write wait 15 ms for a device.
constexpr std::uint64_t LONGEST_PS = 20'000'000'000;  // 20 ms

sc_time picoseconds(std::uint64_t ps) { return sc_time::from_value(ps); }  // resolution: 1 ps

std::uint64_t next_event_ps() {
    return (sc_time_stamp() + sc_core::sc_time_to_pending_activity()).value();
}

using project::BridgeBurst;

constexpr unsigned FIXED = 0, INCR = 1;     // AxBURST
constexpr unsigned EXOKAY = 1, DECERR = 3;  // BRESP, RRESP

// The burst with its beats: what is read, or written, of `data`, which is the transaction's.
BridgeBurst with_beats(const AxiBurst& burst, bool full, bool write, unsigned width,
                       const std::uint8_t* data) {
    BridgeBurst made{
        full, write, burst.address, burst.beats, 0, burst.fixed ? FIXED : INCR, 0, 0, 0, 0, 0, {}};
    while (1u << made.size < burst.size) ++made.size;
    for (unsigned n = 0, done = 0; n < burst.beats; ++n) {
        const std::uint32_t at = burst.fixed ? burst.address : burst.address + done;
        const unsigned now = std::min(burst.bytes - done, burst.size - at % burst.size);
        BridgeBurst::Beat& beat = made.beat[n];
        beat.address = at / width * width;
        beat.strobes = static_cast<std::uint16_t>(((1u << now) - 1) << at % width);
        if (write) std::memcpy(&beat.lanes[at % width], data + burst.first + done, now);
        done += now;
    }
    return made;
}

void take_answer(const BridgeBurst& burst, std::uint8_t* data) {
    for (unsigned n = 0; n < burst.beats; ++n)
        for (unsigned lane = 0; lane < BridgeBurst::LANES; ++lane)
            if (burst.beat[n].strobes >> lane & 1) *data++ = burst.beat[n].lanes[lane];
}

}  // namespace

ProjectBridges::ProjectBridges(const sc_core::sc_module_name& name, ProjectChip& fpga)
    : sc_module{name}, lw{"lw"}, h2f{"h2f"}, fpga_{fpga} {
    lw.register_b_transport(this, &ProjectBridges::lightweight_transport);
    h2f.register_b_transport(this, &ProjectBridges::full_transport);
}

unsigned ProjectBridges::id_of(bool write, const AxiAttributes& how) {
    constexpr unsigned PROCESSORS = 2, DMA = 1;
    if (how.master == AxiAttributes::Master::DMA) return how.channel << 3 | DMA;
    if (!write) return (reads_++ % 4 << 2 | 3) << 3 | PROCESSORS;
    if (how.cache == AxiAttributes::STRONGLY_ORDERED) return PROCESSORS;
    return ((writes_++ % 3 + 1) << 2 | 1) << 3 | PROCESSORS;
}

// Not past SystemC's next event: where that comes first, SystemC goes on to it.
tlm::tlm_response_status ProjectBridges::play(const BridgeBurst& burst, sc_time& delay) {
    project::Model& model = fpga_.model();
    fpga_.run_to((sc_time_stamp() + delay).value());
    model.begin(burst);
    const std::uint64_t end_ps = model.time_ps() + LONGEST_PS;
    for (;;) {
        const std::uint64_t until_ps = std::min(end_ps, next_event_ps());
        if (fpga_.run_to_answer(until_ps)) break;
        if (until_ps == end_ps || fpga_.end()) {
            const std::string missing = model.waits_for();
            why_ = missing.empty() ? "" : "its bridge waits for " + missing;
            return tlm::TLM_INCOMPLETE_RESPONSE;
        }
        wait(picoseconds(until_ps) - sc_time_stamp());
    }
    delay = std::max(picoseconds(model.time_ps()), sc_time_stamp()) - sc_time_stamp();
    fpga_.notify_processor();
    const unsigned error = model.answer().error;
    if (error <= EXOKAY) return tlm::TLM_OK_RESPONSE;
    why_ = std::string{burst.write ? "BRESP" : "RRESP"} + (error == DECERR ? " DECERR" : " SLVERR");
    return tlm::TLM_GENERIC_ERROR_RESPONSE;
}

void ProjectBridges::set_copy(Copy copy) {
    copy_ = std::move(copy);
    lw.register_get_direct_mem_ptr(this, &ProjectBridges::direct_in_lightweight);
    h2f.register_get_direct_mem_ptr(this, &ProjectBridges::direct_in_full);
}

bool ProjectBridges::direct_in_lightweight(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    return copy_.direct(LW_BASE, tx, dmi);
}

bool ProjectBridges::direct_in_full(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    return copy_.direct(H2F_BASE, tx, dmi);
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
    const unsigned width = fpga_.model().bridge_width(full) / 8;
    if (width == 0) {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
        return;
    }
    AxiAttributes strongly_ordered, *attributes = nullptr;
    tx.get_extension(attributes);
    AxiAttributes& how = attributes ? *attributes : strongly_ordered;
    const bool write = tx.is_write();
    while (busy_ && !closed_) wait(free_);
    if (closed_) wait(never_);
    busy_ = true;
    tlm::tlm_response_status status = tlm::TLM_OK_RESPONSE;
    for (const AxiBurst& part : axi_bursts(static_cast<std::uint32_t>(tx.get_address()),
                                           tx.get_data_length(), write, how, width)) {
        BridgeBurst burst = with_beats(part, full, write, width, tx.get_data_ptr());
        burst.id = id_of(write, how);
        burst.cache = how.cache;
        burst.prot = how.prot;
        burst.lock = how.exclusive ? 1 : 0;
        status = play(burst, delay);
        how.exclusive_taken = fpga_.model().answer().error == EXOKAY;
        if (status != tlm::TLM_OK_RESPONSE) break;
        if (!write) take_answer(fpga_.model().answer(), tx.get_data_ptr() + part.first);
    }
    busy_ = false;
    free_.notify();
    tx.set_response_status(status);
    if (write && copy_.written && !how.fixed && tx.is_response_ok())
        copy_.written((full ? H2F_BASE : LW_BASE) + static_cast<std::uint32_t>(tx.get_address()),
                      tx.get_data_ptr(), tx.get_data_length());
}

}  // namespace sim
