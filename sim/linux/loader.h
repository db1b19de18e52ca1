// loader.h - a Linux process's ELF files: its program, the interpreter, the libraries.
//
// The kernel loads the program and the interpreter that it names; the interpreter, glibc's dynamic
// linker, maps the libraries.  Of these only the names are read here, for messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/cpu/arm_cpu.h"
#include "sim/cpu/elf.h"
#include "sim/linux/address_space.h"
#include "sim/linux/files.h"

namespace sim {

// Where a Linux program may lie, or its modules.
const std::vector<MemoryRange>& linux_memory();

class LinuxLoader {
public:
    explicit LinuxLoader(ArmCpu& cpu) : cpu_{cpu} {}

    // From the host's file of this number, which is closed.  ElfError.
    static ElfProgram load(const std::string& path, int host);
    // None if the program is statically linked.  std::runtime_error if it is not there.
    static std::optional<ElfProgram> interpreter_of(const ElfProgram& program,
                                                    const LinuxFiles& files);
    // As start_linux_program().
    std::uint32_t begin(AddressSpace& memory, const ElfProgram& program,
                        std::optional<ElfProgram> interpreter,
                        const std::vector<std::string>& arguments,
                        const std::vector<std::string>& variables);

    // The program has opened `path`, the host's file of this number, or has not found it: negative.
    void looked_for(const std::string& path, int host);
    // It has mapped the beginning of a file as code.
    void mapped(const LinuxFiles& files, int fd, std::uint32_t place);

    // Why the interpreter has ended the program with this exit code, and what to do; or "".
    std::string failure(std::uint32_t exit_code) const;
    // What was looked for in vain, the last library of that kind, and why: "libx.so.1, which is not
    // there"; or "".
    std::string missing() const;

    // The names of what is loaded are in messages from now on.
    void add_names(ElfProgram library);

private:
    ArmCpu& cpu_;
    std::string missing_;  // the library that was looked for last, while it is not found
    std::string unfit_;    // why one of that name does not fit; or ""
};

// The interpreter looks for a library in several places.
bool is_library(const std::string& path);

}  // namespace sim
