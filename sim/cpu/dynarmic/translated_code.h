// translated_code.h - what dynarmic has translated, and when it is dropped.
//
// What is running is dropped when dynarmic leaves it, which it then does soon.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "sim/cpu/dynarmic/code.h"
#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/mmu.h"

namespace sim {

class TranslatedCode {
public:
    TranslatedCode(CpuState& cpu, Mmu& mmu)
        : code{[&mmu](std::uint32_t address) { return mmu.half_of_code(address); }},
          cpu_{cpu},
          mmu_{mmu} {}

    Code code;

    // ---- Dropping ----

    // Blocks with a byte at these virtual addresses; of 2: with the instruction there.
    void invalidate(std::uint32_t address, std::uint32_t bytes = 2) {
        cpu_.jit->InvalidateCacheRange(address, bytes);
    }
    // What was translated from these physical addresses, whose contents change.
    void written(std::uint32_t address, std::uint32_t bytes);
    // What the user mode may not execute; called before the program can reach it in that mode.
    void forget_privileged();
    // All, because what the addresses mean has changed, or what instructions are allowed.
    void forget_mappings();
    // All, if there is too much; to be called between runs.
    void forget_if_overfull() {
        if (overfull_) forget_blocks();
    }

    // ---- Translating ----

    // A block from `pc` on.
    void add_block(std::uint32_t pc);
    // The word at `address`, of instructions, on this page.
    void add_word(std::uint32_t address, const Mmu::Page& page);
    // A load from an address that is known, whose word there becomes a constant.
    void add_literal(std::uint32_t address);
    // dynarmic reads a literal in the same way as the program does, and only then is it known to be
    // of 64 bits.  A program that has a variable after a literal of 32 bits may write it often.
    void read_64(std::uint32_t address) {
        if (address == literal_) note_literal(address + 4);
    }
    // The present read is dynarmic's, of a literal, and not the program's.  Not twice.
    bool is_literal(std::uint32_t address) {
        return std::exchange(reads_literal_, false) && address == literal_;
    }
    // An instruction whose address must be a multiple of 8.
    void add_doublewords() { has_doublewords_ = true; }
    bool has_doublewords() const { return has_doublewords_; }

private:
    void forget_blocks();
    void note_literal(std::uint32_t address);

    CpuState& cpu_;
    Mmu& mmu_;
    std::unordered_map<std::uint32_t, unsigned> translations_;  // so far, by pages of 4 KB
    bool overfull_ = false;                                     // a page of them
    std::unordered_set<std::uint32_t> privileged_;  // virtual numbers of pages with such code
    std::uint32_t literal_ = 1;                     // that dynarmic has asked for last
    bool reads_literal_ = false;                    // next, while it translates
    bool has_doublewords_ = false;
};

}  // namespace sim
