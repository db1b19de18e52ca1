// data.cpp - loads and stores that the page table does not serve: pages used for the first time,
// pages with code in them, accesses across two pages, the bus, and addresses without a target.
//
// Only a single step may access the bus or abort, because only then the count and all registers are
// those before the instruction.  In translated code such an access stops the run before its
// instruction.
#include <cstring>

#include "sim/cpu/dynarmic/engine.h"
#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

constexpr std::uint32_t PAGE_MASK = 0xFFF;

// Bytes of the largest aligned piece there, of at most four.
unsigned aligned_piece(std::uint32_t address, unsigned left) {
    return left >= 4 && address % 4 == 0 ? 4 : left >= 2 && address % 2 == 0 ? 2 : 1;
}

}  // namespace

// Translated code stops before the present instruction; a step does it then.
bool ArmCore::Engine::miss(std::uint32_t address) {
    if (stepping) return false;
    missed = true;
    missed_address = address;
    cpu.jit->HaltExecution(Dynarmic::HaltReason::MemoryAbort);
    return true;
}

bool ArmCore::Engine::refuse(std::uint32_t address, bool write, bool by_tables,
                             std::uint32_t status) {
    aborted = true;
    core.fault_ = {address, write, by_tables, status};
    cpu.jit->HaltExecution(Dynarmic::HaltReason::MemoryAbort);
    return false;
}

// False: the access must not be done.
bool ArmCore::Engine::before_access(std::uint32_t address, unsigned bytes, bool write) {
    if (aborted || watched || missed) return false;
    const Mmu::Page& page = mmu.page(address);
    const bool allowed = page.access & (write ? arm_access::WRITE : arm_access::READ);
    const bool in_ram = allowed && page.bytes;
    if (!in_ram && miss(address)) return false;
    if (inspectors.watch && inspectors.watch->touched(address, bytes, write)) {
        if (miss(address)) return false;
        watched = true;
        cpu.jit->HaltExecution(Dynarmic::HaltReason::MemoryAbort);
        return false;
    }
    if (in_ram) return true;
    reached = true;
    if (allowed) return true;
    return refuse(address, write, true, page.status);
}

// An access to an address that is no multiple of its size: false, and it must not be done, if it
// is refused, or left to a step, which knows its instruction.
bool ArmCore::Engine::may_be_unaligned(std::uint32_t address, unsigned bytes, bool write) {
    const bool by_pair =
        bytes == 8 && address % 4 == 0 && !translated.has_doublewords();  // LDRD, STRD
    if (by_pair && !stepping && mmu.page(address).bytes) return !aborted && !watched && !missed;
    if (aborted || watched || missed || miss(address)) return false;
    reached = true;
    if (address % required.bytes == 0) return true;
    const bool strict = required.always || (cpu.cp15.value(cp15::SCTLR) & SCTLR_A);
    const Mmu::Page& page = mmu.page(address);
    if (by_bytes || (!strict && (page.normal || page.access == 0))) return true;
    refuse(address, write, true, ALIGNMENT_FAULT);
    core.fault_ = unaligned(address, write);
    return false;
}

ArmFault ArmCore::Engine::unaligned(std::uint32_t address, bool write) const {
    return {address, write, true, ALIGNMENT_FAULT, required.bytes, required.always};
}

// The address of VLD1 and its like, if :<align> asks for more than it is.
std::optional<std::uint32_t> ArmCore::Engine::unaligned_structure(std::uint32_t word) {
    const unsigned it = it_state(cpu.cpsr());
    const bool skipped = cpu.thumb() && (it & 0xF) != 0 && !condition_holds(it >> 4, cpu.cpsr());
    const std::uint32_t address = cpu.r()[word >> 16 & 0xF];
    if (!required.beyond_pieces || skipped || address % required.bytes == 0 ||
        !cpu.floating_point())
        return std::nullopt;
    return address;
}

// A page with code in it cannot be opened, although variables may lie beside the code: the host's
// byte, where the access needs nothing else.
std::uint8_t* ArmCore::Engine::beside_code(std::uint32_t address, unsigned bytes, bool write) {
    if (inspectors.watch || aborted || watched || missed || address % bytes != 0) return nullptr;
    const Mmu::Page& page = mmu.page(address);
    const std::uint32_t physical = page.physical | (address & PAGE_MASK);
    if (!page.bytes || !(page.access & (write ? arm_access::WRITE : arm_access::READ)) ||
        !code.has_code(physical >> 12) || (write && code.is_translated(physical, bytes)))
        return nullptr;
    return page.bytes + (address & PAGE_MASK);
}

template <class T>
T ArmCore::Engine::load(std::uint32_t address) {
    if (const std::uint8_t* const at = beside_code(address, sizeof(T), false)) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    if (address % sizeof(T) != 0 && !translated.is_literal(address) &&
        !may_be_unaligned(address, sizeof(T), false))
        return 0;
    const bool in_page = (address & PAGE_MASK) + sizeof(T) <= PAGE_MASK + 1;
    if (!in_page || !mmu.page(address).bytes) return load_pieces<T>(address);
    if (!before_access(address, sizeof(T), false)) return 0;
    const Mmu::Page& page = mmu.page(address);
    if (!inspectors.watch && (page.access & arm_access::WRITE) &&
        !code.has_code(page.physical >> 12))
        mmu.open(page);
    T value;
    std::memcpy(&value, page.bytes + (address & PAGE_MASK), sizeof value);
    return value;
}

// Aligned pieces of at most four bytes, the lowest address first.
template <class T>
T ArmCore::Engine::load_pieces(std::uint32_t address) {
    std::uint64_t value = 0;
    for (unsigned done = 0, bytes; done < sizeof(T); done += bytes) {
        const std::uint32_t at = address + done;
        bytes = by_bytes ? 1 : aligned_piece(at, sizeof(T) - done);
        if (!before_access(at, bytes, false)) return 0;
        const Mmu::Page& page = mmu.page(at);
        std::uint32_t piece = 0;
        if (page.bytes)
            std::memcpy(&piece, page.bytes + (at & PAGE_MASK), bytes);
        else if (!bus.read(page.physical | (at & PAGE_MASK), bytes, piece))
            refuse(at, false, false, 0);
        if (aborted) return 0;
        value |= std::uint64_t{piece} << (8 * done);
    }
    return static_cast<T>(value);
}

// What a store of up to `left` bytes does, by what lies there:
//
//   the page                 in one piece       what
//   may not be written                          NOTHING: it is refused, or left to a step
//   RAM without code         all in the page    RAM, which translated code may write from now on
//   RAM with code in it      all in the page    CODE: RAM, once what was translated is forgotten
//   on the bus, Normal       an aligned piece   MERGED with the stores around it
//   on the bus               an aligned piece   BUS
ArmCore::Engine::StorePlan ArmCore::Engine::plan_store(std::uint32_t address, unsigned left) {
    using To = StorePlan::To;
    const bool in_page = (address & PAGE_MASK) + left <= PAGE_MASK + 1;
    const Mmu::Page& page = mmu.page(address);
    if (!before_access(address, in_page ? left : 1, true)) return {To::NOTHING, 0, page};
    const unsigned piece = by_bytes ? 1 : aligned_piece(address, left);
    if (!page.bytes) return {page.normal ? To::MERGED : To::BUS, piece, page};
    return {code.has_code(page.physical >> 12) ? To::CODE : To::RAM, in_page ? left : piece, page};
}

bool ArmCore::Engine::store_on_bus(const StorePlan& plan, std::uint32_t address,
                                   std::uint32_t value) {
    const std::uint32_t on_bus = plan.page.physical | (address & PAGE_MASK);
    const bool done = plan.to == StorePlan::To::MERGED ? bus.write_normal(on_bus, plan.bytes, value)
                                                       : bus.write(on_bus, plan.bytes, value);
    if (!done) refuse(address, true, false, 0);
    if (aborted) return false;
    if (plan.page.code && code.has_code(on_bus >> 12)) translated.invalidate(address, plan.bytes);
    return true;
}

// Before bytes with code beside or in them are written.  False: that is left to a step.
bool ArmCore::Engine::forget_written_code(const StorePlan& plan, std::uint32_t address) {
    bool hit = false;
    code.written(plan.page.physical | (address & PAGE_MASK), plan.bytes,
                 [&](std::uint32_t begin, std::uint32_t size) {
                     hit = true;
                     if (stepping) translated.invalidate(begin, size);
                 });
    if (hit && miss(address)) return false;
    reached |= hit;
    return true;
}

template <class T>
void ArmCore::Engine::store(std::uint32_t address, T value) {
    if (std::uint8_t* const at = beside_code(address, sizeof(T), true)) {
        std::memcpy(at, &value, sizeof value);
        return;
    }
    if (address % sizeof(T) != 0 && !may_be_unaligned(address, sizeof(T), true)) return;
    for (unsigned done = 0, bytes; done < sizeof(T); done += bytes) {
        const std::uint32_t at = address + done;
        const StorePlan plan = plan_store(at, sizeof(T) - done);
        const auto piece = static_cast<std::uint64_t>(value) >> (8 * done);
        bytes = plan.bytes;
        switch (plan.to) {
            case StorePlan::To::NOTHING: return;
            case StorePlan::To::MERGED:
            case StorePlan::To::BUS:
                if (!store_on_bus(plan, at, static_cast<std::uint32_t>(piece))) return;
                continue;
            case StorePlan::To::CODE:
                if (!forget_written_code(plan, at)) return;
                break;
            case StorePlan::To::RAM:
                if (!inspectors.watch && (plan.page.access & arm_access::READ)) mmu.open(plan.page);
                break;
        }
        std::memcpy(plan.page.bytes + (at & PAGE_MASK), &piece, bytes);
    }
}

template <class T>
bool ArmCore::Engine::store_exclusive(std::uint32_t address, T value, T expected) {
    if (load<T>(address) != expected) return false;
    store(address, value);
    return true;
}

template std::uint8_t ArmCore::Engine::load(std::uint32_t);
template std::uint16_t ArmCore::Engine::load(std::uint32_t);
template std::uint32_t ArmCore::Engine::load(std::uint32_t);
template std::uint64_t ArmCore::Engine::load(std::uint32_t);
template void ArmCore::Engine::store(std::uint32_t, std::uint8_t);
template void ArmCore::Engine::store(std::uint32_t, std::uint16_t);
template void ArmCore::Engine::store(std::uint32_t, std::uint32_t);
template void ArmCore::Engine::store(std::uint32_t, std::uint64_t);
template bool ArmCore::Engine::store_exclusive(std::uint32_t, std::uint8_t, std::uint8_t);
template bool ArmCore::Engine::store_exclusive(std::uint32_t, std::uint16_t, std::uint16_t);
template bool ArmCore::Engine::store_exclusive(std::uint32_t, std::uint32_t, std::uint32_t);
template bool ArmCore::Engine::store_exclusive(std::uint32_t, std::uint64_t, std::uint64_t);

}  // namespace sim
