// program_cpu.h - a processor that runs an ELF, as those ask it who watch a run: where the program
// is, what it has done, whether it is over.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/cpu/elf.h"
#include "sim/cpu/processor.h"

namespace sim {

class ProgramCpu : public Processor {
public:
    struct Position {
        std::uint32_t pc;
        std::string function;                 // "main+0x10", "" if it is in none
        bool sleeping;                        // in WFI, or in pause()
        bool ended;                           // by end()
        std::optional<std::uint32_t> polled;  // a register that a loop reads
    };
    virtual Position position() = 0;

    struct Counts {
        std::uint64_t instructions = 0;
        std::uint64_t interrupts = 0;  // taken
        std::uint64_t aborts = 0;      // taken: data and prefetch, access faults
        sc_core::sc_time asleep;       // in WFI and WFE
        sc_core::sc_time on_bus;       // waiting for targets, and for registers to change
    };
    virtual Counts counts() const = 0;

    virtual const ElfProgram& elf() const = 0;
    // Clocks per instruction, as the run's options have it.
    virtual double cpi() const = 0;
    // The program's time: SystemC's plus what it has run of its quantum.
    virtual sc_core::sc_time now() const = 0;
    // The address of the instruction that is using the bus, if one is.
    virtual std::uint32_t instruction() const = 0;
    // How long the program has been over; 0 before.
    virtual sc_core::sc_time ended_for() const = 0;
    // At the run's end: logs what is not reported yet.  position() stays.
    virtual void conclude() = 0;

    // For a debugger and for reports: reads as the program would, RAM and registers alike, in no
    // time.  False: no target answers.
    virtual bool read_memory(std::uint32_t address, void* data, unsigned bytes) = 0;
    virtual bool write_memory(std::uint32_t address, const void* data, unsigned bytes) = 0;
    // Ends what the program waits in, as a debug event does.
    virtual void wake() = 0;

protected:
    using Processor::Processor;
};

}  // namespace sim
