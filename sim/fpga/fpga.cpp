#include "sim/fpga/fpga.h"

#include <algorithm>
#include <cstring>

#include "regmap.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

const sc_time scan_line_time{32, sc_core::SC_US};
constexpr std::uint64_t WRITE_CLOCKS = 2'500'000;  // 100 ms

constexpr std::uint64_t HALF_CLOCK_PS = FABRIC_PERIOD_PS / 2;

sc_time picoseconds(std::uint64_t ps) { return sc_time::from_value(ps); }  // resolution: 1 ps

tlm::tlm_response_status status_of(AxiResponse response) {
    switch (response) {
        case AxiResponse::OKAY:
        case AxiResponse::EXOKAY: return tlm::TLM_OK_RESPONSE;
        case AxiResponse::DECERR: return tlm::TLM_ADDRESS_ERROR_RESPONSE;
        case AxiResponse::SLVERR: return tlm::TLM_GENERIC_ERROR_RESPONSE;
        default: return tlm::TLM_INCOMPLETE_RESPONSE;
    }
}

constexpr std::uint32_t SDRAM = regmap::SDRAM_BASE - H2F_BASE,
                        ONCHIP = regmap::ONCHIP_BASE - H2F_BASE;

// Bytes of the next AXI burst: at most 16 words, and not across 4 KB.
unsigned burst_bytes(std::uint32_t address, unsigned left) {
    const unsigned words = 64 - address % 4, page = 4096 - address % 4096;
    return std::min({left, words, page});
}

}  // namespace

Fpga::Fpga(const sc_core::sc_module_name& name, PinListener& pins, const Trace& trace,
           Memory memory, std::uint8_t* sdram, unsigned audio_rate)
    : sc_module{name},
      lw{"lw"},
      h2f{"h2f"},
      pins_{pins},
      fabric_{pins, trace, audio_rate},
      memory_{fabric_.has_memory() ? memory : Memory::BRIDGED},
      sdram_{sdram} {
    h2f.register_get_direct_mem_ptr(this, &Fpga::direct_memory);
    lw.register_b_transport(this, &Fpga::lightweight_transport);
    h2f.register_b_transport(this, &Fpga::full_transport);
    SC_HAS_PROCESS(Fpga);
    SC_METHOD(scan_line);
    SC_METHOD(board_moves);
    sensitive << board_moves_;
    dont_initialize();
    pins_.agenda.on_next([this](std::uint64_t next_ps) { wait_for_board(next_ps); });
}

Fpga::~Fpga() {
    pins_.agenda.on_next([](std::uint64_t) {});
}

// The clock in which an access begins, or the time has come; not before the last access has ended.
std::uint64_t Fpga::start_of(std::uint64_t time_ps) const {
    return std::max({time_ps / FABRIC_PERIOD_PS, busy_until_, fabric_.clocks()});
}

void Fpga::run_to(const sc_time& time) {
    calm_until_ = 0;
    fabric_.run(start_of(time.value()) - fabric_.clocks());
    if (pins_.agenda.next_ps() <= time.value()) fabric_.keep_agenda(time.value());
    pins_.agenda.pass_to(time.value());
    notify_interrupts();
}

void Fpga::wait_for_board(std::uint64_t next_ps) {
    board_moves_.cancel();
    if (next_ps == Agenda::NEVER) return;
    const std::uint64_t now_ps = sc_time_stamp().value();
    board_moves_.notify(picoseconds(std::max(next_ps, now_ps) - now_ps));
}

void Fpga::board_moves() { run_to(sc_time_stamp()); }

namespace {

std::uint64_t next_event_ps() {
    return (sc_time_stamp() + sc_core::sc_time_to_pending_activity()).value();
}

}  // namespace

// In a transaction, and only in a thread: SystemC comes to the present of the fabric.
std::uint64_t Fpga::let_others_go() {
    if (sc_core::sc_get_current_process_handle().proc_kind() != sc_core::SC_THREAD_PROC_)
        return Agenda::NEVER;
    const std::uint64_t edge_ps = fabric_.time_ps() + FABRIC_PERIOD_PS;
    std::uint64_t next_ps;
    while ((next_ps = next_event_ps()) < edge_ps) wait(sc_core::sc_time_to_pending_activity());
    return next_ps;
}

void Fpga::notify_interrupts() {
    const std::uint64_t levels = fabric_.irq();
    if (levels == irq_) return;
    irq_ = levels;
    notify_(levels);
}

void Fpga::catch_up() {
    run_to(sc_time_stamp());
    fabric_.flush();
}

JtagInputs& Fpga::jtag() {
    run_to(sc_time_stamp());
    return fabric_.jtag;
}

std::optional<std::uint32_t> Fpga::peek(std::uint32_t offset) {
    std::uint8_t bytes[4];
    if (fabric_.read(Bridge::LIGHTWEIGHT, offset, bytes, 4) != AxiResponse::OKAY) return {};
    std::uint32_t value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

bool Fpga::peek_full(std::uint32_t offset, std::uint8_t* bytes, unsigned count) {
    return fabric_.read(Bridge::FULL, offset, bytes, count) == AxiResponse::OKAY;
}

// 0 to a clock; Vigna's splitmix64.
std::uint64_t Fpga::phase_ps() {
    if (!seed_) return HALF_CLOCK_PS;
    std::uint64_t z = *seed_ + ++meetings_ * 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return (z ^ (z >> 31)) % FABRIC_PERIOD_PS;
}

void Fpga::scan_line() {
    catch_up();
    next_trigger(scan_line_time - picoseconds(HALF_CLOCK_PS) + picoseconds(phase_ps()));
}

void Fpga::lightweight_transport(tlm::tlm_generic_payload& tx, sc_time& delay) {
    transport(Bridge::LIGHTWEIGHT, tx, delay);
}

void Fpga::full_transport(tlm::tlm_generic_payload& tx, sc_time& delay) {
    transport(Bridge::FULL, tx, delay);
}

bool Fpga::direct_memory(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    if (!sdram_ || tx.get_address() - SDRAM >= regmap::SDRAM_SIZE) return false;
    dmi.set_dmi_ptr(sdram_);
    dmi.set_start_address(SDRAM);
    dmi.set_end_address(SDRAM + regmap::SDRAM_SIZE - 1);
    memory_ == Memory::MAPPED ? dmi.allow_read_write() : dmi.allow_read();
    return true;
}

// A burst to or from a memory.  Returns the clocks that it takes the bridge while neither the
// screen nor a refresh is in its way; 0 if it is elsewhere.
std::uint64_t Fpga::mapped(bool write, std::uint32_t address, std::uint8_t* data, unsigned bytes) {
    const std::uint64_t words = (address + bytes - 1) / 4 - address / 4 + 1;
    if (address - ONCHIP < regmap::ONCHIP_SIZE) {
        if (write)
            fabric_.write_onchip(address - ONCHIP, data, bytes);
        else
            fabric_.read_onchip(address - ONCHIP, data, bytes);
        return write ? 4 + words : 1 + 4 * words;
    }
    if (!sdram_ || address - SDRAM >= regmap::SDRAM_SIZE) return 0;
    if (write)
        std::memcpy(sdram_ + (address - SDRAM), data, bytes);
    else
        std::memcpy(data, sdram_ + (address - SDRAM), bytes);
    return write ? std::max<std::uint64_t>(5, 2 + 2 * words) : 1 + 6 * words;
}

// Not past SystemC's next event, where somebody may look at the pins.
std::optional<std::uint64_t> Fpga::again(bool write, std::uint64_t begin_ps) {
    const std::uint64_t start = start_of(begin_ps), end = start + took_[write];
    if (end == start) return {};
    if (end > calm_until_) {
        const std::uint64_t event = next_event_ps();
        if (end * FABRIC_PERIOD_PS >= event) return {};
        const std::uint64_t before = fabric_.changes();
        fabric_.run(start - fabric_.clocks());
        if (fabric_.changes() != before) return {};
        calm_until_ = std::min(start + fabric_.calm(), (event - 1) / FABRIC_PERIOD_PS);
        if (end > calm_until_) return {};
    }
    busy_until_ = end;
    const std::uint64_t earliest = sc_time_stamp().value() + HALF_CLOCK_PS;
    return std::max(end * FABRIC_PERIOD_PS, earliest) - HALF_CLOCK_PS + phase_ps();
}

void Fpga::transport(Bridge bridge, tlm::tlm_generic_payload& tx, sc_time& delay) {
    const unsigned bytes = tx.get_data_length();
    calm_until_ = 0;
    if (tx.get_command() == tlm::TLM_IGNORE_COMMAND) {
        tx.set_response_status(tlm::TLM_COMMAND_ERROR_RESPONSE);
        return;
    }
    if (bytes == 0 || tx.get_streaming_width() < bytes) {
        tx.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
        return;
    }
    if (tx.get_byte_enable_ptr()) {
        tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
        return;
    }
    const bool write = tx.get_command() == tlm::TLM_WRITE_COMMAND;
    auto address = static_cast<std::uint32_t>(tx.get_address());
    std::uint8_t* data = tx.get_data_ptr();
    AxiResponse response = AxiResponse::OKAY;

    const bool map = bridge == Bridge::FULL && memory_ == Memory::MAPPED;
    if (closed_) wait(never_);
    busy_ = true;
    fabric_.meet(next_event_ps(), &others_go_);
    for (unsigned left = bytes; left && response == AxiResponse::OKAY;) {
        const unsigned now = burst_bytes(address, left);
        const sc_time begin = sc_time_stamp() + delay;
        std::uint64_t end = map ? mapped(write, address, data, now) : 0;
        if (end) {
            end += start_of(begin.value());
        } else {
            run_to(begin);
            const std::uint64_t start = fabric_.clocks();
            response = write ? fabric_.write(bridge, address, data, now)
                             : fabric_.read(bridge, address, data, now);
            if (response == AxiResponse::PENDING)
                response = fabric_.await_write(bridge, WRITE_CLOCKS);
            end = fabric_.clocks();
            if (bridge == Bridge::LIGHTWEIGHT && end - start <= Fabric::LONGEST_ACCESS)
                took_[write] = end - start;
        }
        address += now;
        data += now;
        left -= now;
        delay = picoseconds(end * FABRIC_PERIOD_PS) - sc_time_stamp();
        if (left && delay >= sc_core::sc_time_to_pending_activity()) {
            wait(delay);
            delay = sc_core::SC_ZERO_TIME;
            fabric_.meet(next_event_ps(), &others_go_);
        }
    }
    fabric_.meet(Agenda::NEVER, nullptr);
    busy_ = false;
    delay = std::max(delay, picoseconds(HALF_CLOCK_PS)) - picoseconds(HALF_CLOCK_PS) +
            picoseconds(phase_ps());
    notify_interrupts();
    tx.set_response_status(status_of(response));
}

}  // namespace sim
