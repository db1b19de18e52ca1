#include "sim/chip/fpga_bridges.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/chip/axi_bursts.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

// The University Program's PS/2 controller lets a write wait 15 ms for a device.
constexpr std::uint64_t LONGEST_PS = 20'000'000'000;  // 20 ms

std::uint64_t next_event_ps() {
    return (sc_time_stamp() + sc_core::sc_time_to_pending_activity()).value();
}

constexpr unsigned PROCESSORS = 2;  // an ID's port
constexpr unsigned SLOTS = 3;       // of the L2 cache's store buffer
// A posted write's effects are looked for after so long, then after twice that, and so on.
const sc_time soon{100, sc_core::SC_NS}, late{32, sc_core::SC_US};

constexpr unsigned FIXED = 0, INCR = 1;  // AxBURST

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

std::string error_of(const BridgeBurst& answer) {
    return std::string{answer.write ? "BRESP" : "RRESP"} +
           (answer.error == BridgeBurst::DECERR ? " DECERR" : " SLVERR");
}

// "write to 0xFF200010".
std::string named(const BridgeBurst& write) {
    return fmt::format("write to 0x{:08X}", (write.full ? H2F_BASE : LW_BASE) + write.address);
}

void take_answer(const BridgeBurst& burst, std::uint8_t* data) {
    for (unsigned n = 0; n < burst.beats; ++n) {
        const BridgeBurst::Beat& beat = burst.beat[n];
        unsigned lane = 0;
        while (!(beat.strobes >> lane & 1)) ++lane;
        for (; lane < BridgeBurst::LANES && beat.strobes >> lane & 1; ++lane)
            *data++ = beat.lanes[lane];
    }
}

}  // namespace

FpgaBridges::FpgaBridges(const sc_core::sc_module_name& name, FpgaChip& fpga, Bursts bursts)
    : sc_module{name}, lw{"lw"}, h2f{"h2f"}, fpga_{fpga}, bursts_{bursts} {
    lw.register_b_transport(this, &FpgaBridges::lightweight_transport);
    h2f.register_b_transport(this, &FpgaBridges::full_transport);
    lw.register_get_direct_mem_ptr(this, &FpgaBridges::direct_in_lightweight);
    h2f.register_get_direct_mem_ptr(this, &FpgaBridges::direct_in_full);
    SC_HAS_PROCESS(FpgaBridges);
    SC_METHOD(look_at_posted);
    sensitive << look_at_posted_;
    dont_initialize();
}

unsigned FpgaBridges::id_of(bool write, const AxiAttributes& how) {
    constexpr unsigned DMA = 1;
    if (how.master == AxiAttributes::Master::DMA) return how.channel << 3 | DMA;
    if (!write) return (reads_++ % 4 << 2 | 3) << 3 | PROCESSORS;
    if (how.cache == AxiAttributes::STRONGLY_ORDERED) return PROCESSORS;
    return id_of_slot();
}

unsigned FpgaBridges::id_of_slot() { return ((writes_++ % SLOTS + 1) << 2 | 1) << 3 | PROCESSORS; }

// The clock in which an access begins, or the time has come; not before the last one has ended.
std::uint64_t FpgaBridges::start_of(const sc_time& time) const {
    const std::uint64_t clock_ps = std::max<std::uint64_t>(fpga_.phases().clock_ps(), 1);
    return std::max<std::uint64_t>(time.value() / clock_ps * clock_ps, busy_until_ps_);
}

// run(until_ps) has the FPGA run to an answer, not past SystemC's next event: where that comes
// first, SystemC goes on to it.  False: it does not answer.
template <class Run>
bool FpgaBridges::answers(Run run) {
    const FpgaModel& model = fpga_.model();
    const std::uint64_t end_ps = model.time_ps() + LONGEST_PS;
    for (;;) {
        const std::uint64_t until_ps = std::min(end_ps, next_event_ps());
        if (run(until_ps)) return true;
        if (until_ps == end_ps || model.ending().kind != FpgaModel::Ending::Kind::NONE) {
            const std::string missing = model.waits_for();
            why_ = missing.empty() ? "" : "its bridge waits for " + missing;
            return false;
        }
        wait(picoseconds(until_ps) - sc_time_stamp());
    }
}

tlm::tlm_response_status FpgaBridges::play(const BridgeBurst& burst, sc_time& delay) {
    FpgaModel& model = fpga_.model();
    const sc_time begin = sc_time_stamp() + delay;
    fpga_.run_to(std::max<std::uint64_t>(begin.value(), busy_until_ps_));
    model.begin(burst);
    const std::uint64_t begin_ps = model.time_ps();
    if (!answers([this](std::uint64_t until_ps) { return fpga_.run_to_answer(until_ps); }))
        return tlm::TLM_INCOMPLETE_RESPONSE;
    const std::uint64_t took_ps = model.time_ps() - begin_ps;
    if (!burst.full && took_ps <= FpgaModel::LONGEST_ACCESS * fpga_.phases().clock_ps())
        took_ps_[burst.write] = took_ps;
    delay = std::max(picoseconds(model.time_ps()), sc_time_stamp()) - sc_time_stamp();
    fpga_.notify_processor();
    if (model.answer().error <= BridgeBurst::EXOKAY) return tlm::TLM_OK_RESPONSE;
    why_ = error_of(model.answer());
    return tlm::TLM_GENERIC_ERROR_RESPONSE;
}

// It begins when SystemC's time has come to the processor's, so that it counts from then on without
// anybody who waits for it.
tlm::tlm_response_status FpgaBridges::post(BridgeBurst burst, sc_time& delay) {
    FpgaModel& model = fpga_.model();
    if (delay > sc_core::SC_ZERO_TIME) wait(std::exchange(delay, sc_core::SC_ZERO_TIME));
    const tlm::tlm_response_status status = leave_posted(SLOTS - 1, delay);
    if (status != tlm::TLM_OK_RESPONSE) return status;
    burst.posted = true;
    while (model.has_posted(burst.id)) burst.id = id_of_slot();
    model.begin(burst);
    posted_at_ = sc_time_stamp();
    look_again_ = soon;
    look_at_posted_.notify(look_again_);
    return tlm::TLM_OK_RESPONSE;
}

// Waits until at most so many posted writes are not answered.
tlm::tlm_response_status FpgaBridges::leave_posted(unsigned most, sc_time& delay) {
    FpgaModel& model = fpga_.model();
    const sc_time begin = sc_time_stamp() + delay;
    fpga_.run_to(begin.value());
    if (!model.posted()) return tlm::TLM_OK_RESPONSE;
    const bool answered =
        answers([&](std::uint64_t until_ps) { return fpga_.run_to_posted(until_ps, most); });
    notify_of_refused();
    delay = std::max({picoseconds(model.time_ps()), begin, sc_time_stamp()}) - sc_time_stamp();
    if (answered) return tlm::TLM_OK_RESPONSE;
    why_ += ", of the posted " + named(*model.posted());
    return tlm::TLM_INCOMPLETE_RESPONSE;
}

// At their effects, too, which come some clocks after their answers.
void FpgaBridges::look_at_posted() {
    const FpgaModel& model = fpga_.model();
    fpga_.run_to(sc_time_stamp().value());
    notify_of_refused();
    if (model.posted() && sc_time_stamp() - posted_at_ > picoseconds(LONGEST_PS))
        return posted_failure_(fmt::format("the posted {} is not answered: its bridge waits for {}",
                                           named(*model.posted()), model.waits_for()),
                               BridgeBurst::OKAY);
    if (!model.posted() && look_again_ > 4 * soon) return;
    look_again_ = std::min(2 * look_again_, late);
    look_at_posted_.notify(look_again_);
}

void FpgaBridges::notify_of_refused() {
    while (const auto burst = fpga_.model().refused())
        posted_failure_(fmt::format("the design answered the posted {} with an error: {}",
                                    named(*burst), error_of(*burst)),
                        burst->error);
}

bool FpgaBridges::peek(bool full, std::uint32_t address, std::uint8_t* bytes, unsigned count) {
    FpgaModel& model = fpga_.model();
    const unsigned width = model.bridge_width(full) / 8;
    if (width == 0 || !model.run_to_posted(model.time_ps() + LONGEST_PS, 0)) return false;
    model.begin(with_beats(long_burst(address, count, 0), full, false, width, bytes));
    if (!model.run_to_answer(model.time_ps() + LONGEST_PS)) return false;
    take_answer(model.answer(), bytes);
    return model.answer().error <= BridgeBurst::EXOKAY;
}

std::optional<std::uint32_t> FpgaBridges::peek(std::uint32_t address) {
    std::uint8_t bytes[4];
    if (!peek(false, address, bytes, 4)) return {};
    std::uint32_t value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// Not past SystemC's next event, where somebody may look at the pins.
std::optional<std::uint64_t> FpgaBridges::again(bool write, std::uint64_t begin_ps) {
    FpgaModel& model = fpga_.model();
    const std::uint64_t start_ps = std::max(start_of(picoseconds(begin_ps)), model.time_ps()),
                        end_ps = start_ps + took_ps_[write];
    if (end_ps == start_ps) return {};
    if (calm_batches_ != fpga_.batches()) calm_until_ps_ = 0;
    if (end_ps > calm_until_ps_) {
        const std::uint64_t event_ps = next_event_ps();
        if (end_ps >= event_ps) return {};
        const std::uint64_t before = model.changes();
        model.run(start_ps);
        if (model.changes() != before) return {};
        calm_batches_ = fpga_.batches();
        calm_until_ps_ = std::min(start_ps + model.calm_ps(), event_ps - 1);
        if (end_ps > calm_until_ps_) return {};
    }
    busy_until_ps_ = end_ps;
    return fpga_.phases().seen(end_ps, sc_time_stamp().value());
}

void FpgaBridges::set_copy(Copy copy) { copy_ = std::move(copy); }

bool FpgaBridges::direct_memory(bool full, tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    if (copy_.direct) return copy_.direct(full ? H2F_BASE : LW_BASE, tx, dmi);
    const auto memory =
        fpga_.model().direct_memory(full, static_cast<std::uint32_t>(tx.get_address()));
    if (!memory) return false;
    dmi.set_dmi_ptr(memory->bytes);
    dmi.set_start_address(memory->first);
    dmi.set_end_address(memory->last);
    memory->may_be_written ? dmi.allow_read_write() : dmi.allow_read();
    return true;
}

bool FpgaBridges::direct_in_lightweight(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    return direct_memory(false, tx, dmi);
}

bool FpgaBridges::direct_in_full(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    return direct_memory(true, tx, dmi);
}

void FpgaBridges::lightweight_transport(tlm::tlm_generic_payload& tx, sc_time& delay) {
    transport(false, tx, delay);
}

void FpgaBridges::full_transport(tlm::tlm_generic_payload& tx, sc_time& delay) {
    transport(true, tx, delay);
}

bool FpgaBridges::is_posted(bool write, const AxiAttributes& how) const {
    return write && how.cache != AxiAttributes::STRONGLY_ORDERED && !how.exclusive &&
           how.master == AxiAttributes::Master::PROCESSOR && fpga_.model().takes_posted();
}

void FpgaBridges::transport(bool full, tlm::tlm_generic_payload& tx, sc_time& delay) {
    const unsigned bytes = tx.get_data_length(), width = fpga_.model().bridge_width(full) / 8;
    calm_until_ps_ = 0;
    AxiAttributes strongly_ordered, *attributes = nullptr;
    tx.get_extension(attributes);
    AxiAttributes& how = attributes ? *attributes : strongly_ordered;
    if (tx.get_command() == tlm::TLM_IGNORE_COMMAND) {
        tx.set_response_status(tlm::TLM_COMMAND_ERROR_RESPONSE);
        return;
    }
    if (bytes == 0 || (tx.get_streaming_width() < bytes && !how.fixed)) {
        tx.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
        return;
    }
    if (tx.get_byte_enable_ptr()) {
        tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
        return;
    }
    if (width == 0) {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
        return;
    }
    const bool write = tx.is_write();
    while (busy_ && !closed_) wait(free_);
    if (closed_) wait(never_);
    busy_ = true;
    const auto address = static_cast<std::uint32_t>(tx.get_address());
    const std::vector<AxiBurst> parts = bursts_ == Bursts::LONG
                                            ? std::vector<AxiBurst>{}
                                            : axi_bursts(address, bytes, write, how, width);
    tlm::tlm_response_status status =
        is_posted(write, how) ? tlm::TLM_OK_RESPONSE : leave_posted(0, delay);
    for (unsigned done = 0, n = 0; done < bytes && status == tlm::TLM_OK_RESPONSE; ++n) {
        if (done && delay >= sc_core::sc_time_to_pending_activity()) {
            wait(delay);
            delay = sc_core::SC_ZERO_TIME;
        }
        const AxiBurst part = bursts_ == Bursts::LONG ? long_burst(address, bytes, done) : parts[n];
        status = carry(part, {full, write, width, tx.get_data_ptr()}, how, delay);
        done = part.first + part.bytes;
    }
    busy_ = false;
    free_.notify();
    delay = picoseconds(fpga_.phases().seen(delay.value(), 0));
    fpga_.notify_processor();
    tx.set_response_status(status);
    if (write && copy_.written && !how.fixed && tx.is_response_ok())
        copy_.written((full ? H2F_BASE : LW_BASE) + address, tx.get_data_ptr(), bytes);
}

// A part of a transaction, with the transaction's data.
tlm::tlm_response_status FpgaBridges::carry(const AxiBurst& part, const Transfer& transfer,
                                            AxiAttributes& how, sc_time& delay) {
    const auto [full, write, width, data] = transfer;
    FpgaModel& model = fpga_.model();
    if (const auto end_ps = model.access_memory(full, write, part.address, data + part.first,
                                                part.bytes, start_of(sc_time_stamp() + delay))) {
        delay = picoseconds(*end_ps) - sc_time_stamp();
        return tlm::TLM_OK_RESPONSE;
    }
    BridgeBurst burst = with_beats(part, full, write, width, data);
    burst.id = id_of(write, how);
    burst.cache = how.cache;
    burst.prot = how.prot;
    burst.lock = how.exclusive ? 1 : 0;
    if (is_posted(write, how)) return post(burst, delay);
    const tlm::tlm_response_status status = play(burst, delay);
    how.exclusive_taken = model.answer().error == BridgeBurst::EXOKAY;
    if (!write && status == tlm::TLM_OK_RESPONSE) take_answer(model.answer(), data + part.first);
    return status;
}

}  // namespace sim
