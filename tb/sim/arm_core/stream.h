// stream.h - random programs without branches, made from the tables of encodings.h.
//
// A stream keeps some registers for itself: bases and indexes of loads and stores, which only
// write-back changes.  So every access lands in the window of machine.h.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tb/sim/arm_core/maker.h"

namespace tb::core {

// What must not be parted: an instruction, an IT block, an exclusive load with its store.
struct Item {
    std::string name;
    std::vector<std::uint32_t> words;  // a Thumb instruction of 16 bits has bits 31:16 clear
};

// NEAREST: VFP that rounds to the nearest and does not change that.  NEON_COMPUTING: no NEON loads
// and stores.  SYSTEM: an operating system's instructions, among others.
enum class Kind { COMPUTING, MEMORY, VFP, NEAREST, NEON, NEON_COMPUTING, MIXED, SYSTEM };

struct Stream {
    bool thumb;
    std::vector<Item> items;
    Registers registers;

    unsigned instructions() const;
    // Of the first `count` items, followed by UDF.
    std::vector<std::uint16_t> code(std::size_t count) const;
};

// `aborts`: with NEON's loads and stores that ask for an alignment.
Stream make_stream(Random& random, bool thumb, Kind kind, unsigned length, bool aborts);

}  // namespace tb::core
