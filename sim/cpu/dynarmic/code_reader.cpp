#include "sim/cpu/dynarmic/code_reader.h"

#include <algorithm>
#include <cstring>

#include "sim/cpu/dynarmic/alignment.h"
#include "sim/cpu/dynarmic/direct.h"
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

void CodeReader::begin_run(unsigned left_over) {
    stepping_ = false;
    left_over_ = left_over;
    no_room_ = false;
    block_ = {};
}

void CodeReader::begin_step() {
    stepping_ = true;
    no_room_ = false;
    block_ = {};
}

std::optional<std::uint32_t> CodeReader::word(std::uint32_t address) {
    const bool second_half = block_.begin == cpu_.r()[15] && block_.thumb && (block_.next & 2) &&
                             address == (block_.next & ~3u) + 4;
    bool call = false;
    if (!second_half) {
        if (!begin_instruction(address)) return std::nullopt;
        if (!stepping_ && becomes_link()) {
            block_.linked = true;
            if (!block_.thumb) return ARM_LINK;
            return block_.next & 2 ? THUMB_LINK << 16 : THUMB_LINK;
        }
        if (!stepping_ && translated_.code.is_marked(block_.next)) {
            call = becomes_call();
            if (!call) return std::nullopt;
        }
    }
    if (mmu_.is_forbidden(second_half ? address : block_.next)) return std::nullopt;
    const auto word = program_word(address);
    if (!word) return std::nullopt;
    if (call)
        return block_.thumb ? with_half(*word, THUMB_CALL | block_.instructions)
                            : (*word & 0xF0000000) | ARM_CALL | block_.instructions;
    const auto whole = translated_.code.instruction(block_.next, block_.thumb);
    if (!whole) return word;
    const auto instead = replaced(*whole);
    if (!instead) return std::nullopt;
    if (*instead == *whole) return word;
    if (!block_.thumb) return instead;
    if (*instead <= 0xFFFF) return with_half(*word, *instead);
    if (second_half) return (*word & 0xFFFF0000) | (*instead & 0xFFFF);
    return block_.next & 2 ? with_half(*word, *instead >> 16) : *instead >> 16 | *instead << 16;
}

// The next one of the block, or the first of another.  False: it is not to be translated.
bool CodeReader::begin_instruction(std::uint32_t address) {
    Code& code = translated_.code;
    const std::uint32_t begin = cpu_.r()[15];
    const bool first = block_.begin != begin || address != (block_.next & ~3u);
    if (first) {
        block_ = {begin, begin, cpu_.thumb(), 0, it_state(cpu_.cpsr()), false};
        translated_.add_block(begin);
    }
    const std::uint32_t pc = block_.next;
    if (block_.thumb) code.set_it(pc, block_.it);
    if (stepping_) return true;
    if (inspectors_.is_probed(pc)) return false;
    if (!first) return true;
    const unsigned straight = code.to_next_branch_now(pc, block_.thumb);
    if (straight > left_over_) {
        if (straight < Code::FAR) longest_ = std::max(longest_, straight);
        no_room_ = true;
        return false;
    }
    if (code.split(pc)) translated_.invalidate(pc);
    return true;
}

// The block ends before its next instruction.
bool CodeReader::becomes_link() {
    if (block_.instructions == 0 || block_.it != 0) return false;
    const auto ends_function = [&] {
        ArmTally* const tally = inspectors_.tally;
        return tally && !tally->same_function(block_.begin, block_.next);
    };
    Code& code = translated_.code;
    const bool enough = block_.instructions >= LONGEST_BLOCK;
    return (enough || code.is_begin(block_.next) || ends_function()) &&
           (code.is_direct(block_.next) || !code.is_marked(block_.next));
}

// The next instruction, which is marked, becomes a supervisor call.
bool CodeReader::becomes_call() {
    Code& code = translated_.code;
    // A mark may be of another instruction, which was there before.
    if (code.is_direct(block_.next) && !is_single_access()) code.mark(block_.next, false);
    return !inspectors_.watch && code.is_direct(block_.next) &&
           block_.instructions <= (block_.thumb ? MOST_THUMB : MOST_ARM);
}

bool CodeReader::is_single_access() const {
    const auto word = translated_.code.instruction(block_.next, block_.thumb);
    return word && block_.it == 0 &&
           single_access(*word, block_.thumb, block_.next, cpu_.r().data(), false);
}

std::optional<std::uint32_t> CodeReader::program_word(std::uint32_t address) {
    const Mmu::Page& page = mmu_.page(address);
    if (!page.may_execute()) return std::nullopt;
    translated_.add_word(address, page);
    std::uint32_t word;
    std::memcpy(&word, page.code + (address & 0xFFC), sizeof word);
    return word;
}

// What dynarmic reads instead of the next instruction, which has the same length, because it may be
// skipped by its condition.  Nothing: a step must do it.
std::optional<std::uint32_t> CodeReader::replaced(std::uint32_t whole) {
    if (is_system(whole, block_.thumb, cpu_.floating_point())) {
        if (!block_.thumb) return ARM_UNDEFINED;
        return whole <= 0xFFFF ? THUMB_UNDEFINED
                               : THUMB_UNDEFINED_FIRST << 16 | THUMB_UNDEFINED_SECOND;
    }
    if (block_.thumb && whole <= 0xFFFF) return whole;
    const bool big_endian = cpu_.cpsr() & arm_cpsr::E;
    const std::uint32_t instead = big_endian ? whole : as_doublewords(whole, block_.thumb);
    const Alignment needed = alignment(instead, block_.thumb);
    if (needed.bytes == 8) translated_.add_doublewords();
    if (!stepping_ && needed.beyond_pieces) {
        translated_.code.mark(block_.next, false);
        return std::nullopt;
    }
    return instead;
}

// `word`, but the next instruction's halfword in it is `half`.
std::uint32_t CodeReader::with_half(std::uint32_t word, std::uint32_t half) const {
    return block_.next & 2 ? (word & 0xFFFF) | half << 16 : (word & 0xFFFF0000) | half;
}

std::uint64_t CodeReader::ticks(bool thumb, std::uint32_t pc, std::uint32_t word) {
    const ArmTally* const tally = inspectors_.tally;
    if (block_.linked) return tally && !tally->same_function(block_.begin, pc) ? JUMP : 0;
    block_.next = pc + (thumb && word <= 0xFFFF ? 2 : 4);
    ++block_.instructions;
    block_.it = thumb && is_it(word) ? word & 0xFF : next_it(block_.it);
    if (stepping_) return 1;
    if (const auto other = translated_.code.translated(block_.begin, pc, block_.next))
        translated_.invalidate(*other);
    return tally ? 1 + ticks_of_departure(thumb, pc, word) : 1;
}

std::uint64_t CodeReader::ticks_of_departure(bool thumb, std::uint32_t pc,
                                             std::uint32_t word) const {
    const auto to = departure(word, thumb, pc);
    if (!to) return 0;
    if (to->call) return CALL;
    const ArmTally& tally = *inspectors_.tally;
    const bool stays =
        to->target && tally.same_function(pc, *to->target) && tally.same_function(pc, block_.next);
    return stays ? 0 : JUMP;
}

bool CodeReader::is_constant(std::uint32_t address) {
    const Mmu::Page& page = mmu_.page(address);
    if (inspectors_.watch || address % 4 != 0 || !page.bytes || !(page.access & arm_access::READ) ||
        !translated_.code.has_code(page.physical >> 12) || (address & 0xFFF) > 0xFF8 ||
        !mmu_.user_may(address, arm_access::READ))
        return false;
    translated_.add_literal(address);
    return true;
}

}  // namespace sim
