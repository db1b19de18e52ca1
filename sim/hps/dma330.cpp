#include "sim/hps/dma330.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace sim {

namespace {

const sc_core::sc_time dma_clock{5, sc_core::SC_NS};
const sc_core::sc_time request_look{1, sc_core::SC_US};  // of a channel that waits for the FPGA
constexpr unsigned REQUESTS = 8;                         // peripherals of the FPGA
constexpr std::uint32_t ABORT_LINE = 1u << Dma330::EVENTS;
// Fault types
constexpr std::uint32_t UNDEFINED = 1 << 0, OPERAND = 1 << 1, MFIFO = 1 << 12, FETCH = 1 << 16,
                        STORE = 1 << 17, LOAD = 1 << 18;
// 8 channels, 32 requests, 8 events; 64 bits, 8 and 16 outstanding, 512 lines.
constexpr std::uint32_t CR0 = 0x000FF071, CR1 = 0x00000075, CRD = 0x1FF7F73;
constexpr std::size_t DMA_BUFFER = 512 * 8;
constexpr std::uint32_t PERIPHERAL_ID = 0x00241330, CELL_ID = 0xB105F00D;

std::uint32_t word(const std::uint8_t* bytes) {
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 |
           static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

constexpr unsigned MOST_BYTES = 16 * 8;  // of a burst

AxiAttributes attributes(unsigned channel, unsigned beat_bytes, bool fixed, unsigned cache,
                         unsigned prot) {
    AxiAttributes how;
    how.master = AxiAttributes::Master::DMA;
    how.channel = channel;
    how.beat_bytes = beat_bytes;
    how.fixed = fixed;
    how.cache = cache;
    how.prot = prot;
    return how;
}

// Of the instruction that begins with this byte; 0: there is none.
unsigned length(std::uint8_t op) {
    switch (op) {
        case 0x00:  // DMAEND
        case 0x01:  // DMAKILL
        case 0x04:
        case 0x05:
        case 0x07:  // DMALD
        case 0x08:
        case 0x09:
        case 0x0B:  // DMAST
        case 0x0C:  // DMASTZ
        case 0x12:
        case 0x13:            // DMARMB, DMAWMB
        case 0x18: return 1;  // DMANOP
        case 0x20:
        case 0x22:  // DMALP
        case 0x25:
        case 0x27:  // DMALDP
        case 0x29:
        case 0x2B:  // DMASTP
        case 0x30:
        case 0x31:
        case 0x32:  // DMAWFP
        case 0x34:
        case 0x35:
        case 0x36: return 2;  // DMASEV, DMAFLUSHP, DMAWFE
        case 0x54:
        case 0x56:
        case 0x5C:
        case 0x5E: return 3;  // DMAADDH, DMAADNH
        case 0xA0:
        case 0xA2:
        case 0xBC: return 6;  // DMAGO, DMAMOV
        default: break;
    }
    const std::uint8_t kind = op & 0x0B;  // DMALPEND, with or without a count
    const bool loop = (op & 0xE8) == 0x28 && (kind == 0x08 || kind == 0x09 || kind == 0x0B);
    return loop ? 2 : 0;
}

}  // namespace

Dma330::Dma330(const sc_core::sc_module_name& module_name, Wires wires)
    : Registers{module_name}, wires_{std::move(wires)} {
    SC_HAS_PROCESS(Dma330);
    SC_THREAD(serve);
}

void Dma330::reset() {
    channels_ = {};
    enabled_ = events_ = acknowledged_ = 0;
    put_acknowledgements();
    update();
}

// ---- Programs ----

void Dma330::serve() {
    for (;;) {
        bool runs = false, waits = false;
        sc_core::sc_time delay;
        if (wires_in_fabric_) wires_in_fabric_->catch_up(sc_core::sc_time_stamp());
        for (unsigned n = 0; n < CHANNELS; ++n) {
            if (takes_request(channels_[n])) channels_[n].state = State::EXECUTING;
            waits |= channels_[n].state == State::WAITS_FOR_PERIPHERAL;
            if (channels_[n].state != State::EXECUTING) continue;
            runs = true;
            delay += dma_clock;
            step(n, delay);
        }
        if (runs)
            wait(delay);
        else if (waits && wires_in_fabric_)
            wait(request_look, start_);
        else
            wait(start_);
        put_acknowledgements();
    }
}

// ---- Peripherals ----

void Dma330::wait_for_peripheral(Channel& channel, unsigned number, std::uint8_t op,
                                 unsigned which) {
    channel.state = State::WAITS_FOR_PERIPHERAL;
    channel.event = static_cast<std::uint8_t>(which);
    channel.bursts_alone = op & 2;
    channel.of_its_kind = op & 1;
    if (which >= REQUESTS || !wires_in_fabric_)
        wires_.log(fmt::format(
            "channel {} of the DMA controller waits for a request of peripheral {}; none makes "
            "any here",
            number, which));
}

// DMAWFPS and DMAWFPP also let a single transfer be done; DMAWFPS takes a burst for one.
bool Dma330::takes_request(Channel& channel) {
    if (channel.state != State::WAITS_FOR_PERIPHERAL || channel.event >= REQUESTS) return false;
    const std::uint32_t burst = 1u << channel.event, single = burst << REQUESTS,
                        open = requests_ & ~acknowledged_;
    if (acknowledged_ & (burst | single)) return false;
    if ((open & burst) && (channel.bursts_alone || channel.of_its_kind))
        channel.request = Channel::BURST;
    else if ((open & (burst | single)) && !channel.bursts_alone)
        channel.request = Channel::SINGLE;
    else
        return false;
    return true;
}

// The transfer has been done: all that the peripheral asks for now is answered.
void Dma330::acknowledge(unsigned peripheral, Channel::Request request) {
    if (peripheral >= REQUESTS) return;
    const std::uint32_t burst = 1u << peripheral, single = burst << REQUESTS;
    acknowledged_ |= requests_ & (request == Channel::BURST ? burst : burst | single);
}

void Dma330::put_acknowledgements() {
    const std::uint32_t now = (acknowledged_ | acknowledged_ >> REQUESTS) & ((1u << REQUESTS) - 1);
    if (std::exchange(acknowledgements_, now) != now && wires_in_fabric_)
        wires_in_fabric_->drive(now, sc_core::sc_time_stamp());
}

void Dma330::moved(std::uint64_t requests) {
    requests_ = static_cast<std::uint32_t>(requests);
    acknowledged_ &= requests_;
    start_.notify(sc_core::SC_ZERO_TIME);
}

void Dma330::step(unsigned number, sc_core::sc_time& delay) {
    Channel& channel = channels_[number];
    std::uint8_t code[6] = {};
    sc_core::sc_time fetched;  // ahead, from its instruction cache
    AxiAttributes how = attributes(number, 1, false, 0, 0);
    if (!wires_.access(false, channel.pc, code, 1, how, fetched)) return fail(number, FETCH);
    const unsigned bytes = length(code[0]);
    if (bytes == 0 || code[0] == 0xA0 || code[0] == 0xA2) return fail(number, UNDEFINED);
    for (unsigned i = 1; i < bytes; ++i)
        if (!wires_.access(false, channel.pc + i, code + i, 1, how, fetched))
            return fail(number, FETCH);
    const std::uint32_t next = channel.pc + bytes;
    const std::uint8_t op = code[0];
    const unsigned operand = code[1] >> 3;
    // Of what was asked for last; DMALDS and others do nothing if it is not their kind.
    const bool is_burst = channel.request == Channel::NONE ? (channel.control >> 4 & 0xF) != 0
                                                           : channel.request == Channel::BURST;
    const auto is_meant = [&] { return ((op & 2) != 0) == is_burst; };
    const auto beats = [&] { return op & 2 ? Beats::OF_CONTROL : Beats::ONE; };
    channel.pc = next;
    switch (op) {
        case 0x00:
            channel.state = State::STOPPED;
            channel.fifo.clear();
            return;
        case 0x01:
            channel.state = State::STOPPED;
            channel.fifo.clear();
            return;
        case 0x04: return load(channel, number, Beats::OF_CONTROL, delay);
        case 0x05:
        case 0x07: return is_meant() ? load(channel, number, beats(), delay) : void();
        case 0x08: return store(channel, number, Beats::OF_CONTROL, false, delay);
        case 0x09:
        case 0x0B: return is_meant() ? store(channel, number, beats(), false, delay) : void();
        case 0x0C: return store(channel, number, Beats::OF_CONTROL, true, delay);
        case 0x20:
        case 0x22: channel.loops[op >> 1 & 1] = code[1]; return;
        case 0x25:
        case 0x27:
            if (!is_meant()) return;
            load(channel, number, beats(), delay);
            return acknowledge(operand, channel.request);
        case 0x29:
        case 0x2B:
            if (!is_meant()) return;
            store(channel, number, beats(), false, delay);
            return acknowledge(operand, channel.request);
        case 0x30:
        case 0x31:
        case 0x32: return wait_for_peripheral(channel, number, op, operand);
        case 0x34:
            if (operand >= EVENTS) return fail(number, OPERAND);
            return signal(operand);
        case 0x36:
            if (operand >= EVENTS) return fail(number, OPERAND);
            if (events_ & ~enabled_ & 1u << operand) {
                events_ &= ~(1u << operand);
            } else {
                channel.state = State::WAITS_FOR_EVENT;
                channel.event = static_cast<std::uint8_t>(operand);
            }
            return;
        case 0x54: channel.source += static_cast<std::uint32_t>(code[1] | code[2] << 8); return;
        case 0x56:
            channel.destination += static_cast<std::uint32_t>(code[1] | code[2] << 8);
            return;
        case 0x5C: channel.source += 0xFFFF0000u | code[1] | code[2] << 8; return;
        case 0x5E: channel.destination += 0xFFFF0000u | code[1] | code[2] << 8; return;
        case 0xBC: {
            std::uint32_t* const registers[] = {&channel.source, &channel.control,
                                                &channel.destination};
            if (code[1] > 2) return fail(number, OPERAND);
            *registers[code[1]] = word(code + 2);
            return;
        }
        default: break;
    }
    // Barriers, DMANOP, DMAFLUSHP: nothing is outstanding, and a request is not remembered here.
    if ((op & 0xE8) != 0x28) return;
    const bool counts = op & 0x10;
    std::uint32_t& loop = channel.loops[op >> 2 & 1];
    if ((op & 1) && !is_meant()) return;
    if (counts && loop-- == 0) {
        loop = 0;
        return;
    }
    channel.pc = next - bytes - code[1];
}

void Dma330::load(Channel& channel, unsigned number, Beats how_many, sc_core::sc_time& delay) {
    const unsigned size = 1u << (channel.control >> 1 & 7),
                   beats = how_many == Beats::ONE ? 1 : (channel.control >> 4 & 0xF) + 1;
    if (size > 8) return fail(number, OPERAND);
    const bool moves = channel.control & 1;
    std::uint8_t data[MOST_BYTES];
    AxiAttributes how =
        attributes(number, size, !moves, channel.control >> 11 & 7, channel.control >> 8 & 7);
    if (!wires_.access(false, channel.source, data, size * beats, how, delay))
        return fail(number, LOAD);
    channel.fifo.insert(channel.fifo.end(), data, data + size * beats);
    if (moves) channel.source += size * beats;
    if (channel.fifo.size() > DMA_BUFFER) fail(number, MFIFO);
}

void Dma330::store(Channel& channel, unsigned number, Beats how_many, bool zeros,
                   sc_core::sc_time& delay) {
    const unsigned size = 1u << (channel.control >> 15 & 7),
                   beats = how_many == Beats::ONE ? 1 : (channel.control >> 18 & 0xF) + 1;
    if (size > 8) return fail(number, OPERAND);
    const bool moves = channel.control & 1 << 14;
    const unsigned cache = channel.control >> 25 & 7;  // AWCACHE[3], and its bits 1 and 0
    std::uint8_t data[MOST_BYTES] = {};
    if (!zeros) {
        if (channel.fifo.size() < size * beats) return fail(number, MFIFO);
        const auto end = channel.fifo.begin() + size * beats;
        std::copy(channel.fifo.begin(), end, data);
        channel.fifo.erase(channel.fifo.begin(), end);
    }
    AxiAttributes how =
        attributes(number, size, !moves, (cache & 4) << 1 | (cache & 3), channel.control >> 22 & 7);
    if (!wires_.access(true, channel.destination, data, size * beats, how, delay))
        return fail(number, STORE);
    if (moves) channel.destination += size * beats;
}

// An interrupt, or else for who waits for the event.
void Dma330::signal(unsigned event) {
    events_ |= 1u << event;
    if (!(enabled_ >> event & 1))
        for (Channel& channel : channels_)
            if (channel.state == State::WAITS_FOR_EVENT && channel.event == event) {
                channel.state = State::EXECUTING;
                events_ &= ~(1u << event);
            }
    update();
}

void Dma330::fail(unsigned number, std::uint32_t why) {
    channels_[number].state = State::FAULTING;
    channels_[number].fault = why;
    update();
}

void Dma330::update() {
    std::uint32_t up = events_ & enabled_;
    for (const Channel& channel : channels_)
        if (channel.state == State::FAULTING) up |= ABORT_LINE;
    const std::uint32_t moved = std::exchange(up_, up) ^ up;
    for (unsigned event = 0; event < EVENTS; ++event)
        if (moved >> event & 1) wires_.interrupt(event, up >> event & 1);
    if (moved & ABORT_LINE) wires_.abort(up & ABORT_LINE);
}

// ---- Registers ----

void Dma330::debug() {
    const std::uint32_t op = instruction_[0] >> 16 & 0xFF, second = instruction_[0] >> 24;
    const bool of_channel = instruction_[0] & 1;
    Channel& addressed = channels_[instruction_[0] >> 8 & 7];
    if ((op == 0xA0 || op == 0xA2) && !of_channel) {
        Channel& channel = channels_[second & 7];
        if (channel.state != State::STOPPED) return;
        channel = Channel{};
        channel.state = State::EXECUTING;
        channel.pc = instruction_[1];
        start_.notify(sc_core::SC_ZERO_TIME);
    } else if (op == 0x01 && of_channel) {
        addressed.state = State::STOPPED;
        addressed.fault = 0;
        addressed.fifo.clear();
        update();
    } else if (op == 0x34 && (second >> 3) < EVENTS) {
        signal(second >> 3);
        start_.notify(sc_core::SC_ZERO_TIME);
    }
}

std::uint32_t Dma330::read(std::uint32_t offset, const sc_core::sc_time&) {
    if (offset >= 0x040 && offset < 0x040 + 4 * CHANNELS)
        return channels_[(offset - 0x040) / 4].fault;
    if (offset >= 0x100 && offset < 0x100 + 8 * CHANNELS) {
        const Channel& channel = channels_[(offset - 0x100) / 8];
        if (offset % 8) return channel.pc;
        return static_cast<std::uint32_t>(channel.state) |
               static_cast<std::uint32_t>(channel.event) << 4 |
               (channel.bursts_alone ? 1u << 14 : 0u) | (channel.of_its_kind ? 1u << 15 : 0u);
    }
    if (offset >= 0x400 && offset < 0x400 + 0x20 * CHANNELS) {
        const Channel& channel = channels_[(offset - 0x400) / 0x20];
        const std::uint32_t values[8] = {channel.source, channel.destination, channel.control,
                                         channel.loops[0], channel.loops[1]};
        return values[offset % 0x20 / 4];
    }
    std::uint32_t faulting = 0;
    for (unsigned n = 0; n < CHANNELS; ++n)
        if (channels_[n].state == State::FAULTING) faulting |= 1u << n;
    switch (offset) {
        case 0x020: return enabled_;
        case 0x024: return events_;
        case 0x028: return events_ & enabled_;
        case 0x034: return faulting;
        case 0xE00: return CR0;
        case 0xE04: return CR1;
        case 0xE14: return CRD;
        default: break;
    }
    if (offset >= 0xFE0 && offset < 0xFF0) return PERIPHERAL_ID >> (offset - 0xFE0) * 2 & 0xFF;
    if (offset >= 0xFF0) return CELL_ID >> (offset - 0xFF0) * 2 & 0xFF;
    return 0;  // the manager is stopped, the debug unit is idle
}

void Dma330::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) {
    switch (offset) {
        case 0x020: enabled_ = value & ((1u << EVENTS) - 1); break;
        case 0x02C: events_ &= ~(value & enabled_); break;
        case 0xD04:
            if ((value & 3) == 0) debug();
            break;
        case 0xD08: instruction_[0] = value; break;
        case 0xD0C: instruction_[1] = value; break;
        default: break;
    }
    update();
}

}  // namespace sim
