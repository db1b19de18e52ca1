// kernel.h - the Linux kernel's user interface for one program: static, single-threaded, 32 bits.
//
// The simulator executes system calls, like gem5's syscall emulation.  The program itself runs on
// the modelled processor in user mode, and accesses registers by mapping /dev/mem.
//
// Time is the simulated time since power-on, the same on all clocks; CLOCK_REALTIME therefore
// begins in 1970.  A system call takes only the time of its instruction; sleeping lets simulated
// time pass, and so does printing more than the console's line of 115,200 baud has taken away.
// Process number 1, user 0, AT_RANDOM and getrandom from a fixed seed: every run is identical.
//
// A wrong access is SIGSEGV, an access without a target on the bus is SIGBUS, and so on: the
// program's handler is called, or without one the program ends.  Such an end and an exit code other
// than 0 are faults of the processor (ArmCpu::fault()), reported in one line.  A call that is not
// emulated is reported once in the log and returns ENOSYS; see missing().  ioctl returns ENOTTY,
// except for the settings of the console, which is a terminal.
//
// Not handled: threads, processes, timers that signal, job control; VFP registers are not saved for
// a signal's handler; no vDSO, so that the C library makes system calls.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/cpu/arm_cpu.h"
#include "sim/linux/address_space.h"
#include "sim/linux/files.h"
#include "sim/linux/signals.h"
#include "sim/linux/start.h"
#include "sim/linux/terminal.h"

namespace sim {

struct LinuxSettings {
    std::filesystem::path root;          // the program's /; empty: it has no files
    std::vector<std::string> arguments;  // after the program's name
    std::filesystem::path input;         // standard input; empty: the console
};

// Where a Linux program may lie.
const std::vector<MemoryRange>& linux_memory();

class LinuxKernel final : public ArmKernel {
public:
    struct Outside {
        std::function<void(char)> console;
        std::function<void(const std::string&)> log;
    };

    // Attaches itself.  std::runtime_error if the root cannot be opened.
    LinuxKernel(ArmCpu& cpu, LinuxSettings settings, Outside outside);

    // At the console.
    Terminal& terminal() { return terminal_; }
    const Terminal& terminal() const { return terminal_; }

    // "clone, 2 times; pipe2": calls that returned ENOSYS because they are not emulated, or "".
    std::string missing() const;

    // The program's, once it has called exit.
    std::optional<int> exit_code() const { return exit_code_; }

private:
    // Of a system call: r0 - r6, and the new r0; without a value the registers stay unchanged.
    using Arguments = std::array<std::uint32_t, 7>;
    using Result = std::optional<std::int64_t>;
    struct Call {
        std::uint32_t number;
        Result (LinuxKernel::*answer)(const Arguments&);
    };
    static const std::vector<Call>& calls();

    void boot(ArmCore& core) override;
    void call(ArmCore& core) override;
    void exception(ArmCore& core, ArmException, const ArmFault&, const std::string& what) override;

    // kernel_memory.cpp
    Result sys_brk(const Arguments&);
    Result sys_mmap2(const Arguments&);
    Result sys_munmap(const Arguments&);
    Result sys_mprotect(const Arguments&);
    Result sys_mremap(const Arguments&);
    Result sys_cacheflush(const Arguments&);
    std::int64_t map_bus(const Arguments&, std::uint32_t bytes, unsigned access);
    std::int64_t fill_from_file(int fd, std::uint32_t begin, std::uint32_t bytes,
                                std::int64_t offset);
    std::optional<std::uint32_t> place_of(std::uint32_t wish, std::uint32_t bytes,
                                          std::uint32_t flags) const;

    // kernel_files.cpp
    Result sys_open(const Arguments&);
    Result sys_openat(const Arguments&);
    Result sys_creat(const Arguments&);
    Result sys_close(const Arguments&);
    Result sys_read(const Arguments&);
    Result sys_write(const Arguments&);
    Result sys_readv(const Arguments&);
    Result sys_writev(const Arguments&);
    Result sys_pread64(const Arguments&);
    Result sys_pwrite64(const Arguments&);
    Result sys_lseek(const Arguments&);
    Result sys_llseek(const Arguments&);
    Result sys_ftruncate64(const Arguments&);
    Result sys_fsync(const Arguments&);
    Result sys_dup(const Arguments&);
    Result sys_dup2(const Arguments&);
    Result sys_fcntl(const Arguments&);
    Result sys_ioctl(const Arguments&);
    std::int64_t open(std::uint32_t folder, std::uint32_t path, std::uint32_t flags,
                      std::uint32_t mode);
    std::int64_t each_vector(const Arguments&, bool write);
    std::int64_t print(int fd, const std::uint8_t* from, std::uint32_t count);

    // kernel_names.cpp
    Result sys_fstat64(const Arguments&);
    Result sys_stat64(const Arguments&);
    Result sys_fstatat64(const Arguments&);
    Result sys_statx(const Arguments&);
    Result sys_access(const Arguments&);
    Result sys_faccessat(const Arguments&);
    Result sys_unlink(const Arguments&);
    Result sys_unlinkat(const Arguments&);
    Result sys_rmdir(const Arguments&);
    Result sys_mkdir(const Arguments&);
    Result sys_mkdirat(const Arguments&);
    Result sys_rename(const Arguments&);
    Result sys_renameat(const Arguments&);
    Result sys_readlink(const Arguments&);
    Result sys_readlinkat(const Arguments&);
    Result sys_getcwd(const Arguments&);
    Result sys_chdir(const Arguments&);
    std::pair<std::int64_t, std::string> path_at(std::uint32_t folder, std::uint32_t address) const;
    std::int64_t give_status(const std::pair<int, FileStatus>& status, std::uint32_t to);
    std::int64_t give_link(const std::string& path, std::uint32_t to, std::uint32_t size);

    // kernel_time.cpp
    static constexpr std::uint64_t NS = 1'000'000'000;                 // per second
    static constexpr std::uint64_t LONGEST_NS = NS * 3600 * 24 * 100;  // SystemC's time is finite
    Result sys_clock_gettime(const Arguments&);
    Result sys_clock_gettime64(const Arguments&);
    Result sys_clock_getres(const Arguments&);
    Result sys_clock_getres_time64(const Arguments&);
    Result sys_gettimeofday(const Arguments&);
    Result sys_times(const Arguments&);
    Result sys_nanosleep(const Arguments&);
    Result sys_clock_nanosleep(const Arguments&);
    Result sys_clock_nanosleep_time64(const Arguments&);
    Result sys_futex(const Arguments&);
    Result sys_pause(const Arguments&);
    std::uint64_t now_ns() const;
    std::int64_t sleep(std::uint32_t flags, std::uint32_t span, bool wide, std::uint32_t left);
    std::int64_t give_time(std::uint32_t to, std::uint64_t ns, bool wide);

    // kernel_wait.cpp
    Result sys_select(const Arguments&);
    Result sys_pselect6(const Arguments&);
    Result sys_pselect6_time64(const Arguments&);
    Result sys_poll(const Arguments&);
    Result sys_ppoll(const Arguments&);
    Result sys_ppoll_time64(const Arguments&);
    enum class Span { TIMEVAL, TIMESPEC, TIMESPEC64 };  // struct timeval and so on
    std::int64_t span_at(std::uint32_t address, Span kind) const;
    void give_span(std::uint32_t address, Span kind, std::uint64_t ns);
    std::pair<std::int64_t, std::uint64_t> wait_for(std::int64_t span_ns, bool at_console,
                                                    const std::function<std::int64_t()>& look);
    bool is_readable(int fd) const;
    std::int64_t select(const Arguments&, Span kind);
    std::int64_t poll(std::uint32_t list, std::uint32_t count, std::int64_t span_ns);

    // kernel_process.cpp
    Result sys_exit(const Arguments&);
    Result sys_set_tls(const Arguments&);
    Result sys_rseq(const Arguments&);
    Result sys_uname(const Arguments&);
    Result sys_getrandom(const Arguments&);
    Result sys_prlimit64(const Arguments&);
    Result sys_getrlimit(const Arguments&);
    Result sys_getrusage(const Arguments&);
    Result sys_sysinfo(const Arguments&);
    Result sys_sched_getaffinity(const Arguments&);
    Result sys_umask(const Arguments&);
    Result sys_done(const Arguments&);     // answers 0
    Result sys_process(const Arguments&);  // the number of process and thread
    Result sys_sigaction(const Arguments&);
    Result sys_sigprocmask(const Arguments&);
    Result sys_sigaltstack(const Arguments&);
    Result sys_sigreturn(const Arguments&);
    Result sys_rt_sigreturn(const Arguments&);
    Result sys_kill(const Arguments&);
    Result sys_tgkill(const Arguments&);
    // Calls the handler, or ends the program.  `forced`: caused by its own instruction, so it
    // cannot be blocked.
    void unaligned(ArmCore& core, const ArmFault& fault, const std::string& what);
    void signal(unsigned number, std::uint32_t address, const std::string& why, bool forced);
    void deliver_pending();

    // By number, "" if there is none; from the kernel's own header.
    static const char* name_of(std::uint32_t number);

    ArmCpu& cpu_;
    const LinuxSettings settings_;
    const Outside outside_;
    AddressSpace memory_;
    KernelHelpers helpers_;
    Terminal terminal_;
    LinuxFiles files_;
    LinuxSignals signals_;
    std::uint32_t break_begin_ = 0, break_ = 0;
    sc_core::sc_time line_free_;  // when the console's line has taken all that was printed
    std::uint64_t random_;
    std::uint32_t umask_ = 022;
    std::set<std::uint32_t> unaligned_;        // instructions of which the log was told
    std::map<std::string, unsigned> missing_;  // calls that are not emulated, how often
    std::set<std::string> named_files_;        // of the system, that are not there
    std::optional<int> exit_code_;
};

}  // namespace sim
