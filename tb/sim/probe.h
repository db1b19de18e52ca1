// probe.h - a target on the bus that keeps what was written to it, and when
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <systemc>

#include "sim/hps/registers.h"

namespace tb {

// Registers that keep their value and the time of each write; every access takes 10 ns.
class Probe : public sim::Registers {
public:
    explicit Probe(const sc_core::sc_module_name& name_) : Registers{name_} {}

    std::map<std::uint32_t, std::uint32_t> values;
    std::vector<std::pair<std::uint32_t, sc_core::sc_time>> writes;
    unsigned reads = 0;

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time&) override {
        ++reads;
        return values[offset];
    }
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override {
        values[offset] = value;
        writes.emplace_back(offset, now);
    }
};

}  // namespace tb
