// arm_core_speed.cpp - the modelled processor's engine alone: no SystemC, no fabric.
//
// The targets ensure that the processor's engine is never what limits a run's speed; they hold on a
// quiet machine.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "sim/cpu/arm_core.h"

namespace {

constexpr std::uint32_t CODE = 0x1000, DATA = 0x8000, DEVICE = 0xFF200000;
constexpr std::uint64_t SECOND = 800'000'000;  // instructions in a simulated second, CPI 1
constexpr int RUNS = 5;

class Counter final : public sim::ArmBus {
public:
    std::uint64_t accesses = 0;

private:
    bool read(std::uint32_t, unsigned, std::uint32_t& value) override {
        value = 0;
        ++accesses;
        return true;
    }
    bool write(std::uint32_t, unsigned, std::uint32_t) override {
        ++accesses;
        return true;
    }
};

struct Speed {
    double instructions_per_s;
    std::uint64_t accesses;
};

// A loop of seven instructions, of which two store: r1 to RAM, r2 wherever `second` is.
Speed loop(std::uint32_t second, std::uint64_t instructions) {
    std::vector<std::uint32_t> ram(0x4000);
    const std::uint32_t program[] = {
        0xE0800003,  // add  r0, r0, r3
        0xE5810000,  // str  r0, [r1]
        0xE0233180,  // eor  r3, r3, r0, lsl #3
        0xE5820004,  // str  r0, [r2, #4]
        0xE2833001,  // add  r3, r3, #1
        0xE2544001,  // subs r4, r4, #1
        0xEAFFFFF8,  // b    the first
    };
    std::copy(std::begin(program), std::end(program), ram.begin() + CODE / 4);
    Counter bus;
    sim::ArmCore core{bus};
    core.map_ram(0, 4 * ram.size(), ram.data());
    core.map_bus(DEVICE, 0x1000, DEVICE);
    core.reset(CODE, DATA + 0x1000);
    core.set_reg(1, DATA);
    core.set_reg(2, second);
    core.run(1000);
    const auto begin = std::chrono::steady_clock::now();
    core.run(instructions);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    return {static_cast<double>(instructions) / took.count(), bus.accesses};
}

// The best of several, because disturbances only make a run slower.
double best(std::uint32_t second, std::uint64_t instructions) {
    double most = 0;
    for (int i = 0; i < RUNS; ++i)
        most = std::max(most, loop(second, instructions).instructions_per_s);
    return most;
}

const char* verdict(bool met) { return met ? "met" : "MISSED"; }

}  // namespace

int main() {
    const double ram = best(DATA, 200'000'000);
    const double device = best(DEVICE, 20'000'000);
    const double access_ns = (7 / device - 7 / ram) * 1e9;
    fmt::print("The processor's engine alone, best of {} runs\n", RUNS);
    fmt::print("  compute loop with two stores to RAM  {:6.0f} M instructions/s (800 wanted: {})\n",
               ram / 1e6, verdict(ram >= 800e6));
    fmt::print("  the same with one to a register      {:6.0f} M instructions/s\n", device / 1e6);
    fmt::print(
        "  an access to a register              {:6.0f} ns besides the bus (150 wanted: {})\n",
        access_ns, verdict(access_ns <= 150));
    fmt::print("  a delay loop of one simulated second {:6.2f} s (1 wanted: {})\n", SECOND / ram,
               verdict(SECOND / ram <= 1));
    return 0;
}
