#include "sim/project/runtime/bridge.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "svdpi.h"

namespace sim::project {

BridgeBurst bridge_burst{};
PostedWrites posted_writes;

namespace {

// As rtl/ip/de1sim_hps_axi.v and de1sim_hps_port.v have them.
enum Waits {
    AWREADY = 1,
    WREADY = 2,
    BVALID = 3,
    ARREADY = 4,
    RVALID = 5,
    CLK = 7,
    WRONG_BID = 8,
    WRONG_RID = 9,
    EARLY_BVALID = 10,
    EARLY_RLAST = 11,
    NO_RLAST = 12
};

template <class... Values>
std::string formatted(const char* format, Values... values) {
    char text[100];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string with_id(const char* signal, unsigned id, unsigned seen) {
    return formatted("%s with ID 0x%03X: the design answers with ID 0x%03X", signal, id, seen);
}

std::string word(unsigned beat) {
    return bridge_burst.beats == 1
               ? std::string{}
               : formatted(" of word %u of a burst of %u", beat + 1, bridge_burst.beats);
}

}  // namespace

bool PostedWrites::has(unsigned id) const {
    return std::any_of(writes_.begin(), writes_.end(),
                       [id](const Write& write) { return write.burst.id == id; });
}

const BridgeBurst* PostedWrites::next() {
    const auto of_state = [this](State state) {
        return std::find_if(writes_.begin(), writes_.end(),
                            [state](const Write& write) { return write.state == state; });
    };
    if (const auto done = of_state(State::IS_SENT_NOW); done != writes_.end()) writes_.erase(done);
    const auto waits = of_state(State::WAITS);
    if (waits == writes_.end()) return nullptr;
    waits->state = State::IS_SENT_NOW;
    return &waits->burst;
}

void PostedWrites::sent() {
    for (Write& write : writes_)
        if (write.state == State::IS_SENT_NOW) write.state = State::SENT;
}

// Those of the same ID in order.
void PostedWrites::answered(bool full, unsigned id, unsigned response) {
    const auto found = std::find_if(writes_.begin(), writes_.end(), [&](const Write& write) {
        return write.state == State::SENT && write.burst.full == full && write.burst.id == id;
    });
    if (found == writes_.end()) {
        unknown_id_ = id;
        return;
    }
    found->burst.error = response;
    if (response > BridgeBurst::EXOKAY) refused_.push_back(found->burst);
    writes_.erase(found);
}

bool PostedWrites::has_sent(bool full) const {
    return std::any_of(writes_.begin(), writes_.end(), [full](const Write& write) {
        return write.state == State::SENT && write.burst.full == full;
    });
}

std::optional<BridgeBurst> PostedWrites::refused() {
    if (refused_.empty()) return {};
    const BridgeBurst first = refused_.front();
    refused_.erase(refused_.begin());
    return first;
}

std::string PostedWrites::waits_for() const {
    if (writes_.empty()) return {};
    const BridgeBurst& first = writes_.front().burst;
    return unknown_id_ ? with_id("bvalid", first.id, *unknown_id_) : "bvalid";
}

std::string bridge_waits_for(std::uint64_t waits) {
    const auto seen = static_cast<unsigned>(waits >> 4 & 0xFFF);
    const auto beat = static_cast<unsigned>(waits >> 16 & 0xF);
    switch (waits & 0xF) {
        case AWREADY: return "awready";
        case WREADY: return "wready" + word(beat);
        case BVALID: return "bvalid";
        case ARREADY: return "arready";
        case RVALID: return "rvalid" + word(beat);
        case CLK: return "clk";
        case WRONG_BID: return with_id("bvalid", bridge_burst.id, seen);
        case WRONG_RID: return with_id("rvalid", bridge_burst.id, seen);
        case EARLY_BVALID: return "bvalid after the last word: it came at the time" + word(seen);
        case EARLY_RLAST: return "rvalid" + word(beat + 1) + ": rlast came with the one before";
        case NO_RLAST: return "rlast with the last word";
        default: return {};
    }
}

}  // namespace sim::project

using sim::project::bridge_burst;
using sim::project::posted_writes;

extern "C" long long de1sim_hps_burst() {
    const auto& b = bridge_burst;
    const std::uint32_t high = (b.beats - 1) | b.size << 4 | b.kind << 7 | b.id << 9 |
                               b.lock << 21 | b.cache << 23 | b.prot << 27 |
                               (b.write ? 1u << 30 : 0) | (b.posted ? 1u << 31 : 0);
    return static_cast<long long>(std::uint64_t{high} << 32 | b.address);
}

extern "C" void de1sim_hps_refused(int response) {
    bridge_burst.error = static_cast<unsigned>(response);
}

extern "C" int de1sim_hps_beat(int number, int* address, svBitVecVal* data) {
    const auto& beat = bridge_burst.beat[static_cast<unsigned>(number) % bridge_burst.BEATS];
    *address = static_cast<int>(beat.address);
    std::memcpy(data, beat.lanes.data(), beat.lanes.size());
    return beat.strobes;
}

extern "C" void de1sim_hps_answered(int number, const svBitVecVal* data) {
    auto& beat = bridge_burst.beat[static_cast<unsigned>(number) % bridge_burst.BEATS];
    std::memcpy(beat.lanes.data(), data, beat.lanes.size());
}

extern "C" int de1sim_hps_posted(svBit full, svBit sent, svBit bvalid, int bid, int bresp) {
    if (sent) posted_writes.sent();
    if (bvalid)
        posted_writes.answered(full, static_cast<unsigned>(bid), static_cast<unsigned>(bresp));
    return posted_writes.has_sent(full);
}
