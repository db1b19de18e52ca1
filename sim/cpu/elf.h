// elf.h - a program for a processor of the board: an ELF32 little-endian executable for the ARM or
// for RISC-V (Nios V), and its names.
//
// Read with libelf.  Segments are placed at their physical addresses (LMA), as a boot loader and
// GDB's `load` place them; what lies beyond the bytes of the file is zero.
//
// Refused, each with one line "FILE: why": what is not an ELF, another machine or byte order,
// RISC-V with compressed instructions, 64 bits, no executable, segments that overlap, that leave
// the memory or the file, an entry point in no executable segment, more than 256 MB; without a
// Linux, also dynamic linking and position-independent programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace sim {

struct ElfError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ElfSegment {
    std::uint32_t physical;  // where it is loaded
    std::uint32_t address;   // where it runs (VMA)
    std::uint32_t size;      // in memory; data may be shorter, the rest is zero
    std::vector<std::uint8_t> data;
    bool writable, executable;
};

struct ElfFunction {
    std::uint32_t address;  // bit 0 cleared
    std::uint32_t size;     // 0: up to the next one
    std::string name;
};

// A section that is in memory: ".text", ".data".
struct ElfSection {
    std::uint32_t address, size;
    std::string name;
    bool writable, executable;

    bool holds(std::uint32_t at) const { return at - address < size; }
    // Data by flags or name; a vector table may be neither executable nor writable.
    bool is_data() const { return !executable && (writable || name.rfind(".rodata", 0) == 0); }
};

// Where `de1sim link` places kernel modules: each file in one of these places.
constexpr std::uint32_t KERNEL_BASE = 0xBF000000, KERNEL_PLACE_BYTES = 4 << 20, KERNEL_PLACES = 64;
constexpr const char* MODULES_SECTION = ".de1sim.modules.";  // and their name, in a program

struct ElfProgram {
    std::filesystem::path file;
    std::uint32_t entry = 0;         // bit 0: Thumb
    std::uint32_t headers = 0;       // where the program headers run, 0 if they are not loaded
    std::uint32_t header_count = 0;  // of 32 bytes each
    std::vector<ElfSegment> segments;
    std::vector<ElfFunction> functions;  // by address
    std::vector<ElfSection> sections;    // those in memory; none in a stripped file
    bool movable = false;                // position-independent
    std::string interpreter;             // the dynamic linker's path; "": none
    std::vector<std::uint8_t> modules;   // an ELF file of kernel modules that it carries; or none
    std::string modules_name;

    bool is_modules() const { return !segments.empty() && entry >= KERNEL_BASE; }
    // Adds `bytes` to all addresses: of a position-independent program.
    void move(std::uint32_t bytes);

    std::vector<ElfProgram> libraries;  // that have been loaded to it, with their names
    // The function around `address`, demangled: "main", "main+0x10"; "" if there is none.  Of a
    // library "qsort+0x10 of libc.so.6", or "libc.so.6+0x1234" where it has no name.
    std::string function(std::uint32_t address) const;

    // What is in no section becomes zero, since GDB's `load` does not bring it: a segment may
    // begin with the headers of the file.  A file without sections stays as it is.
    void leave_only_sections();
};

struct MemoryRange {
    std::uint32_t base;
    std::uint64_t size;
};

enum class Linking { STATIC, ANY, LIBRARY };  // LIBRARY: ANY, and what has no entry point

// Where a position-independent program lies, as Linux has it on ARM without randomisation.
constexpr std::uint32_t POSITION_INDEPENDENT_BASE = 0x00400000;

enum class ElfMachine { ARM, RISCV };
// ElfError, as for load_elf().
ElfMachine machine_of(const std::filesystem::path& file);

// ElfError.  Segments have to lie in `memory`.
ElfProgram load_elf(const std::filesystem::path& file, const std::vector<MemoryRange>& memory,
                    Linking linking = Linking::STATIC);

// The file begins like an ELF file; false also if it cannot be read.
bool is_elf(const std::filesystem::path& file);

// A program for Linux: its OS ABI is Linux (GNU), or it has an interpreter, or a note "GNU" with an
// ABI tag of Linux, like every program linked with glibc's start files.  ElfError.
bool expects_linux(const std::filesystem::path& file);

}  // namespace sim
