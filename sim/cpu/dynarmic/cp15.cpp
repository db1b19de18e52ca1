#include "sim/cpu/dynarmic/cp15.h"

namespace sim {

namespace {

// Registers that hold what was written, and their reset values.
struct Reset {
    Cp15 name;
    std::uint32_t value;
};
constexpr Reset PLAIN[] = {
    {cp15::SCTLR, 0x00C50078},
    {{1, 0, 0, 1}, 0},  // ACTLR
    {cp15::CPACR, 0},   // neither VFP nor NEON
    {cp15::SCR, 0},
    {{1, 0, 1, 1}, 0},      // SDER
    {{1, 0, 1, 2}, 0xC00},  // NSACR
    {cp15::TTBR0, 0},
    {cp15::TTBR1, 0},
    {cp15::TTBCR, 0},
    {cp15::DACR, 0},
    {cp15::DFSR, 0},
    {cp15::IFSR, 0},
    {{5, 0, 1, 0}, 0},
    {{5, 0, 1, 1}, 0},  // ADFSR, AIFSR
    {cp15::DFAR, 0},
    {cp15::IFAR, 0},
    {cp15::PAR, 0},
    {{9, 0, 12, 0}, 0x41093000},  // PMCR
    {{9, 0, 12, 1}, 0},           // PMCNTENSET
    {{9, 0, 12, 5}, 0},           // PMSELR
    {{9, 0, 13, 1}, 0},           // PMXEVTYPER
    {{9, 0, 14, 0}, 0},           // PMUSERENR
    {{9, 0, 14, 1}, 0},           // PMINTENSET
    {{10, 0, 0, 0}, 0},           // TLB lockdown
    {{10, 0, 2, 0}, 0x00098AA4},  // PRRR
    {{10, 0, 2, 1}, 0x44E048E0},  // NMRR
    {cp15::VBAR, 0},
    {{12, 0, 0, 1}, 0},  // MVBAR
    {{13, 0, 0, 0}, 0},  // FCSEIDR
    {cp15::CONTEXTIDR, 0},
    {{0, 2, 0, 0}, 0},   // CSSELR
    {{15, 0, 0, 0}, 0},  // power control
    {{15, 0, 0, 1}, 0},  // diagnostic
    {cp15::CBAR, 0xFFFEC000},
};

struct Identification {
    Cp15 name;
    std::uint32_t value;
};
constexpr Identification READ_ONLY[] = {
    {{0, 0, 0, 0}, 0x413FC090},                              // MIDR
    {{0, 0, 0, 1}, 0x83338003},                              // CTR
    {{0, 0, 0, 2}, 0},                                       // TCMTR
    {{0, 0, 0, 3}, 0x00000402},                              // TLBTR
    {{0, 0, 0, 5}, 0x80000000},                              // MPIDR: core 0
    {{0, 0, 0, 6}, 0},                                       // REVIDR
    {{0, 0, 1, 0}, 0x00001231}, {{0, 0, 1, 1}, 0x00000011},  // ID_PFR
    {{0, 0, 1, 2}, 0x00010444}, {{0, 0, 1, 3}, 0},           // ID_DFR0, ID_AFR0
    {{0, 0, 1, 4}, 0x00100103}, {{0, 0, 1, 5}, 0x20000000},  // ID_MMFR
    {{0, 0, 1, 6}, 0x01230000}, {{0, 0, 1, 7}, 0x00102111},
    {{0, 0, 2, 0}, 0x00101111}, {{0, 0, 2, 1}, 0x13112111},  // ID_ISAR
    {{0, 0, 2, 2}, 0x21232041}, {{0, 0, 2, 3}, 0x11112131},
    {{0, 0, 2, 4}, 0x00111142}, {{0, 1, 0, 1}, 0x09200003},  // CLIDR
    {{0, 1, 0, 7}, 0},                                       // AIDR
    {{12, 0, 1, 0}, 0},                                      // ISR
};
constexpr Cp15 CSSELR{0, 2, 0, 0}, CCSIDR{0, 1, 0, 0};
constexpr std::uint32_t DATA_CACHE = 0x701FE019,  // 32 KB: 4 ways of 256 lines
    INSTRUCTION_CACHE = 0x201FE019;

constexpr Cp15 PMCR{9, 0, 12, 0}, PMCNTENSET{9, 0, 12, 1}, PMCNTENCLR{9, 0, 12, 2},
    PMCCNTR{9, 0, 13, 0}, PMUSERENR{9, 0, 14, 0};
constexpr std::uint32_t PMCR_E = 1, PMCR_C = 1u << 2, PM_CYCLES = 1u << 31;

constexpr bool same(const Cp15& a, const Cp15& b) {
    return a.crn == b.crn && a.op1 == b.op1 && a.crm == b.crm && a.op2 == b.op2;
}
// Barriers as before ARMv7, by CP15: ISB, DSB, DMB.
bool is_barrier(const Cp15& n) {
    return n.crn == 7 && n.op1 == 0 &&
           ((n.crm == 5 && n.op2 == 4) || (n.crm == 10 && (n.op2 == 4 || n.op2 == 5)));
}

}  // namespace

void Cp15Registers::reset() {
    values_.clear();
    for (const Reset& reset : PLAIN) values_[key(reset.name)] = reset.value;
    tpidrurw = tpidruro = tpidrprw = 0;
    cycles_begin_ = 0;
    stopped_at_ = 0;
}

std::uint32_t& Cp15Registers::at(const Cp15& name) {
    if (same(name, cp15::TPIDRURW)) return tpidrurw;
    if (same(name, cp15::TPIDRURO)) return tpidruro;
    if (same(name, cp15::TPIDRPRW)) return tpidrprw;
    return values_[key(name)];
}

std::uint32_t Cp15Registers::value(const Cp15& name) const {
    return const_cast<Cp15Registers*>(this)->at(name);
}

std::uint64_t Cp15Registers::cycles(std::uint64_t instructions) const {
    return stopped_at_.value_or(instructions) - cycles_begin_;
}

// A register of the performance monitor that the user mode may use.
bool Cp15Registers::is_users_counter(const Cp15& n) const {
    return n.crn == 9 && n.op1 == 0 && (n.crm == 12 || n.crm == 13) && (value(PMUSERENR) & 1);
}

std::optional<std::uint32_t> Cp15Registers::read(const Cp15& n, bool privileged,
                                                 std::uint64_t instructions) const {
    if (n.crn == 13 && n.op1 == 0 && n.crm == 0 && (n.op2 == 2 || n.op2 == 3)) return value(n);
    if (!privileged && !same(n, PMUSERENR) && !is_users_counter(n)) return std::nullopt;
    if (same(n, PMCCNTR)) return static_cast<std::uint32_t>(cycles(instructions));
    if (same(n, cp15::TPIDRPRW)) return tpidrprw;
    if (same(n, CCSIDR)) return value(CSSELR) & 1 ? INSTRUCTION_CACHE : DATA_CACHE;
    if (same(n, PMCNTENCLR)) return value(PMCNTENSET);
    for (const Identification& id : READ_ONLY)
        if (same(n, id.name)) return id.value;
    const auto plain = values_.find(key(n));
    if (plain != values_.end()) return plain->second;
    if (n.crn == 9 || n.crn == 11 || n.crn == 10) return 0;  // event counters, lockdown
    return std::nullopt;
}

std::optional<Cp15Registers::Effect> Cp15Registers::write(const Cp15& n, std::uint32_t value,
                                                          bool privileged,
                                                          std::uint64_t instructions) {
    if (same(n, cp15::TPIDRURW)) {
        tpidrurw = value;
        return Effect::NONE;
    }
    if (is_barrier(n)) return Effect::NONE;
    if (!privileged && !is_users_counter(n)) return std::nullopt;
    if (same(n, cp15::PAR)) {
        at(n) = value;
        return Effect::NONE;
    }
    if (n.crn == 7) return Effect::NONE;         // caches
    if (n.crn == 8) return Effect::TRANSLATION;  // TLB
    if (n.crn == 9) {
        if (same(n, PMCNTENCLR))
            at(PMCNTENSET) &= ~value;
        else if (same(n, PMCNTENSET))
            at(PMCNTENSET) |= value;
        else if (same(n, PMCR))
            at(PMCR) = 0x41093000 | (value & 0x39);
        else if (!same(n, PMCCNTR) && values_.count(key(n)))
            at(n) = value;
        const std::uint64_t now = same(n, PMCCNTR)                    ? value
                                  : same(n, PMCR) && (value & PMCR_C) ? 0
                                                                      : cycles(instructions);
        const bool counts = (at(PMCR) & PMCR_E) && (at(PMCNTENSET) & PM_CYCLES);
        cycles_begin_ = instructions - now;
        stopped_at_ = counts ? std::nullopt : std::optional<std::uint64_t>{instructions};
        return Effect::NONE;
    }
    if (same(n, cp15::TPIDRURO) || same(n, cp15::TPIDRPRW)) {
        at(n) = value;
        return Effect::NONE;
    }
    if (n.crn == 10 || n.crn == 11) {
        if (values_.count(key(n))) at(n) = value;
        return n.crm == 2 ? Effect::TRANSLATION : Effect::NONE;
    }
    if (n.crn == 0 && !same(n, CSSELR)) return std::nullopt;
    const auto plain = values_.find(key(n));
    if (plain == values_.end()) return std::nullopt;
    plain->second = same(n, cp15::SCTLR) ? value | 0x00C50078 : value;
    if (n.crn == 2 || n.crn == 3 || same(n, cp15::SCTLR) || same(n, cp15::CONTEXTIDR))
        return Effect::TRANSLATION;
    return same(n, cp15::CPACR) ? Effect::FLOATING_POINT : Effect::NONE;
}

}  // namespace sim
