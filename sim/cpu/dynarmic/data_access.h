// data_access.h - loads and stores that the page table does not serve: pages used for the first
// time, pages with code in them, accesses across two pages, the bus, addresses without a target.
//
// Only a single step may use the bus or abort, because only then the count and all registers are
// those before the instruction.  In translated code such an access is missed: the run stops before
// its instruction, and a step does it.
//
//                  RAM   a store to code       the bus   a watchpoint   nothing, no right
//   in translated  done  missed                missed    missed         missed
//   in a step      done  done, code forgotten  done      watched        aborted
//
// What is not in one page of RAM is split into aligned pieces of at most four bytes, the lowest
// address first.  After one that is not done, those that follow do nothing, and loads return 0.
#pragma once

#include <cstdint>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/dynarmic/alignment.h"
#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/direct.h"
#include "sim/cpu/dynarmic/inspectors.h"
#include "sim/cpu/dynarmic/mmu.h"
#include "sim/cpu/dynarmic/translated_code.h"

namespace sim {

class DataAccess {
public:
    DataAccess(CpuState& cpu, Mmu& mmu, TranslatedCode& translated, const Inspectors& inspectors,
               ArmBus& bus)
        : cpu_{cpu}, mmu_{mmu}, translated_{translated}, inspectors_{inspectors}, bus_{bus} {}

    // ---- Whose accesses follow ----

    // Translated code's.
    void begin_run() { end_ = End::DONE; }
    // Of one instruction, until end_step().
    void begin_step(const Alignment& required);
    void end_step() { stepping_ = false; }
    // In steps, a byte at a time and to whatever address (ArmCore::run_by_bytes()).
    void set_by_bytes(bool by_bytes) { by_bytes_ = by_bytes; }

    // ---- Accesses: T is an unsigned type of 1, 2, 4 or 8 bytes ----

    template <class T>
    T load(std::uint32_t address);
    template <class T>
    void store(std::uint32_t address, T value);
    // False, and nothing is stored, if there is something else than `expected`; on the bus, if the
    // target does not store it exclusively.
    template <class T>
    bool store_exclusive(std::uint32_t address, T value, T expected);
    // All of a load or store, in a step; its registers are changed if it is done, else not.
    bool transfer(const SingleAccess& access);
    // Of VLD1 and its kind, before a step of it: its pieces may be aligned where the whole is not.
    // True: it is refused, with fault().
    bool refuses_structure(std::uint32_t word);
    // The present instruction aborts.
    void refuse(const ArmFault& fault);

    // ---- What has become of them since the begin ----

    bool is_done() const { return end_ == End::DONE; }
    bool is_missed() const { return end_ == End::MISSED; }
    bool is_aborted() const { return end_ == End::ABORTED; }
    bool is_watched() const { return end_ == End::WATCHED; }
    std::uint32_t missed_address() const { return missed_address_; }
    const ArmFault& fault() const { return fault_; }
    // Of the last one on the bus, as ArmCore::OnBus has it.
    unsigned cache() const { return cache_; }
    // One of the step would have been missed in translated code.
    bool has_reached() const { return reached_; }

private:
    enum class End { DONE, MISSED, ABORTED, WATCHED };
    struct StorePlan {
        enum class To { NOTHING, RAM, CODE, MERGED, BUS } to;
        unsigned bytes;
        const Mmu::Page& page;
    };

    void halt(End end);
    bool miss(std::uint32_t address);
    bool before_access(std::uint32_t address, unsigned bytes, bool write);
    bool may_be_unaligned(std::uint32_t address, unsigned bytes, bool write);
    ArmFault unaligned(std::uint32_t address, bool write) const;
    std::uint8_t* beside_code(std::uint32_t address, unsigned bytes, bool write);
    template <class T>
    T load_pieces(std::uint32_t address);
    StorePlan plan_store(std::uint32_t address, unsigned left);
    bool store_on_bus(const StorePlan& plan, std::uint32_t address, std::uint32_t value);
    bool forget_written_code(const StorePlan& plan, std::uint32_t address);

    CpuState& cpu_;
    Mmu& mmu_;
    TranslatedCode& translated_;
    const Inspectors& inspectors_;
    ArmBus& bus_;

    bool stepping_ = false, by_bytes_ = false;
    Alignment required_;  // of the instruction that a step does
    End end_ = End::DONE;
    bool reached_ = false;
    unsigned cache_ = 0;
    std::uint32_t missed_address_ = 0;
    ArmFault fault_;  // of the last that was refused
};

}  // namespace sim
