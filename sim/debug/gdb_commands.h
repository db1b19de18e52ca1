// gdb_commands.h - the packets of GDB's remote serial protocol, and their answers.
//
//   g G p P       the registers, as the target description names them
//   m M X         memory
//   Hg T qC       whose registers and memory that is; whether a thread is there
//   qXfer:threads qfThreadInfo qsThreadInfo   all threads, with names and what they wait for
//   c C s S vCont go on, all threads together, or until one has executed one instruction; signals
//                 are not delivered, they have no meaning here
//   Z z 0 - 4     breakpoints (0 and 1 alike), watchpoints on write, read, access
//   D k vKill     detach, kill
//   ? Hc qAttached qSupported qXfer:features QStartNoAckMode
//   qRcmd         `monitor`
//   qOffsets      of a program that is position-independent
//
// Everything else gets the empty answer, which means "not known"; a known packet with an error gets
// E01 and changes nothing.  Source: "Debugging with GDB", E.2 and following.
//
// Not handled: a thread that goes on while others stand; Hc, which has no effect on c and s (GDB
// uses vCont); processes as inferiors of GDB.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/debug/gdb_registers.h"

namespace sim {

struct GdbPoint {
    enum Kind { BREAK, WRITE, READ, ACCESS } kind;
    std::uint32_t address, bytes;

    bool operator==(const GdbPoint& other) const {
        return kind == other.kind && address == other.address && bytes == other.bytes;
    }
};

struct GdbThread {
    std::uint32_t number;     // from 1
    std::string name, state;  // of any bytes; "": none
};

// The stopped processor.  Registers and memory are those of the chosen thread: after a stop, of the
// one that has stopped.
class GdbTarget {
public:
    virtual const GdbRegisters& registers() const = 0;
    virtual std::uint64_t reg(unsigned number) = 0;
    // False: it cannot have this value, and keeps its own.
    virtual bool set_reg(unsigned number, std::uint64_t value) = 0;
    // How many bytes, from the first on, were answered by a target.
    virtual std::size_t read(std::uint32_t address, void* data, std::size_t bytes) = 0;
    virtual std::size_t write(std::uint32_t address, const void* data, std::size_t bytes) = 0;
    // Inserting a point that exists, or removing one that does not, changes nothing.
    virtual void insert(const GdbPoint& point) = 0;
    virtual void remove(const GdbPoint& point) = 0;
    virtual std::string stop_reply() = 0;  // "T05...": why it has stopped
    virtual std::string monitor(std::string_view command) = 0;
    // At least one.
    virtual std::vector<GdbThread> threads() { return {{1, "", ""}}; }
    virtual std::uint32_t chosen_thread() { return 1; }
    // One of threads(); 0: the one that has stopped.
    virtual void choose_thread(std::uint32_t) {}
    // By how much the program's addresses are above those of its file.
    virtual std::uint32_t displacement() { return 0; }

protected:
    ~GdbTarget() = default;
};

enum class GdbNext { STAY, CONTINUE, STEP, DETACH, KILL };

struct GdbAnswer {
    std::string text = {};  // none is sent for CONTINUE and STEP: the next stop is the answer
    GdbNext next = GdbNext::STAY;
    std::uint32_t thread = 0;  // of STEP; 0: the one that has stopped
};

GdbAnswer gdb_answer(GdbTarget& target, std::string_view packet);

}  // namespace sim
