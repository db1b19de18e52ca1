// code.h - what is known of the program's instructions: where translated code has to stop, how long
// it runs without checking its count, and which words have been translated.
//
// Translated code subtracts a basic block's instructions at the block's end, and checks the rest at
// each branch.  So it can overrun by `longest`, the longest run of instructions without a branch.
// run() therefore stops that many instructions early, and does the last ones in smaller pieces.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace sim {

class Code {
public:
    // The 16 bits at an address of code; nothing where none can be read.
    using Fetch = std::function<std::optional<std::uint16_t>(std::uint32_t)>;
    explicit Code(Fetch fetch) : fetch_{std::move(fetch)} {}

    // ---- Instructions in memory ----

    std::optional<std::uint32_t> instruction(std::uint32_t pc, bool thumb) const;
    // The address after `count` instructions from `pc` on.
    std::uint32_t after(std::uint32_t pc, std::uint64_t count, bool thumb) const;

    // Instructions from `pc` to the next branch, including it; FAR if it is farther away.
    static constexpr unsigned FAR = 16384;
    // Answers are cached; a write to words that are not translated yet does not invalidate them.
    unsigned to_next_branch(std::uint32_t pc, bool thumb);
    unsigned to_next_branch_now(std::uint32_t pc, bool thumb);
    // A branch to itself, without a condition if no IT block makes one.
    bool is_spin(std::uint32_t pc, bool thumb) const;
    // Nothing but zeros follows, for at least 64 instructions.
    bool is_blank(std::uint32_t pc, bool thumb) const;

    // ---- Where translated code stops, to be executed one by one ----

    // The instruction at `pc` accesses what translated code must not access by itself (the bus, a
    // page that refuses, words that are code).  `direct`: it needs no single step (direct.h).
    void mark(std::uint32_t pc, bool direct);
    bool is_marked(std::uint32_t pc) const {
        return !marks_.empty() && marks_.find(pc) != marks_.end();
    }
    bool is_direct(std::uint32_t pc) const {
        const auto mark = marks_.find(pc);
        return mark != marks_.end() && mark->second.direct;
    }
    // It was executed, and `reached` says whether it made such an access.  True: it has made none
    // for long, and is unmarked.
    bool settle(std::uint32_t pc, bool reached);

    // ---- Blocks and words that have been translated ----

    // The instruction at `pc`, of the block from `begin` on, which is read up to `end` now.
    // Returns the begin of another block that decodes these words differently (as Thumb instead of
    // ARM, or from the second half of this instruction on); that block is forgotten.
    std::optional<std::uint32_t> translated(std::uint32_t begin, std::uint32_t pc,
                                            std::uint32_t end);
    bool is_begin(std::uint32_t pc) const { return blocks_.count(pc) != 0; }
    // Lets the block around `pc` end there; false if there is none.
    bool split(std::uint32_t pc);
    // The state of the IT block (CPSR's IT[7:0]) in which the instruction at `pc` was translated.
    void set_it(std::uint32_t pc, unsigned it);
    unsigned it(std::uint32_t pc) const;
    // Instructions of the block around `pc` that are done before it.
    unsigned done_before(std::uint32_t pc, bool thumb) const;

    struct Page {
        std::uint32_t physical;   // number
        std::bitset<1024> words;  // those that have been translated
    };
    // `page` and `physical` are page numbers.
    bool has_code(std::uint32_t physical) const { return words_of(physical) != nullptr; }
    // Whether one of these bytes, of one page, has been.
    bool is_translated(std::uint32_t physical_address, unsigned bytes) const {
        const Words* const words = words_of(physical_address >> 12);
        const std::uint32_t first = physical_address % 4096 / 4;
        return words && ((*words)[first] || (bytes > 4 && (*words)[first + 1]));
    }
    // Notes that the word at this address of the physical page has been translated.
    void translated_word(std::uint32_t page, std::uint32_t physical, std::uint32_t word);
    // Calls `invalidate(virtual address, bytes)` for what was translated from these words.
    void written(std::uint32_t physical_address, std::uint32_t bytes,
                 const std::function<void(std::uint32_t, std::uint32_t)>& invalidate);
    void forget();  // all but the marks

private:
    struct Mark {
        unsigned quiet = 0, patience = 0;  // steps without such an access; how many are allowed
        bool direct = false;
    };

    using Words = std::bitset<1024>;
    Page& use(std::uint32_t page, std::uint32_t physical);
    // Of a physical page, all that were translated at any virtual one; nullptr: none.
    const Words* words_of(std::uint32_t physical) const {
        if (physical != asked_) {
            const auto found = words_.find(physical);
            asked_ = physical;
            answer_ = found == words_.end() ? nullptr : &found->second;
        }
        return answer_;
    }

    struct Straight {
        std::uint32_t pc = 0, thumb = 0;
        unsigned count = 0;  // 0: empty
    };

    Fetch fetch_;
    std::array<Straight, 1024> straight_;        // answers of to_next_branch()
    std::uint32_t far_begin_ = 1, far_end_ = 0;  // no branch between these, of the last FAR one
    std::unordered_map<std::uint32_t, Mark> marks_;
    std::unordered_map<std::uint32_t, unsigned> patience_;  // of those unmarked again
    std::unordered_map<std::uint32_t, unsigned> it_;        // all but zeros
    std::map<std::uint32_t, std::uint32_t> blocks_;         // begin to end
    std::unordered_map<std::uint32_t, Page> pages_;         // by virtual number
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> pages_of_;  // by physical number
    std::unordered_map<std::uint32_t, Words> words_;                          // likewise
    mutable std::uint32_t asked_ = ~0u;  // the last page, and what words_ has of it
    mutable const Words* answer_ = nullptr;
};

}  // namespace sim
