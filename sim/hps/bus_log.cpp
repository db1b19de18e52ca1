#include "sim/hps/bus_log.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "sim/text/seconds.h"

namespace sim {

BusLog::BusLog(Bus& bus, const sc_core::sc_time& from, const sc_core::sc_time& to, Program program)
    : bus_{bus}, from_{from}, to_{to}, program_{std::move(program)} {
    bus.on_access([this](const Bus::Access& access) { add(access); });
}

void BusLog::add(const Bus::Access& access) {
    if (access.begin < from_ || access.begin > to_) return;
    std::uint32_t value = 0;
    std::memcpy(&value, access.data, std::min<std::size_t>(access.bytes, sizeof value));
    entries_.push_back({access.begin, access.end, access.address, value, program_.at(),
                        access.bytes, access.write, access.answered});
    if (entries_.size() <= MOST) return;
    entries_.pop_front();
    ++left_out_;
}

std::string BusLog::text() const {
    std::string text = fmt::format(
        "# the processor's bus from {:.9f} s to {:.9f} s: {} accesses; {} came before\n"
        "# time s, ns taken, read or write, bytes, address, first word, register, function\n",
        seconds(from_), seconds(to_), entries_.size(), left_out_);
    for (const Entry& e : entries_)
        text +=
            fmt::format("{:.9f} {:6.0f} {} {:4} 0x{:08X} 0x{:08X} {:24} {}{}\n", seconds(e.begin),
                        seconds(e.end - e.begin) * 1e9, e.write ? "write" : "read ", e.bytes,
                        e.address, e.value, bus_.register_at(e.address), program_.function(e.pc),
                        e.answered ? "" : " ERROR");
    return text;
}

}  // namespace sim
