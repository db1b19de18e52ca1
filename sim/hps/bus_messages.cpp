// bus_messages.cpp - why an access was refused, in the words of the board's map
#include <fmt/format.h>

#include "sim/hps/bus.h"

namespace sim {

namespace {

std::uint32_t last_of(const Bus::Place& place) { return place.base + (place.size - 1); }

bool holds(const Bus::Place& place, std::uint32_t address) {
    return address - place.base < place.size;
}

std::uint32_t distance(const Bus::Place& place, std::uint32_t address) {
    if (holds(place, address)) return 0;
    return address < place.base ? place.base - address : address - last_of(place);
}

std::string range(const Bus::Place& place) {
    return fmt::format("0x{:08X} to 0x{:08X}", place.base, last_of(place));
}

// Registers lie from here on, memory below; the processor's own RAM at the very end is an
// exception.
constexpr std::uint32_t REGISTERS = 0xFC000000;

std::string nothing(std::uint32_t address, const Bus::Place& nearest) {
    if (address >= REGISTERS)
        return fmt::format("no block at 0x{:08X}: the nearest is {}, {}", address, nearest.name,
                           range(nearest));
    const bool above = address > last_of(nearest);
    return fmt::format("no memory at 0x{:08X}: {} {} at 0x{:08X}", address, nearest.name,
                       above ? "ends" : "begins", above ? last_of(nearest) : nearest.base);
}

}  // namespace

std::string Bus::refusal(std::uint32_t address, unsigned bytes, bool write,
                         tlm::tlm_response_status answer) const {
    const Place* nearest = nullptr;
    for (const Window& window : windows_) {
        if (!window.on && address - window.base < window.size)
            return window.title + " is in reset: on the board the processor hangs here";
        if (window.places.empty() && address - window.base < window.size)
            return "the design has nothing at " + window.title;
        for (const Place& place : window.places) {
            if (!place.is_memory && address < REGISTERS && !holds(place, address)) continue;
            if (!nearest || distance(place, address) < distance(*nearest, address))
                nearest = &place;
        }
    }
    for (const Place& place : absent_)
        if (holds(place, address))
            return fmt::format("{}, {}, is not modelled", place.name, range(place));
    if (!nearest) return "nothing is on the bus";
    if (bytes == 0 && holds(*nearest, address)) return nearest->name + " holds no instructions";
    switch (answer) {
        case tlm::TLM_ADDRESS_ERROR_RESPONSE:
            if (holds(*nearest, address))
                return fmt::format("{} ends at 0x{:08X}", nearest->name, last_of(*nearest));
            return nothing(address, *nearest);
        case tlm::TLM_BURST_ERROR_RESPONSE:
            return fmt::format("{} takes no {} of {} bytes at 0x{:08X}: aligned words only",
                               nearest->name, write ? "writes" : "reads", bytes, address);
        case tlm::TLM_COMMAND_ERROR_RESPONSE:
            return fmt::format("{} takes no {}", nearest->name, write ? "writes" : "reads");
        case tlm::TLM_INCOMPLETE_RESPONSE: return nearest->name + " did not answer";
        default: return nearest->name + " answered with an error";
    }
}

}  // namespace sim
