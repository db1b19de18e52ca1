// fetch.cpp - the code that dynarmic reads for translation: from where, how far, and what is
// replaced.
#include <algorithm>
#include <cstring>

#include "sim/cpu/dynarmic/direct.h"
#include "sim/cpu/dynarmic/engine.h"
#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

constexpr std::uint32_t ARM_UNDEFINED = 0xE7F000F0;  // UDF #0
constexpr std::uint32_t THUMB_UNDEFINED = 0xDE00;
constexpr std::uint32_t THUMB_UNDEFINED_FIRST = 0xF7F0, THUMB_UNDEFINED_SECOND = 0xA000;
constexpr std::uint32_t ARM_LINK = 0xEAFFFFFE, THUMB_LINK = 0xE7FE;  // B to itself
// Instructions per block.  For each conditional one dynarmic scans all before it in the block.
constexpr unsigned LONGEST_BLOCK = 64;
constexpr std::uint32_t ARM_CALL = 0x0F000000, MOST_ARM = 0xFFFFFF;  // SVC #n, the largest n
constexpr std::uint32_t THUMB_CALL = 0xDF00, MOST_THUMB = 0xFF;

}  // namespace

bool ArmCore::Engine::is_single_access(std::uint32_t pc) {
    const auto word = code.instruction(pc, block.thumb);
    return word && block.it == 0 && single_access(*word, block.thumb, pc, cpu.r().data(), false);
}

// Dynarmic reads a block's words from its begin on (a Thumb instruction of 32 bits may lie in two
// words), and calls GetTicksForCode for each instruction.  A result without a value ends the block
// before that instruction and raises NoExecuteFault there.
//
// A single load or store that accesses the bus is replaced by a supervisor call, whose number is
// that of the block's instructions before it.  done_directly() in core.cpp then does the access.
//
// Blocks do not overlap, so each instruction belongs to one known block.  Where another block
// begins, this one ends with a branch to it, which is not counted.
std::optional<std::uint32_t> ArmCore::Engine::MemoryReadCode(std::uint32_t address) {
    const std::uint32_t begin = cpu.r()[15];
    const bool second_half = block.begin == begin && block.thumb && (block.next & 2) &&
                             address == (block.next & ~3u) + 4;
    if (!second_half) {
        const bool first = block.begin != begin || address != (block.next & ~3u);
        if (first) {
            block = {begin, begin, cpu.thumb(), 0, it_state(cpu.cpsr()), false};
            translated.add_block(begin);
        }
        const std::uint32_t pc = block.next;
        if (block.thumb) code.set_it(pc, block.it);
        if (!stepping) {
            if (inspectors.is_probed(pc)) return std::nullopt;
            if (first) {
                const unsigned straight = code.to_next_branch_now(pc, block.thumb);
                if (straight > left_over) {
                    if (straight < Code::FAR) longest = std::max(longest, straight);
                    retranslate = true;
                    return std::nullopt;
                }
                if (code.split(pc)) translated.invalidate(pc);
            }
        }
    }
    const bool inside = block.instructions > 0 && block.it == 0 && !second_half && !stepping;
    const auto ends_function = [&] {
        return inspectors.tally && !inspectors.tally->same_function(block.begin, block.next);
    };
    const bool enough = block.instructions >= LONGEST_BLOCK;
    if (inside && (enough || code.is_begin(block.next) || ends_function()) &&
        (code.is_direct(block.next) || !code.is_marked(block.next))) {
        block.linked = true;
        if (!block.thumb) return ARM_LINK;
        return block.next & 2 ? THUMB_LINK << 16 : THUMB_LINK;
    }
    bool call = false;
    if (!second_half && !stepping && code.is_marked(block.next)) {
        // A mark may be of another instruction, which was there before.
        if (code.is_direct(block.next) && !is_single_access(block.next))
            code.mark(block.next, false);
        call = !inspectors.watch && code.is_direct(block.next) &&
               block.instructions <= (block.thumb ? MOST_THUMB : MOST_ARM);
        if (!call) return std::nullopt;
    }
    if (mmu.is_forbidden(second_half ? address : block.next)) return std::nullopt;
    const Mmu::Page& page = mmu.page(address);
    if (!page.may_execute()) return std::nullopt;
    translated.add_word(address, page);
    std::uint32_t word;
    std::memcpy(&word, page.code + (address & 0xFFC), sizeof word);

    const auto half_as = [&](std::uint32_t half) {
        return block.next & 2 ? (word & 0xFFFF) | half << 16 : (word & 0xFFFF0000) | half;
    };
    if (call)
        return block.thumb ? half_as(THUMB_CALL | block.instructions)
                           : (word & 0xF0000000) | ARM_CALL | block.instructions;
    const auto whole = code.instruction(block.next, block.thumb);
    if (!whole) return word;
    std::uint32_t instead = *whole;
    if (is_system(*whole, block.thumb, cpu.floating_point())) {
        // UDF of the same length, because the instruction may be skipped by its condition.
        instead = !block.thumb       ? ARM_UNDEFINED
                  : *whole <= 0xFFFF ? THUMB_UNDEFINED
                                     : THUMB_UNDEFINED_FIRST << 16 | THUMB_UNDEFINED_SECOND;
    } else if (*whole > 0xFFFF || !block.thumb) {
        if (!(cpu.cpsr() & arm_cpsr::E)) instead = as_doublewords(*whole, block.thumb);
        const Alignment needed = alignment(instead, block.thumb);
        if (needed.bytes == 8) translated.add_doublewords();
        if (!stepping && needed.beyond_pieces) {
            code.mark(block.next, false);
            return std::nullopt;
        }
    }
    if (instead == *whole) return word;
    if (!block.thumb) return instead;
    if (instead <= 0xFFFF) return half_as(instead);
    if (second_half) return (word & 0xFFFF0000) | (instead & 0xFFFF);
    return block.next & 2 ? half_as(instead >> 16) : instead >> 16 | instead << 16;
}

std::uint64_t ArmCore::Engine::GetTicksForCode(bool is_thumb, std::uint32_t pc,
                                               std::uint32_t word) {
    if (block.linked)
        return inspectors.tally && !inspectors.tally->same_function(block.begin, pc) ? JUMP : 0;
    block.next = pc + (is_thumb && word <= 0xFFFF ? 2 : 4);
    ++block.instructions;
    block.it = is_thumb && is_it(word) ? word & 0xFF : next_it(block.it);
    if (stepping) return 1;
    if (const auto other = code.translated(block.begin, pc, block.next))
        translated.invalidate(*other);
    return inspectors.tally ? 1 + ticks_of_departure(is_thumb, pc, word) : 1;
}

std::uint64_t ArmCore::Engine::ticks_of_departure(bool is_thumb, std::uint32_t pc,
                                                  std::uint32_t word) const {
    const auto to = departure(word, is_thumb, pc);
    if (!to) return 0;
    if (to->call) return CALL;
    const bool stays = to->target && inspectors.tally->same_function(pc, *to->target) &&
                       inspectors.tally->same_function(pc, block.next);
    return stays ? 0 : JUMP;
}

// A load from an address that is known at translation, that is a literal in the code, becomes a
// constant.
bool ArmCore::Engine::IsReadOnlyMemory(std::uint32_t address) {
    const Mmu::Page& page = mmu.page(address);
    if (inspectors.watch || address % 4 != 0 || !page.bytes || !(page.access & arm_access::READ) ||
        !code.has_code(page.physical >> 12) || (address & 0xFFF) > 0xFF8 ||
        !mmu.user_may(address, arm_access::READ))
        return false;
    translated.add_literal(address);
    return true;
}

std::uint64_t ArmCore::Engine::MemoryRead64(std::uint32_t address) {
    translated.read_64(address);
    return data.load<std::uint64_t>(address);
}

}  // namespace sim
