// is42s16320d.h - the board's SDRAM: ISSI IS42S16320D-7
//
// 64 MB: four banks of 8,192 rows of 1,024 half-words.
//
// Sees the pins at each rising edge of CLK.  The edge after one at which CKE was low does nothing:
// no command is taken, a burst stands still (clock suspend, power-down).  REFRESH with CKE low
// begins self-refresh, in which no row is forgotten.  Bursts of 1, 2, 4, 8 or a row, sequential or
// interleaved, CAS latency 2 or 3, data masks, auto-precharge, burst stop.  Begins with zeros,
// where the real chip's content is unknown.
//
// A command that the datasheet does not allow is a violation: before the end of the initialisation,
// to a bank in the wrong state, too early after another one (tRCD, tRP, tRAS, tRC, tRRD, tWR,
// tMRD), refreshes of a row more than 64 ms apart, data driven by both sides.  The command is
// executed even so, as far as possible.  One while CKE is low is a violation, too, and is not.
//
// Not handled: loss of data in rows that are not refreshed; the time that it takes to leave
// self-refresh.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace sim {

class Is42s16320d {
public:
    static constexpr std::uint32_t SIZE = 64u << 20;  // bytes

    struct Pins {
        bool cs_n, ras_n, cas_n, we_n;
        std::uint8_t ba;
        std::uint16_t addr;  // A12-A0
        std::uint8_t dqm;    // bit 1: upper byte
        bool driven;         // DQ, by the other side
        std::uint16_t dq;
        bool cke = true;
    };
    // std::bad_alloc if the host lacks the address space.
    Is42s16320d();

    // A rising edge of CLK.  Edges with CS_N high may be left out unless busy() or CKE moves.
    void clock(const Pins& pins, std::uint64_t time_ps);
    // A burst is under way.
    bool busy() const { return left_ != 0 || driving_ != 0 || drives_; }
    // What it drives on DQ until the next edge; undefined while it drives nothing.
    std::uint16_t dq() const { return dq_; }

    std::uint64_t violations() const { return violations_; }
    // The first 20: "READ at 12.34 us: bank 1 has no open row".
    const std::vector<std::string>& messages() const { return messages_; }

    // All cells, little-endian: half-word (row, bank, column) is at 2 * (row << 12 | bank << 10 |
    // column).
    std::uint8_t* bytes() { return reinterpret_cast<std::uint8_t*>(cells_.get()); }

private:
    struct Bank {
        bool open = false;
        std::uint16_t row = 0;
        std::uint64_t activated = 0, precharged = 0, written = 0;  // ps
    };
    static constexpr unsigned BANKS = 4, ROWS = 8192, COLUMNS = 1024;

    void activate(const Pins& pins);
    void access(const Pins& pins, bool write);
    void precharge(const Pins& pins);
    void close(Bank& bank, std::uint64_t time);
    void refresh();
    void load_mode(const Pins& pins);
    bool is_awake(const Pins& pins);
    void burst(const Pins& pins);
    std::uint32_t cell() const;
    void at_least(std::uint64_t since, unsigned ns, const char* name);
    void violation(const std::string& what);

    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<std::uint16_t[], Free> cells_;
    std::array<Bank, BANKS> banks_;
    std::uint64_t violations_ = 0;
    std::vector<std::string> messages_;
    std::uint64_t now_ = 0, last_active_ = 0, last_mode_ = 0, last_refresh_ = 0;
    const char* command_ = "";
    bool closed_once_ = false;  // all banks, after power-up
    std::uint64_t refreshes_ = 0;
    std::vector<std::uint64_t> refreshed_;  // times of the last 8,192
    unsigned length_ = 0, latency_ = 0;     // 0: no mode has been set
    bool interleaved_ = false, single_writes_ = false;

    bool writing_ = false, closes_ = false;  // of the burst under way; closes_: auto-precharge
    unsigned bank_ = 0, begin_ = 0, done_ = 0, left_ = 0;
    std::uint16_t pipe_[2] = {0, 0};  // words on their way to DQ
    unsigned driving_ = 0;            // bit n: pipe_[n] holds one
    bool drives_ = false;             // DQ, since the last edge
    bool cke_ = true;                 // at the edge before
    bool self_refresh_ = false;
    std::uint16_t dq_ = 0;
    std::uint8_t mask_ = 0;  // DQM of the edge before
};

}  // namespace sim
