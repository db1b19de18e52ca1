// abort_log.cpp - see abort_log.h
#include "sim/cpu/abort_log.h"

#include <fmt/format.h>

namespace sim {

void AbortLog::happened(unsigned exception, std::uint32_t pc, const std::string& text) {
    const std::pair key{exception, pc};
    if (places_.size() >= MOST && places_.count(key) == 0) return;
    Place& place = places_[key];
    if (++place.times > 1) return;
    place.text = text;
    pending_lines_.push_back(text);
}

void AbortLog::failed(const std::string& text) {
    for (const std::string& line : std::exchange(pending_lines_, {}))
        if (line != text) log_(line);
}

void AbortLog::end() {
    handled();
    for (const auto& [key, place] : places_)
        if (place.times > 1) log_(fmt::format("{} times in all: {}", place.times, place.text));
}

}  // namespace sim
