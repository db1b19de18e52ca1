#include "sim/hps/gic.h"

namespace sim {

namespace {

// Distributor: banks with one bit, two bits, or one byte per interrupt.
constexpr std::uint32_t ICDDCR = 0x000, ICDICTR = 0x004, ICDIIDR = 0x008, ICDISR = 0x080,
                        ICDISER = 0x100, ICDICER = 0x180, ICDISPR = 0x200, ICDICPR = 0x280,
                        ICDABR = 0x300, ICDIPR = 0x400, ICDIPTR = 0x800, ICDICFR = 0xC00,
                        ICDSGIR = 0xF00;
constexpr std::uint32_t ICCICR = 0x00, ICCPMR = 0x04, ICCBPR = 0x08, ICCIAR = 0x0C, ICCEOIR = 0x10,
                        ICCRPR = 0x14, ICCHPIR = 0x18, ICCIIDR = 0xFC;

// 256 IDs, two processors, security extensions; ARM's r0p1 of the interface, r0p2 of the rest.
constexpr std::uint32_t TYPE = 0x427, DISTRIBUTOR_ID = 0x0102043B, INTERFACE_ID = 0x3901243B;
constexpr std::uint8_t PRIORITY_BITS = 0xF8, TARGET_BITS = 0x03;
constexpr std::uint8_t SMALLEST_BINARY_POINT = 2;
constexpr unsigned FIRST_PRIVATE = 16, GLOBAL_TIMER = 27, FIRST_SHARED = 32;

template <class Bit>
std::uint32_t gather(unsigned first, unsigned count, Bit bit) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < count; ++i) word |= static_cast<std::uint32_t>(bit(first + i)) << i;
    return word;
}

template <class Set>
void spread(std::uint32_t word, unsigned first, Set set) {
    for (unsigned i = 0; i < 32; ++i)
        if (word >> i & 1) set(first + i);
}

template <class Bytes>
std::uint32_t bytes_at(const Bytes& bytes, unsigned first) {
    std::uint32_t word = 0;
    for (unsigned i = 0; i < 4; ++i) word |= static_cast<std::uint32_t>(bytes[first + i]) << 8 * i;
    return word;
}

bool in(std::uint32_t offset, std::uint32_t bank, std::uint32_t bytes) {
    return offset - bank < bytes;
}

}  // namespace

// ---- Distributor --------------------------------------------------------------------------------

GicDistributor::GicDistributor(const sc_core::sc_module_name& module_name, Gic& gic)
    : Registers{module_name}, gic_{gic} {}

std::uint32_t GicDistributor::read(std::uint32_t offset, const sc_core::sc_time&) {
    const GicState& s = gic_.state_;
    const unsigned bit = offset % 0x80 * 8, byte = offset % 0x400;
    if (offset == ICDDCR) return s.distribute_secure | s.distribute_non_secure << 1;
    if (offset == ICDICTR) return TYPE;
    if (offset == ICDIIDR) return DISTRIBUTOR_ID;
    if (in(offset, ICDISR, 0x20))
        return gather(bit, 32, [&](unsigned i) { return s.non_secure[i]; });
    if (in(offset, ICDISER, 0x20) || in(offset, ICDICER, 0x20))
        return gather(bit, 32, [&](unsigned i) { return s.enabled[i]; });
    if (in(offset, ICDISPR, 0x20) || in(offset, ICDICPR, 0x20))
        return gather(bit, 32, [&](unsigned i) { return s.pending(i); });
    if (in(offset, ICDABR, 0x20)) return gather(bit, 32, [&](unsigned i) { return s.active[i]; });
    if (in(offset, ICDIPR, 0x100)) return bytes_at(s.priority, byte);
    if (in(offset, ICDIPTR, 0x100)) return bytes_at(s.targets, byte);
    if (in(offset, ICDICFR, 0x40)) {  // bit 1 of a pair: edge; bit 0: served by one of N
        const unsigned first = (offset - ICDICFR) * 4;
        std::uint32_t word = 0;
        for (unsigned i = 0; i < 16; ++i) {
            const bool to_one = first + i >= GLOBAL_TIMER;
            word |= (s.edge[first + i] ? 2u : 0u) << 2 * i | (to_one ? 1u : 0u) << 2 * i;
        }
        return word;
    }
    return 0;
}

void GicDistributor::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    GicState& s = gic_.state_;
    const unsigned bit = offset % 0x80 * 8, byte = offset % 0x400;
    if (offset == ICDDCR) {
        s.distribute_secure = value & 1;
        s.distribute_non_secure = value & 2;
    } else if (in(offset, ICDISR, 0x20)) {
        for (unsigned i = 0; i < 32; ++i) s.non_secure[bit + i] = value >> i & 1;
    } else if (in(offset, ICDISER, 0x20)) {
        spread(value, bit, [&](unsigned i) { s.enabled[i] = true; });
    } else if (in(offset, ICDICER, 0x20)) {
        spread(value, bit, [&](unsigned i) { s.enabled[i] = i < FIRST_PRIVATE; });
    } else if (in(offset, ICDISPR, 0x20)) {
        spread(value, bit, [&](unsigned i) {
            if (i < FIRST_PRIVATE) return;
            s.latched[i] = true;
            gic_.raised_at_[i] = now;
        });
    } else if (in(offset, ICDICPR, 0x20)) {
        spread(value, bit, [&](unsigned i) { s.latched[i] = s.latched[i] && i < FIRST_PRIVATE; });
    } else if (in(offset, ICDIPR, 0x100)) {
        for (unsigned i = 0; i < 4; ++i)
            s.priority[byte + i] = static_cast<std::uint8_t>(value >> 8 * i & PRIORITY_BITS);
    } else if (in(offset, ICDIPTR, 0x100)) {
        for (unsigned i = 0; i < 4; ++i)
            if (byte + i >= FIRST_SHARED)
                s.targets[byte + i] = static_cast<std::uint8_t>(value >> 8 * i & TARGET_BITS);
    } else if (in(offset, ICDICFR, 0x40)) {
        const unsigned first = (offset - ICDICFR) * 4;
        for (unsigned i = 0; i < 16; ++i)
            if (first + i >= FIRST_SHARED) s.edge[first + i] = value >> (2 * i + 1) & 1;
    } else if (offset == ICDSGIR) {
        send(value, now);
    }
    gic_.update();
}

// To itself, or to a list that includes it; the other processors do not exist.
void GicDistributor::send(std::uint32_t value, const sc_core::sc_time& now) {
    const std::uint32_t filter = value >> 24 & 3;
    if (filter != 2 && !(filter == 0 && (value >> 16 & 1))) return;
    gic_.state_.latched[value & 0xF] = true;
    gic_.raised_at_[value & 0xF] = now;
}

// ---- CPU interface ------------------------------------------------------------------------------

GicCpuInterface::GicCpuInterface(const sc_core::sc_module_name& module_name, Gic& gic)
    : Registers{module_name}, gic_{gic} {}

std::uint32_t GicCpuInterface::read(std::uint32_t offset, const sc_core::sc_time&) {
    GicState& s = gic_.state_;
    switch (offset) {
        case ICCICR: return s.control;
        case ICCPMR: return s.mask;
        case ICCBPR: return s.binary_point;
        case ICCIAR: {
            const unsigned id = s.acknowledge();
            gic_.update();
            return id;
        }
        case ICCRPR: return s.running_priority();
        case ICCHPIR: return s.highest_pending();
        case ICCIIDR: return INTERFACE_ID;
        default: return 0;
    }
}

void GicCpuInterface::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) {
    GicState& s = gic_.state_;
    switch (offset) {
        case ICCICR: s.control = value & 0x1F; break;
        case ICCPMR: s.mask = static_cast<std::uint8_t>(value & PRIORITY_BITS); break;
        case ICCBPR:
            s.binary_point = static_cast<std::uint8_t>(value & 7);
            if (s.binary_point < SMALLEST_BINARY_POINT) s.binary_point = SMALLEST_BINARY_POINT;
            break;
        case ICCEOIR: s.end(value & 0x3FF); break;
        default: break;
    }
    gic_.update();
}

// ---- The whole ----------------------------------------------------------------------------------

Gic::Gic(const sc_core::sc_module_name& name, std::function<void(bool, bool)> signal)
    : sc_module{name},
      distributor{"distributor", *this},
      cpu_interface{"cpu_interface", *this},
      signal_{std::move(signal)} {}

void Gic::set_level(unsigned id, bool up) {
    if (state_.level[id] == up) return;
    if (up) raised_at_[id] = sc_core::sc_time_stamp();
    state_.set_level(id, up);
    update();
}

void Gic::update() {
    bool irq, fiq;
    state_.signals(irq, fiq);
    if (irq == irq_ && fiq == fiq_) return;
    irq_ = irq;
    fiq_ = fiq;
    signal_(irq, fiq);
}

}  // namespace sim
