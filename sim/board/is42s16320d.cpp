#include "sim/board/is42s16320d.h"

#include <algorithm>
#include <new>
#include <utility>

#include <fmt/format.h>

namespace sim {

namespace {

// Datasheet, AC characteristics of the -7 part, in ns.
constexpr unsigned T_RC = 60, T_RAS = 37, T_RP = 15, T_RCD = 15, T_RRD = 14, T_WR = 14, T_MRD = 14;
constexpr unsigned POWER_UP_NS = 100'000, REFRESHES_AT_FIRST = 2;
constexpr std::uint64_t RETENTION_PS = 64'000'000'000;
constexpr std::uint64_t NEVER = ~std::uint64_t{0};

constexpr std::uint16_t A10 = 0x400;
constexpr unsigned NOP = 7;
constexpr std::uint64_t SDRAM_MESSAGES = 20;

std::uint16_t lanes(unsigned mask) {
    return static_cast<std::uint16_t>((mask & 1 ? 0 : 0x00ff) | (mask & 2 ? 0 : 0xff00));
}

}  // namespace

// calloc() lets the host allocate zeroed pages when they are touched.
Is42s16320d::Is42s16320d()
    : cells_{static_cast<std::uint16_t*>(std::calloc(SIZE / 2, 2))}, refreshed_(ROWS, 0) {
    if (!cells_) throw std::bad_alloc{};
    for (Bank& bank : banks_) bank.activated = bank.precharged = bank.written = NEVER;
    last_active_ = last_mode_ = last_refresh_ = NEVER;
}

void Is42s16320d::violation(const std::string& what) {
    if (++violations_ > SDRAM_MESSAGES) return;
    messages_.push_back(
        fmt::format("{} at {:.2f} us: {}", command_, static_cast<double>(now_) / 1e6, what));
}

void Is42s16320d::at_least(std::uint64_t since, unsigned ns, const char* name) {
    if (since != NEVER && now_ - since < std::uint64_t{ns} * 1000)
        violation(fmt::format("{} is {} ns at least, not {:.1f}", name, ns,
                              static_cast<double>(now_ - since) / 1e3));
}

void Is42s16320d::clock(const Pins& pins, std::uint64_t time_ps) {
    static constexpr const char* NAMES[] = {"LOAD MODE", "REFRESH", "PRECHARGE",  "ACTIVE",
                                            "WRITE",     "READ",    "BURST STOP", "NOP"};
    now_ = time_ps;
    const unsigned command = pins.cs_n ? NOP : pins.ras_n * 4u + pins.cas_n * 2u + pins.we_n;
    command_ = NAMES[command];
    if (!is_awake(pins)) {
        if (command != NOP) violation("not taken, since CKE is low");
        return;
    }
    if (command != NOP) {
        self_refresh_ = command == 1 && !pins.cke;
        if (command < 6 && command != 2 && !closed_once_)
            violation("no PRECHARGE of all banks after power-up");
        switch (command) {
            case 0: load_mode(pins); break;
            case 1: refresh(); break;
            case 2: precharge(pins); break;
            case 3: activate(pins); break;
            case 4: access(pins, true); break;
            case 5: access(pins, false); break;
            case 6: left_ = 0; break;
            default: break;
        }
    }
    burst(pins);
}

bool Is42s16320d::is_awake(const Pins& pins) {
    const bool before = std::exchange(cke_, pins.cke);
    if (!before && pins.cke && std::exchange(self_refresh_, false))
        std::fill(refreshed_.begin(), refreshed_.end(), now_);
    return before;
}

void Is42s16320d::activate(const Pins& pins) {
    if (!latency_) violation("no mode has been set");
    Bank& bank = banks_[pins.ba];
    if (bank.open) violation(fmt::format("bank {} has an open row", pins.ba));
    at_least(bank.precharged, T_RP, "tRP");
    at_least(bank.activated, T_RC, "tRC");
    at_least(last_refresh_, T_RC, "tRC");
    at_least(last_active_, T_RRD, "tRRD");
    at_least(last_mode_, T_MRD, "tMRD");
    if (now_ - refreshed_[refreshes_ % ROWS] > RETENTION_PS)
        violation("fewer than 8,192 refreshes in the 64 ms before");
    bank.open = true;
    bank.row = pins.addr;
    bank.activated = last_active_ = now_;
}

void Is42s16320d::access(const Pins& pins, bool write) {
    Bank& bank = banks_[pins.ba];
    if (!bank.open) violation(fmt::format("bank {} has no open row", pins.ba));
    at_least(bank.activated, T_RCD, "tRCD");
    if (left_ && closes_) violation("a burst with auto-precharge is under way");
    writing_ = write;
    closes_ = pins.addr & A10;
    bank_ = pins.ba;
    begin_ = pins.addr & (COLUMNS - 1);
    done_ = 0;
    left_ = write && single_writes_ ? 1 : length_;
}

void Is42s16320d::close(Bank& bank, std::uint64_t time) {
    bank.open = false;
    bank.precharged = time;
}

void Is42s16320d::precharge(const Pins& pins) {
    if (!closed_once_) at_least(0, POWER_UP_NS, "the wait after power-up");
    const bool all = pins.addr & A10;
    for (unsigned i = 0; i < BANKS; ++i) {
        Bank& bank = banks_[i];
        if (!bank.open || !(all || i == pins.ba)) continue;
        at_least(bank.activated, T_RAS, "tRAS");
        at_least(bank.written, T_WR, "tWR");
        if (left_ && bank_ == i) left_ = 0;
        close(bank, now_);
    }
    closed_once_ |= all;
}

void Is42s16320d::refresh() {
    for (unsigned i = 0; i < BANKS; ++i) {
        if (banks_[i].open) violation(fmt::format("bank {} has an open row", i));
        at_least(banks_[i].precharged, T_RP, "tRP");
    }
    at_least(last_refresh_, T_RC, "tRC");
    at_least(last_mode_, T_MRD, "tMRD");
    std::uint64_t& row = refreshed_[refreshes_++ % ROWS];
    if (now_ - row > RETENTION_PS) violation("a row's refreshes are more than 64 ms apart");
    row = last_refresh_ = now_;
}

void Is42s16320d::load_mode(const Pins& pins) {
    for (unsigned i = 0; i < BANKS; ++i)
        if (banks_[i].open) violation(fmt::format("bank {} has an open row", i));
    if (refreshes_ < REFRESHES_AT_FIRST) violation("two refreshes come before it");
    at_least(last_refresh_, T_RC, "tRC");
    const unsigned burst = pins.addr & 7, latency = pins.addr >> 4 & 7;
    interleaved_ = pins.addr >> 3 & 1;
    single_writes_ = pins.addr >> 9 & 1;
    if ((burst > 3 && burst != 7) || (burst == 7 && interleaved_) || latency < 2 || latency > 3)
        violation(fmt::format("0x{:04X} is not a mode", pins.addr));
    length_ = burst == 7 ? COLUMNS : 1u << (burst & 3);
    latency_ = latency == 2 ? 2 : 3;
    last_mode_ = now_;
}

std::uint32_t Is42s16320d::cell() const {
    const unsigned mask = length_ - 1;
    const unsigned inside = interleaved_ ? begin_ ^ done_ : begin_ + done_;
    const unsigned column = (begin_ & ~mask) | (inside & mask);
    return static_cast<std::uint32_t>(banks_[bank_].row) << 12 | bank_ << 10 | column;
}

// A column is written, or is put into the pipeline to DQ, where it arrives latency_ - 1 edges
// later.
void Is42s16320d::burst(const Pins& pins) {
    const bool drove = drives_;
    drives_ = driving_ & 1;
    if (drives_) dq_ = static_cast<std::uint16_t>(pipe_[0] | ~lanes(mask_));
    if (pins.driven && (drove || drives_)) violation("DQ is driven by both sides");
    mask_ = pins.dqm;
    pipe_[0] = pipe_[1];
    driving_ >>= 1;
    if (left_) {
        std::uint16_t& word = cells_[cell()];
        if (writing_) {
            if (!pins.driven) violation("nobody drives DQ");
            const std::uint16_t keep = static_cast<std::uint16_t>(~lanes(pins.dqm));
            word = static_cast<std::uint16_t>((word & keep) | (pins.dq & ~keep));
            banks_[bank_].written = now_;
        } else {
            const unsigned slot = latency_ - 2;
            pipe_[slot] = word;
            driving_ |= 1u << slot;
        }
        ++done_;
        if (--left_ == 0 && closes_) close(banks_[bank_], now_);
    }
}

}  // namespace sim
