// poll_loop.h - recognizes that a program does nothing but wait for a register to change, and says
// how long it may rest, so that a run does not spend its time on answers that are known.
//
// A poll loop is a cycle of at most MOST accesses, each by the same instruction to the same
// register in every round: at least one read, and writes only to registers where writing the same
// value again and again is no more than writing it once (ArmCpu::set_plain_outputs).
// So it is one of
//     while (!(STATUS & 1));
//     while (STATUS & 1) { AUDIO_SPACE; PS2_DATA; }      nothing to do in either
//     for (;;) LEDR = SW;
//
// After ROUNDS rounds, once in each further round, the program may rest
//   - an eighth of the time for which all values have been the same, 10 us at most;
//   - 100 ns while values change, as those of a running counter; not if the loop writes.
// So it may notice a change that much late.  What the program does in its memory and registers is
// not looked at: a loop that counts its turns counts fewer in the same time.
//
// Times are in picoseconds.  An access costs a few comparisons.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace sim {

class PollLoop {
public:
    static constexpr unsigned MOST = 8, ROUNDS = 8;
    static constexpr std::uint64_t LONG_REST = 10'000'000, SHORT_REST = 100'000;

    // The instruction at `pc` has read `value` at the time `now`: how long the program may rest.
    std::uint64_t read(std::uint32_t pc, std::uint32_t address, std::uint32_t value,
                       std::uint64_t now);
    // It has written to such a register; the same.
    std::uint64_t write(std::uint32_t pc, std::uint32_t address, std::uint32_t value,
                        std::uint64_t now);
    // It has done something else on the bus.
    void end() { *this = {}; }

    // The first register that is read in a round, if this is a poll loop.
    std::optional<std::uint32_t> polled() const;

private:
    struct Access {
        std::uint32_t pc = 0, address = 0, value = 0;
        bool write = false;
        bool is_at(const Access& other) const {
            return pc == other.pc && address == other.address && write == other.write;
        }
    };

    std::uint64_t follow(const Access& access, std::uint64_t now);
    void begin(const Access& access, std::uint64_t now);
    bool may_repeat() const;

    std::array<Access, MOST> cycle_;    // in the order of a round
    unsigned length_ = 0, writes_ = 0;  // of a round
    unsigned next_ = 0;                 // the access that is expected
    bool closed_ = false;               // the cycle has come back to its first access
    bool harmless_ = false;             // it may repeat itself: see above
    unsigned rounds_ = 0, same_ = 0;    // whole ones; those since the last change
    std::uint64_t since_ = 0;           // all values have been the same
};

}  // namespace sim
