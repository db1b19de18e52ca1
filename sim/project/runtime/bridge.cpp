#include "sim/project/runtime/bridge.h"

#include <cstdio>
#include <cstring>

#include "svdpi.h"

namespace sim::project {

BridgeBurst bridge_burst{};

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

std::string word(unsigned beat) {
    return bridge_burst.beats == 1
               ? std::string{}
               : formatted(" of word %u of a burst of %u", beat + 1, bridge_burst.beats);
}

}  // namespace

std::string bridge_waits_for(std::uint64_t waits) {
    const auto seen = static_cast<unsigned>(waits >> 4 & 0xFFF);
    const auto beat = static_cast<unsigned>(waits >> 16 & 0xF);
    const auto with_id = [&](const char* signal) {
        return formatted("%s with ID 0x%03X: the design answers with ID 0x%03X", signal,
                         bridge_burst.id, seen);
    };
    switch (waits & 0xF) {
        case AWREADY: return "awready";
        case WREADY: return "wready" + word(beat);
        case BVALID: return "bvalid";
        case ARREADY: return "arready";
        case RVALID: return "rvalid" + word(beat);
        case CLK: return "clk";
        case WRONG_BID: return with_id("bvalid");
        case WRONG_RID: return with_id("rvalid");
        case EARLY_BVALID: return "bvalid after the last word: it came at the time" + word(seen);
        case EARLY_RLAST: return "rvalid" + word(beat + 1) + ": rlast came with the one before";
        case NO_RLAST: return "rlast with the last word";
        default: return {};
    }
}

}  // namespace sim::project

using sim::project::bridge_burst;

extern "C" long long de1sim_hps_burst() {
    const auto& b = bridge_burst;
    const std::uint32_t high = (b.beats - 1) | b.size << 4 | b.kind << 7 | b.id << 9 |
                               b.lock << 21 | b.cache << 23 | b.prot << 27 |
                               (b.write ? 1u << 30 : 0);
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
