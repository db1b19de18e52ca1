// start.h - how Linux starts a program: its segments, its stack, the page of the kernel's helpers.
//
//   stack, from SP up: argc, argv..., 0, envp..., 0, auxiliary vector, then what they point to
//   0xFFFF0000: __kuser_cmpxchg64 +0xF60, memory_barrier +0xFA0, cmpxchg +0xFC0, get_tls +0xFE0,
//               version +0xFFC
//
// The first environment is empty except for PATH, HOME and TERM.
//
// Source: Linux 6.1, fs/binfmt_elf.c; Documentation/arm/kernel_user_helpers.rst.
#pragma once

#include <string>
#include <vector>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/elf.h"
#include "sim/linux/address_space.h"

namespace sim {

// Return code for signal handlers without sa_restorer.
constexpr std::uint32_t SIGRETURN_CODE = 0xFFFF0500, RT_SIGRETURN_CODE = 0xFFFF0508;

// The page of helpers; it lasts as long as the core uses it.
class KernelHelpers {
public:
    explicit KernelHelpers(ArmCore& core);
    ~KernelHelpers();
    KernelHelpers(const KernelHelpers&) = delete;
    void connect();  // to the core
    void set_tls(std::uint32_t value);

private:
    ArmCore& core_;
    std::uint8_t* page_;
};

// The program's path in /proc/self/exe and AT_EXECFN: "/collide-linux".
std::string path_of(const ElfProgram& program);

// Maps and fills everything and sets the registers: user mode, pc at the entry, of the interpreter
// if there is one.  Returns the first address after the program, where its heap begins.
// std::runtime_error if it does not fit.
// `interpreter`: of a program that is dynamically linked, or nullptr; it is moved to its place.
// `arguments`: argv; `variables`: envp.
std::uint32_t start_linux_program(ArmCore& core, AddressSpace& memory, const ElfProgram& program,
                                  ElfProgram* interpreter,
                                  const std::vector<std::string>& arguments,
                                  const std::vector<std::string>& variables);

// Of a program that nobody has given another.
const std::vector<std::string>& first_environment();

}  // namespace sim
