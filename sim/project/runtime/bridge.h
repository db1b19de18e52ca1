// bridge.h - the bursts that are under way over the processor's bridges, as the design gets them
// through DPI (rtl/ip/de1sim_hps_bridge.vh)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/project/model.h"

namespace sim::project {

// Of all models of the process: a DPI function has no other context.
extern BridgeBurst bridge_burst;

// Posted writes: begun, and not answered.  They are handed to their bridges one after the other.
class PostedWrites {
public:
    void clear() { *this = {}; }
    void begin(const BridgeBurst& burst) { writes_.push_back({burst, State::WAITS}); }
    unsigned count() const { return static_cast<unsigned>(writes_.size()); }
    const BridgeBurst* oldest() const { return writes_.empty() ? nullptr : &writes_[0].burst; }
    bool has(unsigned id) const;
    // While a bridge is free: the next one that it gets, if one waits.  What it had before is
    // answered, unless it is sent.
    const BridgeBurst* next();
    // Of the design.
    void sent();
    void answered(bool full, unsigned id, unsigned response);
    bool has_sent(bool full) const;

    std::optional<BridgeBurst> refused();
    // "bvalid", of the first that is sent; an ID that no write has.
    std::string waits_for() const;

private:
    enum class State { WAITS, IS_SENT_NOW, SENT };
    struct Write {
        BridgeBurst burst;
        State state;
    };
    std::vector<Write> writes_;
    std::vector<BridgeBurst> refused_;
    std::optional<unsigned> unknown_id_;
};
extern PostedWrites posted_writes;

// For what it waits, by a bridge's 20 bits of hps_waits_o: from bit 0 on a code, the ID or
// the beat that was seen with it, and the beat.
std::string bridge_waits_for(std::uint64_t waits);

}  // namespace sim::project
