#include "sim/cpu/dynarmic/code.h"

#include <algorithm>

#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

constexpr unsigned BLANK = 64;            // zero words in a row that cannot be meant as code
constexpr unsigned FIRST_PATIENCE = 64;   // steps without a bus access until a mark is removed
constexpr std::uint32_t LITERALS = 4200;  // how far a load may be from its literal, and more

}  // namespace

std::optional<std::uint32_t> Code::instruction(std::uint32_t pc, bool thumb) const {
    const auto first = fetch_(pc);
    if (!first) return std::nullopt;
    if (thumb && thumb_bytes(*first) == 2) return *first;
    const auto second = fetch_(pc + 2);
    if (!second) return std::nullopt;
    return thumb ? std::uint32_t{*first} << 16 | *second : std::uint32_t{*second} << 16 | *first;
}

std::uint32_t Code::after(std::uint32_t pc, std::uint64_t count, bool thumb) const {
    if (!thumb) return pc + static_cast<std::uint32_t>(4 * count);
    for (; count > 0; --count) pc += thumb_bytes(fetch_(pc).value_or(0));
    return pc;
}

unsigned Code::to_next_branch(std::uint32_t pc, bool thumb) {
    const Straight& known = straight_[pc / 2 % straight_.size()];
    if (known.count != 0 && known.pc == pc && known.thumb == thumb) return known.count;
    if (pc >= far_begin_ && pc < far_end_) return FAR;
    unsigned count = 1;
    std::uint32_t at = pc;
    for (; count < FAR; ++count) {
        const auto word = instruction(at, thumb);
        if (!word || is_branch(*word, thumb)) break;
        at += thumb && *word <= 0xFFFF ? 2 : 4;
    }
    if (count == FAR) {
        far_begin_ = pc;
        far_end_ = pc + (at - pc) / 2;  // so the second half is scanned again
    }
    // Also for those after it, which are stepped next.
    std::uint32_t next = pc;
    for (unsigned i = 0; i < std::min<std::size_t>(count, straight_.size() / 2); ++i) {
        straight_[next / 2 % straight_.size()] = {next, thumb, count == FAR ? FAR : count - i};
        if (count == FAR) break;
        next = after(next, 1, thumb);
    }
    return count;
}

unsigned Code::to_next_branch_now(std::uint32_t pc, bool thumb) {
    straight_[pc / 2 % straight_.size()] = {};
    return to_next_branch(pc, thumb);
}

bool Code::is_spin(std::uint32_t pc, bool thumb) const {
    const std::uint32_t word = instruction(pc, thumb).value_or(0);
    return thumb ? word == 0xE7FE || word == 0xF7FFBFFE : word == 0xEAFFFFFE;
}

bool Code::is_blank(std::uint32_t pc, bool thumb) const {
    const unsigned halves = thumb ? BLANK : 2 * BLANK;
    for (unsigned i = 0; i < halves; ++i)
        if (fetch_(pc + 2 * i).value_or(1) != 0) return false;
    return true;
}

void Code::mark(std::uint32_t pc, bool direct) {
    const auto before = patience_.find(pc);
    marks_[pc] = {0, before == patience_.end() ? FIRST_PATIENCE : before->second, direct};
}

bool Code::settle(std::uint32_t pc, bool reached) {
    const auto mark = marks_.find(pc);
    if (mark == marks_.end()) return false;
    if (reached) {
        mark->second.quiet = 0;
        return false;
    }
    if (++mark->second.quiet < mark->second.patience) return false;
    patience_[pc] = std::min(mark->second.patience * 4, 1u << 20);
    marks_.erase(mark);
    return true;
}

std::optional<std::uint32_t> Code::translated(std::uint32_t begin, std::uint32_t pc,
                                              std::uint32_t end) {
    blocks_[begin] = end;
    const auto inside = blocks_.upper_bound(pc);
    if (inside == blocks_.end() || inside->first - pc >= end - pc) return std::nullopt;
    const std::uint32_t other = inside->first;
    blocks_.erase(inside);
    return other;
}

bool Code::split(std::uint32_t pc) {
    auto block = blocks_.lower_bound(pc);
    if (block == blocks_.begin()) return false;
    --block;
    if (block->second <= pc) return false;
    block->second = pc;
    return true;
}

void Code::set_it(std::uint32_t pc, unsigned it) {
    if (it != 0)
        it_[pc] = it;
    else if (!it_.empty())
        it_.erase(pc);
}

unsigned Code::it(std::uint32_t pc) const {
    const auto found = it_.find(pc);
    return found == it_.end() ? 0 : found->second;
}

unsigned Code::done_before(std::uint32_t pc, bool thumb) const {
    auto block = blocks_.upper_bound(pc);
    if (block == blocks_.begin()) return 0;
    --block;
    if (pc >= block->second) return 0;
    if (!thumb) return (pc - block->first) / 4;
    unsigned done = 0;
    for (std::uint32_t at = block->first; at < pc; ++done) at = after(at, 1, true);
    return done;
}

Code::Page& Code::use(std::uint32_t page, std::uint32_t physical) {
    const auto found = pages_.find(page);
    if (found != pages_.end() && found->second.physical == physical) return found->second;
    auto& pages = pages_of_[physical];
    if (std::find(pages.begin(), pages.end(), page) == pages.end()) pages.push_back(page);
    return pages_[page] = {physical, {}};
}

void Code::translated_word(std::uint32_t page, std::uint32_t physical, std::uint32_t word) {
    use(page, physical).words[word] = true;
    words_[physical][word] = true;
    asked_ = ~0u;
}

void Code::written(std::uint32_t physical_address, std::uint32_t bytes,
                   const std::function<void(std::uint32_t, std::uint32_t)>& invalidate) {
    while (bytes > 0) {
        const std::uint32_t offset = physical_address & 0xFFF;
        const std::uint32_t now = std::min(bytes, 0x1000 - offset);
        const std::uint32_t last_word = (offset + now - 1) / 4;
        const Words* const words = words_of(physical_address >> 12);
        bool any = false;
        for (std::uint32_t word = offset / 4; words && !any && word <= last_word; ++word)
            any = (*words)[word];
        const auto pages = any ? pages_of_.find(physical_address >> 12) : pages_of_.end();
        if (pages != pages_of_.end()) {
            for (const std::uint32_t page : pages->second) {
                const Words& here = pages_[page].words;
                bool used = false;
                for (std::uint32_t word = offset / 4; word <= last_word; ++word) used |= here[word];
                if (!used) continue;
                straight_.fill({});
                far_end_ = 0;
                const std::uint32_t address = page << 12 | offset;
                for (auto mark = marks_.begin(); mark != marks_.end();)
                    mark = mark->first + 4 - address < now + 4 ? marks_.erase(mark) : ++mark;
                const std::uint32_t begin = address - std::min(address, LITERALS);
                const std::uint32_t last = address + (now - 1);
                const std::uint32_t after = std::min(~last, LITERALS);  // to the last address
                invalidate(begin, last - begin + 1 + after);
            }
        }
        physical_address += now;
        bytes -= now;
    }
}

void Code::forget() {
    straight_.fill({});
    far_end_ = 0;
    it_.clear();
    blocks_.clear();
    pages_.clear();
    pages_of_.clear();
    words_.clear();
    asked_ = ~0u;
}

}  // namespace sim
