// semihosting.h - answers a bare-metal program's requests to a debugger: to print, read, end.
//
// A request is SVC 0x123456, in Thumb code SVC 0xAB: the operation in r0, in r1 its argument or the
// address of its arguments, the result in r0.  ARM's compilers link it by default, GCC with
// --specs=rdimon.specs.  On the board a debugger answers, and without one the program goes no
// further, so the log says so at the first request.
//
// The console is that of the serial line, in both directions.  What is printed is seen at once, but
// the program waits where a line of 115,200 baud would have more than 4,096 characters before it.
// Time is the simulated time since power-on; the calendar begins in 1970.
//
// Only the console can be opened, ":tt".  What is asked for besides, other files above all, fails
// and is named in the log, each operation once.
//
// Source: Arm, Semihosting for AArch32 and AArch64, 2023Q3.
//
// Not handled: files and commands of this machine; BKPT 0xAB, of M-profile processors.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/cpu/arm_cpu.h"
#include "sim/linux/terminal.h"

namespace sim {

class Semihosting {
public:
    struct Outside {
        std::function<void(char)> print;
        std::function<void(const std::string&)> log;
    };
    // Attaches itself to the processor.
    Semihosting(ArmCpu& cpu, Outside outside);

    // At the console.
    Terminal& terminal() { return terminal_; }
    const Terminal& terminal() const { return terminal_; }

    // The program's, once it has ended itself by a request.
    std::optional<int> exit_code() const { return exit_code_; }

private:
    // `argument` is r1; returns the new r0.
    struct Operation {
        std::uint32_t number;
        const char* name;
        std::uint32_t (Semihosting::*answer)(std::uint32_t argument);
    };
    static const std::vector<Operation>& operations();

    std::uint32_t sys_open(std::uint32_t);
    std::uint32_t sys_close(std::uint32_t);
    std::uint32_t sys_writec(std::uint32_t);
    std::uint32_t sys_write0(std::uint32_t);
    std::uint32_t sys_write(std::uint32_t);
    std::uint32_t sys_read(std::uint32_t);
    std::uint32_t sys_readc(std::uint32_t);
    std::uint32_t sys_iserror(std::uint32_t);
    std::uint32_t sys_istty(std::uint32_t);
    std::uint32_t sys_seek(std::uint32_t);
    std::uint32_t sys_flen(std::uint32_t);
    std::uint32_t sys_clock(std::uint32_t);
    std::uint32_t sys_time(std::uint32_t);
    std::uint32_t sys_errno(std::uint32_t);
    std::uint32_t sys_get_cmdline(std::uint32_t);
    std::uint32_t sys_heapinfo(std::uint32_t);
    std::uint32_t sys_exit(std::uint32_t);
    std::uint32_t sys_exit_extended(std::uint32_t);
    std::uint32_t sys_elapsed(std::uint32_t);
    std::uint32_t sys_tickfreq(std::uint32_t);

    void answer(ArmCore& core);
    std::uint32_t answer(std::uint32_t number, std::uint32_t argument);
    std::uint32_t fail(int error);
    void log(const std::string& what) const;
    void log_once(std::uint32_t operation, const std::string& what);
    void print(std::uint8_t c);
    void end(std::uint32_t reason, std::uint32_t code);
    std::uint64_t parts_of_a_second(std::uint32_t parts) const;  // since power-on

    // The program's memory.
    std::uint32_t word(std::uint32_t address) const;
    std::uint8_t byte(std::uint32_t address) const;
    void put(std::uint32_t address, const void* data, std::size_t bytes);

    ArmCpu& cpu_;
    const Outside outside_;
    Terminal terminal_;
    sc_core::sc_time line_free_;        // when the console's line has taken all that was printed
    std::uint32_t features_place_ = 0;  // in the file that says what is offered
    int error_ = 0;                     // errno
    bool asked_ = false;                // the first request was made
    std::set<std::uint32_t> logged_;    // operations
    std::optional<int> exit_code_;
};

}  // namespace sim
