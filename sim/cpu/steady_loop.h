// steady_loop.h - interprets one round of a loop, and says for how many rounds it does the same.
//
// A round is steady if each register, and each word of memory that it writes, grows by the same
// amount in every round (by 0, mostly), or is written before it is read; and if what it reads from
// the bus is what it read there before, or a counter that runs in time.  So these are steady:
//     while (!flag);                                   for (;;) LEDR = SW;
//     for (volatile int i = 0; i < 1000000; i++);      while (KEY == 0) seed++;
//     while (!(STATUS & 1) && --timeout);              b .
//     while (GLOBAL_TIMER - begin < 200000);           while (PMCCNTR - begin < 800000);
// The round then takes the same path until a comparison comes out differently; when that is follows
// from the amounts.  Nothing is executed here, and nothing is guessed: where the state after n
// rounds is not known exactly, the loop is not steady.
//
// A round begins at the present pc, and ends when it comes back there.  The flags must not be used
// in it before they are set, so ahead() names a better place to begin if there is one: the target
// of the first branch backwards.
//
// Source: ARM DDI 0406C.
//
// Not handled, so never steady: changes between ARM and Thumb; big-endian data; VFP and NEON;
// coprocessors but for PMCCNTR, exceptions and changes of mode; exclusive accesses; unaligned ones;
// rounds of more than MOST instructions, with more than WORDS words written or more than USES
// accesses to the bus; addresses that grow; shifts and logical operations on values that grow;
// counters that run in time where not every access takes the same time in each round.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sim/cpu/linear.h"
#include "sim/hps/running_count.h"

namespace sim {

class SteadyLoop {
public:
    static constexpr unsigned MOST = 256, WORDS = 16, USES = 16;

    struct Registers {
        std::array<std::uint32_t, 16> r;  // r15: of the next instruction
        std::uint32_t cpsr;
    };

    // An access to the bus.
    struct Use {
        std::uint32_t pc, address;  // on the bus
        unsigned bytes;
        bool write;
        std::uint32_t value;
        unsigned at;  // instructions of the round up to this one, including it
    };

    // What surrounds the processor's registers.
    class World {
    public:
        // The instruction at `pc`, if it may be read and executed there; of Thumb, one of 16 bits
        // is at most 0xFFFF.
        virtual std::optional<std::uint32_t> code(std::uint32_t pc, bool thumb) = 0;
        struct Place {
            const std::uint8_t* ram = nullptr;  // the host's byte of it; nullptr: see `on_bus`
            bool on_bus = false;
            std::uint32_t address = 0;  // on the bus
        };
        virtual Place place(std::uint32_t address, bool write) = 0;
        // What the last such access has read; for a write, any value if it has written the same.
        virtual std::optional<std::uint32_t> answer(const Use& use) = 0;
        // If the last of the round's accesses so far reads a counter: how that will go on.
        virtual std::optional<RunningCount> counter(const Use* /*uses*/, unsigned /*count*/) {
            return {};
        }
        // What a round takes that has so many instructions; 0 if it is not the same for each.
        virtual std::uint64_t round_ps(const Use* /*uses*/, unsigned /*count*/,
                                       unsigned /*instructions*/) {
            return 0;
        }
        // PMCCNTR as instruction `at` of the round reads it, from 1; by how much it then grows with
        // each instruction, 1 or 0.
        struct Cycles {
            std::uint32_t value, step;
        };
        virtual std::optional<Cycles> cycles(unsigned /*at*/) { return {}; }

    protected:
        ~World() = default;
    };

    // Interprets a round that begins at these registers.  True: it is steady, and what follows is
    // of it.
    bool follow(const Registers& registers, World& world);
    // The same, but each round takes the flags at its begin to be those of the registers.
    bool follow_with_flags(const Registers& registers, World& world);

    unsigned instructions() const { return instructions_; }
    // In so many rounds from now on all is as computed.
    std::uint64_t rounds() const { return rounds_; }
    // The registers after n of them; the flags are those at the begin.
    Registers after(std::uint64_t n) const;
    struct Word {
        std::uint32_t address;  // of the program
        Linear value;           // at the begin of round n
    };
    const Word* words() const { return words_.data(); }
    unsigned word_count() const { return word_count_; }
    // What a word is after n rounds.
    std::uint32_t word_after(unsigned word, std::uint64_t n) const {
        return after(words_[word].value, now_[word], words_read_ >> word & 1, n);
    }
    const Use* uses() const { return uses_.data(); }
    unsigned use_count() const { return use_count_; }

    // If it is not steady: after so many instructions another place begins that may be; or nothing.
    std::optional<unsigned> ahead() const { return ahead_; }

private:
    // The flags: those of a comparison, or some that are known.
    struct Flags {
        bool compared = false;
        Linear a, b;         // ... of these two
        unsigned known = 0;  // else these of NZCV
        unsigned nzcv = 0;
    };

    bool two_passes(const Registers& registers, World& world);
    bool pass(World& world);
    bool execute(std::uint32_t word, World& world);
    bool execute_arm(std::uint32_t word, World& world);
    bool execute_thumb(std::uint32_t word, World& world);
    bool thumb_16(std::uint32_t word, World& world);
    bool thumb_32(std::uint32_t word, World& world);
    bool thumb_branch(std::uint32_t word);
    bool thumb_data(std::uint32_t word);
    bool thumb_transfer(std::uint32_t word, World& world);
    bool branch(std::uint32_t offset, bool link);
    bool cycle_counter(unsigned target, World& world);
    bool data_processing(std::uint32_t word);
    bool operate(unsigned operation, bool sets, unsigned target, Linear a, Linear b, int carry);
    bool miscellaneous(std::uint32_t word);
    bool single_transfer(std::uint32_t word, World& world);
    bool extra_transfer(std::uint32_t word, World& world);
    bool block_transfer(std::uint32_t word, World& world);
    bool media(std::uint32_t word);
    bool transfer(bool load, unsigned bytes, bool is_signed, unsigned target, const Linear& address,
                  World& world);
    std::optional<Linear> load(const Linear& address, unsigned bytes, World& world);
    bool store(const Linear& address, unsigned bytes, const Linear& value, World& world);
    Word* word_at(std::uint32_t address, World& world);
    std::optional<bool> holds(unsigned condition);
    bool write(unsigned number, const Linear& value);
    Linear read(unsigned number);
    static std::uint32_t after(const Linear& begin, const Linear& end, bool is_read,
                               std::uint64_t n) {
        return is_read || n == 0 ? begin.in_round(n) : end.in_round(n - 1);
    }
    std::optional<Linear> shifted(std::uint32_t word, int& carry);
    void set_logical(const Linear& result, int carry);
    bool in_it() const { return (it_ & 0xF) != 0; }
    void limit(std::uint64_t rounds) { rounds_ = std::min(rounds_, rounds); }

    std::array<Linear, 16> r_;
    Flags flags_, first_flags_;
    bool flags_missing_ = false;       // an instruction has asked for some that are not known
    std::uint32_t pc_ = 0, next_ = 0;  // of the present instruction; of the one after it
    unsigned instructions_ = 0;
    std::uint64_t rounds_ = 0;
    std::array<Linear, 16> begin_;
    std::uint32_t read_ = 0, written_ = 0;  // registers of the round: read before they are written
    std::uint32_t words_read_ = 0, words_written_ = 0;
    unsigned round_instructions_ = 0;  // 0 in the first pass
    bool counts_ = false;              // the round reads a counter that runs in time
    std::uint64_t round_ps_ = 0;       // of one that does; 0 in the first pass
    bool thumb_ = false;
    unsigned it_ = 0;  // Thumb's ITSTATE
    std::array<Word, WORDS> words_;
    std::array<Linear, WORDS> now_;  // what they are within the round
    unsigned word_count_ = 0;
    std::array<Use, USES> uses_;
    unsigned use_count_ = 0;
    std::optional<unsigned> ahead_;
    std::uint32_t cpsr_ = 0;
};

}  // namespace sim
