// A program is refused, or its segments lie in the memory, apart from each other.
#include <algorithm>

#include "sim/cpu/elf.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

constexpr std::uint32_t BASE = 0x8000, BYTES = 0x40000000;

void must_be_sound(const sim::ElfProgram& program) {
    must(!program.segments.empty(), "a program has a segment");
    bool has_entry = false;
    for (const sim::ElfSegment& one : program.segments) {
        must(one.size > 0 && one.data.size() <= one.size, "a segment has its data");
        must(one.physical >= BASE && one.size <= BYTES && one.physical - BASE <= BYTES - one.size,
             "a segment is in the memory");
        for (const sim::ElfSegment& other : program.segments)
            must(&one == &other || one.physical >= std::uint64_t{other.physical} + other.size ||
                     other.physical >= std::uint64_t{one.physical} + one.size,
                 "segments do not overlap");
        has_entry |= one.executable && (program.entry & ~1u) - one.address < one.size;
    }
    must(has_entry, "the entry point can be executed");
    must(std::is_sorted(program.functions.begin(), program.functions.end(),
                        [](const auto& a, const auto& b) { return a.address < b.address; }),
         "functions are in the order of their addresses");
    for (const sim::ElfFunction& function : program.functions)
        (void)program.function(function.address + 1);
}

}  // namespace

void try_elf(std::string_view input) {
    const std::string file = path_in_memory(input);
    try {
        must_be_sound(sim::load_elf(file, {{BASE, BYTES}}));
        must(sim::is_elf(file), "what is loaded is an ELF file");
    } catch (const sim::ElfError& error) {
        must_be_a_line(error.what());
    }
    try {
        (void)sim::expects_linux(file);
    } catch (const sim::ElfError& error) {
        must_be_a_line(error.what());
    }
}

}  // namespace fuzz
