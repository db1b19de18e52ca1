// machine.h - the processor under test and Unicorn, with the same registers and memory.
//
//   0x00010000   64 KB of code
//   0x40000000   640 KB: the same 64 KB of data ten times, and so at 0xC0000000; Normal
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tb::core {

constexpr std::uint32_t CODE = 0x10000, DATA = 0x40000000, FAR_DATA = 0xC0000000;
constexpr std::uint32_t PART = 0x10000, PARTS = 10;

struct State {
    std::array<std::uint32_t, 15> r{};
    std::uint32_t cpsr = 0, fpscr = 0;
    std::array<std::uint64_t, 32> d{};
};

struct Memory {
    alignas(4096) std::array<std::uint8_t, PART> code{};
    alignas(4096) std::array<std::uint8_t, PART> data{};
};

class Machine {
public:
    virtual ~Machine() = default;
    virtual void set(const State& state) = 0;
    virtual State state() const = 0;
    // From `begin` until `end`, which is `instructions` away.  Returns the pc where it ended, or an
    // odd number for any other event.
    virtual std::uint32_t run(std::uint32_t begin, std::uint32_t end, unsigned instructions) = 0;
    // So many instructions from `begin` on, wherever they go.  Returns the pc.
    virtual std::uint32_t run_on(std::uint32_t begin, unsigned instructions) = 0;
    virtual void code_changed(std::uint32_t begin, std::uint32_t bytes) = 0;

    // Added to the pc.
    static constexpr std::uint32_t UNDEFINED = 1, UNALIGNED = 0x80000000;
    static constexpr std::uint32_t OTHER = 0xFFFFFFFF;

    std::unique_ptr<Memory> memory = std::make_unique<Memory>();
};

// In one piece, or one instruction at a time.
std::unique_ptr<Machine> processor(bool stepping);
std::unique_ptr<Machine> unicorn();
std::unique_ptr<Machine> qemu();  // run() ends at an undefined instruction; no run_on()

// What differs, one line each; empty if there is no difference.
std::string difference(const State& expected, const State& actual, std::uint32_t fpscr_mask);

}  // namespace tb::core
