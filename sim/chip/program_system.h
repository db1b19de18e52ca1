// program_system.h - the processor in a chip with its bus, as a run asks for it, whichever it is
#pragma once

#include "sim/cpu/program_cpu.h"
#include "sim/hps/bus.h"

namespace sim {

class ProgramSystem {
public:
    virtual ~ProgramSystem() = default;

    virtual Processor& processor() = 0;
    // The same; null: it runs firmware that is compiled for this machine.
    virtual ProgramCpu* program_cpu() = 0;
    const ProgramCpu* program_cpu() const {
        return const_cast<ProgramSystem*>(this)->program_cpu();
    }
    virtual Bus& processor_bus() = 0;
    const Bus& processor_bus() const { return const_cast<ProgramSystem*>(this)->processor_bus(); }

    // Something that the program has printed may still be on its way to its host; that of a program
    // that has ended.
    virtual bool is_printing() = 0;
    virtual bool is_sending() const { return false; }
    // Lets the access under way end, as SystemC's time goes on, and begins no other.
    virtual void close_bridges() = 0;
    virtual bool is_accessing() const = 0;
};

}  // namespace sim
