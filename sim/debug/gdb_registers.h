// gdb_registers.h - a processor's registers, as GDB is told of them
//
// Source: "Debugging with GDB", G.5 Standard Target Features.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sim {

struct GdbRegister {
    const char* feature;  // of the target description
    std::string name;
    unsigned bits;
    const char* type;

    unsigned bytes() const { return bits / 8; }
};

struct GdbRegisters {
    const char* architecture;      // as GDB has it
    const char* system;            // operating system, likewise; "": GDB chooses
    std::vector<GdbRegister> all;  // by number; those of a feature are next to each other
    unsigned pc;
    unsigned first;  // is written before the others

    std::uint32_t bytes() const {
        std::uint32_t sum = 0;
        for (const GdbRegister& one : all) sum += one.bytes();
        return sum;
    }
};

}  // namespace sim
