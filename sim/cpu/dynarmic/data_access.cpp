#include "sim/cpu/dynarmic/data_access.h"

#include <cstring>

#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

constexpr std::uint32_t PAGE_MASK = 0xFFF;

// Bytes of the largest aligned piece there, of at most four.
unsigned aligned_piece(std::uint32_t address, unsigned left) {
    return left >= 4 && address % 4 == 0 ? 4 : left >= 2 && address % 2 == 0 ? 2 : 1;
}

}  // namespace

void DataAccess::begin_step(const Alignment& required) {
    stepping_ = true;
    required_ = required;
    end_ = End::DONE;
    reached_ = false;
}

void DataAccess::halt(End end) {
    end_ = end;
    cpu_.jit->HaltExecution(Dynarmic::HaltReason::MemoryAbort);
}

// Translated code stops before the present instruction; a step does it then.
bool DataAccess::miss(std::uint32_t address) {
    if (stepping_) return false;
    missed_address_ = address;
    halt(End::MISSED);
    return true;
}

void DataAccess::refuse(const ArmFault& fault) {
    fault_ = fault;
    halt(End::ABORTED);
}

// False: the access must not be done.
bool DataAccess::before_access(std::uint32_t address, unsigned bytes, bool write) {
    if (!is_done()) return false;
    const Mmu::Page& page = mmu_.page(address);
    const bool allowed = page.access & (write ? arm_access::WRITE : arm_access::READ);
    const bool in_ram = allowed && page.bytes;
    if (!in_ram && miss(address)) return false;
    if (inspectors_.watch && inspectors_.watch->touched(address, bytes, write)) {
        if (miss(address)) return false;
        halt(End::WATCHED);
        return false;
    }
    if (in_ram) return true;
    reached_ = true;
    if (allowed) return true;
    refuse({address, write, true, page.status});
    return false;
}

// An access to an address that is no multiple of its size: false, and it must not be done, if it
// is refused, or left to a step, which knows its instruction.
bool DataAccess::may_be_unaligned(std::uint32_t address, unsigned bytes, bool write) {
    // LDRD and STRD
    const bool by_pair = bytes == 8 && address % 4 == 0 && !translated_.has_doublewords();
    if (by_pair && !stepping_ && mmu_.page(address).bytes) return is_done();
    if (!is_done() || miss(address)) return false;
    reached_ = true;
    if (address % required_.bytes == 0) return true;
    const bool strict = required_.always || (cpu_.cp15.value(cp15::SCTLR) & SCTLR_A);
    const Mmu::Page& page = mmu_.page(address);
    if (by_bytes_ || (!strict && (page.normal || page.access == 0))) return true;
    refuse(unaligned(address, write));
    return false;
}

ArmFault DataAccess::unaligned(std::uint32_t address, bool write) const {
    return {address, write, true, ALIGNMENT_FAULT, required_.bytes, required_.always};
}

bool DataAccess::refuses_structure(std::uint32_t word) {
    if (!required_.beyond_pieces) return false;
    const unsigned it = it_state(cpu_.cpsr());
    const bool skipped = cpu_.thumb() && (it & 0xF) != 0 && !condition_holds(it >> 4, cpu_.cpsr());
    const std::uint32_t address = cpu_.r()[word >> 16 & 0xF];
    if (skipped || address % required_.bytes == 0 || !cpu_.floating_point()) return false;
    fault_ = unaligned(address, !(word >> 21 & 1));
    end_ = End::ABORTED;
    return true;
}

// A page with code in it cannot be opened, although variables may lie beside the code: the host's
// byte, where the access needs nothing else.
std::uint8_t* DataAccess::beside_code(std::uint32_t address, unsigned bytes, bool write) {
    if (inspectors_.watch || !is_done() || address % bytes != 0) return nullptr;
    const Mmu::Page& page = mmu_.page(address);
    const std::uint32_t physical = page.physical | (address & PAGE_MASK);
    if (!page.bytes || !(page.access & (write ? arm_access::WRITE : arm_access::READ)) ||
        !translated_.code.has_code(physical >> 12) ||
        (write && translated_.code.is_translated(physical, bytes)))
        return nullptr;
    return page.bytes + (address & PAGE_MASK);
}

template <class T>
T DataAccess::load(std::uint32_t address) {
    if (const std::uint8_t* const at = beside_code(address, sizeof(T), false)) {
        T value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
    if (address % sizeof(T) != 0 && !translated_.is_literal(address) &&
        !may_be_unaligned(address, sizeof(T), false))
        return 0;
    const bool in_page = (address & PAGE_MASK) + sizeof(T) <= PAGE_MASK + 1;
    if (!in_page || !mmu_.page(address).bytes) return load_pieces<T>(address);
    if (!before_access(address, sizeof(T), false)) return 0;
    const Mmu::Page& page = mmu_.page(address);
    if (!inspectors_.watch && (page.access & arm_access::WRITE) &&
        !translated_.code.has_code(page.physical >> 12))
        mmu_.open(page);
    T value;
    std::memcpy(&value, page.bytes + (address & PAGE_MASK), sizeof value);
    return value;
}

// Aligned pieces of at most four bytes, the lowest address first.
template <class T>
T DataAccess::load_pieces(std::uint32_t address) {
    std::uint64_t value = 0;
    for (unsigned done = 0, bytes; done < sizeof(T); done += bytes) {
        const std::uint32_t at = address + done;
        bytes = by_bytes_ ? 1 : aligned_piece(at, sizeof(T) - done);
        if (!before_access(at, bytes, false)) return 0;
        const Mmu::Page& page = mmu_.page(at);
        std::uint32_t piece = 0;
        cache_ = page.cache;
        if (page.bytes)
            std::memcpy(&piece, page.bytes + (at & PAGE_MASK), bytes);
        else if (!bus_.read(page.physical | (at & PAGE_MASK), bytes, piece))
            refuse({at, false, false, 0});
        if (is_aborted()) return 0;
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
DataAccess::StorePlan DataAccess::plan_store(std::uint32_t address, unsigned left) {
    using To = StorePlan::To;
    const bool in_page = (address & PAGE_MASK) + left <= PAGE_MASK + 1;
    const Mmu::Page& page = mmu_.page(address);
    if (!before_access(address, in_page ? left : 1, true)) return {To::NOTHING, 0, page};
    const unsigned piece = by_bytes_ ? 1 : aligned_piece(address, left);
    if (!page.bytes) return {page.normal ? To::MERGED : To::BUS, piece, page};
    return {translated_.code.has_code(page.physical >> 12) ? To::CODE : To::RAM,
            in_page ? left : piece, page};
}

bool DataAccess::store_on_bus(const StorePlan& plan, std::uint32_t address, std::uint32_t value) {
    const std::uint32_t on_bus = plan.page.physical | (address & PAGE_MASK);
    cache_ = plan.page.cache;
    const bool done = plan.to == StorePlan::To::MERGED
                          ? bus_.write_normal(on_bus, plan.bytes, value)
                          : bus_.write(on_bus, plan.bytes, value);
    if (!done) refuse({address, true, false, 0});
    if (is_aborted()) return false;
    if (plan.page.code && translated_.code.has_code(on_bus >> 12))
        translated_.invalidate(address, plan.bytes);
    return true;
}

// Before bytes with code beside or in them are written.  False: that is left to a step.
bool DataAccess::forget_written_code(const StorePlan& plan, std::uint32_t address) {
    bool hit = false;
    translated_.code.written(plan.page.physical | (address & PAGE_MASK), plan.bytes,
                             [&](std::uint32_t begin, std::uint32_t size) {
                                 hit = true;
                                 if (stepping_) translated_.invalidate(begin, size);
                             });
    if (hit && miss(address)) return false;
    reached_ |= hit;
    return true;
}

template <class T>
void DataAccess::store(std::uint32_t address, T value) {
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
                if (!inspectors_.watch && (plan.page.access & arm_access::READ))
                    mmu_.open(plan.page);
                break;
        }
        std::memcpy(plan.page.bytes + (at & PAGE_MASK), &piece, bytes);
    }
}

template <class T>
bool DataAccess::store_exclusive(std::uint32_t address, T value, T expected) {
    const bool on_bus = !mmu_.page(address).bytes;
    if (!on_bus && load<T>(address) != expected) return false;
    store(address, value);
    return !on_bus || !is_done() || bus_.exclusive_stored();
}

bool DataAccess::transfer(const SingleAccess& access) {
    std::uint32_t value = cpu_.r()[access.target];
    switch (access.bytes) {
        case 1:
            if (access.load)
                value = load<std::uint8_t>(access.address);
            else
                store(access.address, static_cast<std::uint8_t>(value));
            if (access.is_signed)
                value = static_cast<std::uint32_t>(static_cast<std::int8_t>(value));
            break;
        case 2:
            if (access.load)
                value = cpu_.in_order(load<std::uint16_t>(access.address));
            else
                store(access.address, cpu_.in_order(static_cast<std::uint16_t>(value)));
            if (access.is_signed)
                value = static_cast<std::uint32_t>(static_cast<std::int16_t>(value));
            break;
        default:
            if (access.load)
                value = cpu_.in_order(load<std::uint32_t>(access.address));
            else
                store(access.address, cpu_.in_order(value));
    }
    if (!is_done()) return false;
    if (access.write_back) cpu_.r()[access.base] = access.new_base;
    if (access.load) cpu_.r()[access.target] = value;
    return true;
}

template std::uint8_t DataAccess::load(std::uint32_t);
template std::uint16_t DataAccess::load(std::uint32_t);
template std::uint32_t DataAccess::load(std::uint32_t);
template std::uint64_t DataAccess::load(std::uint32_t);
template void DataAccess::store(std::uint32_t, std::uint8_t);
template void DataAccess::store(std::uint32_t, std::uint16_t);
template void DataAccess::store(std::uint32_t, std::uint32_t);
template void DataAccess::store(std::uint32_t, std::uint64_t);
template bool DataAccess::store_exclusive(std::uint32_t, std::uint8_t, std::uint8_t);
template bool DataAccess::store_exclusive(std::uint32_t, std::uint16_t, std::uint16_t);
template bool DataAccess::store_exclusive(std::uint32_t, std::uint32_t, std::uint32_t);
template bool DataAccess::store_exclusive(std::uint32_t, std::uint64_t, std::uint64_t);

}  // namespace sim
