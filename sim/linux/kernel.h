// kernel.h - the Linux kernel's user interface for a program of 32 bits.
//
// The simulator executes system calls, like gem5's syscall emulation.  The program itself runs on
// the modelled processor in user mode, and accesses registers by mapping /dev/mem.
//
// Time is the simulated time since power-on, the same on all clocks; CLOCK_REALTIME therefore
// begins in 1970.  A system call takes 1 us, about as on the board; sleeping lets simulated time
// pass, and so does printing more than the console's line of 115,200 baud has taken away.
// Process number 1, user 0, AT_RANDOM and getrandom from a fixed seed: every run is identical.
//
// A wrong access is SIGSEGV, an access without a target on the bus is SIGBUS, and so on: the
// program's handler is called, or without one the program ends.  Such an end and an exit code other
// than 0 are faults of the processor (ArmCpu::fault()), reported in one line.  A call that is not
// emulated is reported once in the log and returns ENOSYS; see missing().  ioctl returns ENOTTY,
// except for the settings of the console, which is a terminal.
//
// A call that has to wait says what for and what ends that (LinuxWait); time passes when all
// threads wait.  A signal comes at its exact time, also into a loop.  ^C, ^\ and ^Z at the terminal
// send theirs; there is no shell, so a program that ^Z has stopped stays so.
//
// Threads share one processor (scheduler.h), although the program is shown two, as on the board.
// When all wait for each other for ever, the program ends by a fault that says who waits for whom.
//
// Processes take turns in the core: each has its memory (address_space.h), and what the core has
// translated is translated again after a switch from one to another.  The end of the first ends the
// run.  A program that another becomes is itself, or lies under the root.
//
// Timers of setitimer, alarm and timerfd; /dev/i2c-0; the processor's LED below /sys/class/leds.
//
// Not handled: timer_create, ITIMER_VIRTUAL and ITIMER_PROF, GPIO below /sys, message queues,
// groups and sessions of processes, job control; mutexes with priority inheritance; the
// second processor: threads never run at the same time; no vDSO, so that the C library makes system
// calls.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/cpu/arm_cpu.h"
#include "sim/linux/address_space.h"
#include "sim/linux/files.h"
#include "sim/linux/input.h"
#include "sim/linux/loader.h"
#include "sim/linux/process.h"
#include "sim/linux/scheduler.h"
#include "sim/linux/signals.h"
#include "sim/linux/sockets.h"
#include "sim/linux/start.h"
#include "sim/linux/terminal.h"
#include "sim/linux/thread.h"
#include "sim/linux/timers.h"
#include "sim/pins/pins.h"

namespace sim {

struct LinuxSettings {
    std::filesystem::path root;          // the program's /; empty: it has no files
    std::vector<std::string> arguments;  // after the program's name
    std::filesystem::path input;         // standard input; empty: the console
};

class LinuxKernel final : public ArmKernel {
public:
    struct Outside {
        std::function<void(char)> console;
        std::function<void(const std::string&)> log;
        // A register on the bus, for drivers; false: refused.
        std::function<bool(bool write, std::uint32_t address, std::uint32_t& value)> access;
        I2cDevices* i2c0;  // what /dev/i2c-0 has; may be none
    };

    // Attaches itself.  std::runtime_error if the root cannot be opened.
    LinuxKernel(ArmCpu& cpu, LinuxSettings settings, Outside outside);

    // At the console.
    Terminal& terminal() { return terminal_; }
    const Terminal& terminal() const { return terminal_; }

    // What hands do with its keyboard and mouse.
    LinuxInput& input() { return input_; }

    // "clone, 2 times; pipe2": calls that returned ENOSYS because they are not emulated, or "".
    std::string missing() const;

    // The program's, once it has called exit; or as a shell has it, if ^C or ^\ has ended it.
    std::optional<int> exit_code() const { return exit_code_; }

    // What it waits for, "standard input"; or "".
    std::string waiting() const;

private:
    // Of a system call: r0 - r6, and the new r0; without a value the registers stay unchanged.
    using Arguments = std::array<std::uint32_t, 7>;
    using Result = std::optional<std::int64_t>;
    struct Call {
        std::uint32_t number;
        Result (LinuxKernel::*answer)(const Arguments&);
    };
    static const std::vector<Call>& calls();
    struct Piece {  // of the program's memory
        std::uint32_t address, bytes;
    };

    void boot(ArmCore& core) override;
    void call(ArmCore& core) override;
    void alarm(ArmCore& core) override;
    void exception(ArmCore& core, ArmException, const ArmFault&, const std::string& what) override;

    // kernel_memory.cpp
    Result sys_brk(const Arguments&);
    Result sys_mmap2(const Arguments&);
    Result sys_munmap(const Arguments&);
    Result sys_mprotect(const Arguments&);
    Result sys_mremap(const Arguments&);
    Result sys_cacheflush(const Arguments&);
    std::int64_t map_bus(const Arguments&, std::uint32_t bytes, unsigned access,
                         std::uint32_t page);
    std::int64_t map_shared(const Arguments&, std::uint32_t bytes, unsigned access,
                            std::shared_ptr<SharedMemory> shared, bool as_copy);
    std::int64_t fill_from_file(int fd, std::uint32_t begin, std::uint32_t bytes,
                                std::int64_t offset);
    std::optional<std::uint32_t> place_of(std::uint32_t wish, std::uint32_t bytes,
                                          std::uint32_t flags) const;

    // kernel_files.cpp
    Result sys_open(const Arguments&);
    Result sys_openat(const Arguments&);
    Result sys_creat(const Arguments&);
    Result sys_close(const Arguments&);
    Result sys_getdents64(const Arguments&);
    Result sys_read(const Arguments&);
    Result sys_write(const Arguments&);
    Result sys_readv(const Arguments&);
    Result sys_writev(const Arguments&);
    Result sys_pread64(const Arguments&);
    Result sys_pwrite64(const Arguments&);
    Result sys_lseek(const Arguments&);
    Result sys_llseek(const Arguments&);
    Result sys_ftruncate64(const Arguments&);
    Result sys_ftruncate(const Arguments&);
    Result sys_fsync(const Arguments&);
    Result sys_dup(const Arguments&);
    Result sys_dup2(const Arguments&);
    Result sys_fcntl(const Arguments&);
    Result sys_ioctl(const Arguments&);
    std::int64_t open(std::uint32_t folder, std::uint32_t path, std::uint32_t flags,
                      std::uint32_t mode);
    Result read(int fd, std::vector<Piece> pieces);
    Result write(int fd, std::vector<Piece> pieces);
    std::int64_t print(int fd, const std::uint8_t* from, std::uint32_t count, LinuxWait& wait);
    std::int64_t pieces_at(std::uint32_t list, std::uint32_t count,
                           std::vector<Piece>& pieces) const;
    std::pair<std::uint8_t*, std::uint32_t> part(const std::vector<Piece>& pieces,
                                                 std::int64_t done, unsigned access) const;

    // kernel_names.cpp
    Result sys_fstat64(const Arguments&);
    Result sys_stat64(const Arguments&);
    Result sys_lstat64(const Arguments&);
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
    Result sys_fchdir(const Arguments&);
    std::int64_t change_folder(const std::string& path);
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
    std::uint64_t used_ns(const LinuxProcess& process) const;  // of the processor
    std::uint64_t used_ns(const LinuxThread& thread) const;
    std::optional<std::uint64_t> clock_ns(std::uint32_t clock) const;
    Result sleep(std::uint32_t flags, std::uint32_t span, bool wide, std::uint32_t left);
    std::int64_t give_time(std::uint32_t to, std::uint64_t ns, bool wide);

    // kernel_timers.cpp
    Result sys_setitimer(const Arguments&);
    Result sys_getitimer(const Arguments&);
    Result sys_timerfd_create(const Arguments&);
    Result sys_timerfd_settime(const Arguments&);
    Result sys_timerfd_settime64(const Arguments&);
    Result sys_timerfd_gettime(const Arguments&);
    Result sys_timerfd_gettime64(const Arguments&);
    enum class Span { TIMEVAL, TIMESPEC, TIMESPEC64 };  // struct timeval and so on
    Result timerfd(const Arguments&, Span kind, bool sets);
    std::int64_t set_timer(LinuxTimer& timer, std::uint32_t from, std::uint32_t old, Span kind,
                           bool absolute);
    std::int64_t give_timer(std::uint32_t to, const LinuxTimer& timer, Span kind);
    std::uint64_t next_timer_ns() const;
    void expire_timers();

    // kernel_wait.cpp
    Result sys_select(const Arguments&);
    Result sys_pselect6(const Arguments&);
    Result sys_pselect6_time64(const Arguments&);
    Result sys_poll(const Arguments&);
    Result sys_ppoll(const Arguments&);
    Result sys_ppoll_time64(const Arguments&);
    Result sys_epoll_create(const Arguments&);
    Result sys_epoll_create1(const Arguments&);
    Result sys_epoll_ctl(const Arguments&);
    Result sys_epoll_wait(const Arguments&);
    Result sys_epoll_pwait(const Arguments&);
    std::int64_t span_at(std::uint32_t address, Span kind) const;
    void give_span(std::uint32_t address, Span kind, std::uint64_t ns);
    void name_source(std::string& what, int fd) const;
    Result select(const Arguments&, Span kind);
    Result poll(std::uint32_t list, std::uint32_t count, std::int64_t span_ns);

    // kernel_futex.cpp
    struct FutexKey {  // a word, and whose
        const void* space;
        std::uint64_t address;
        bool operator!=(const FutexKey& o) const { return !(*this == o); }
        bool operator==(const FutexKey& o) const {
            return space == o.space && address == o.address;
        }
    };
    struct FutexWaiter {
        LinuxThread* thread;
        FutexKey key;
        std::uint32_t bits, address;
    };
    Result sys_futex(const Arguments&);
    Result sys_futex_time64(const Arguments&);
    Result sys_set_robust_list(const Arguments&);
    Result sys_get_robust_list(const Arguments&);
    FutexKey futex_key(std::uint32_t address) const;
    std::int64_t futex_wake(const FutexKey& key, std::uint32_t most, std::uint32_t bits);
    Result futex_wait(std::uint32_t address, std::uint32_t value, std::uint32_t bits,
                      std::uint64_t end_ns);
    Result futex_requeue(const Arguments&, bool compare);
    Result futex_wake_op(const Arguments&);
    Result futex(const Arguments&, Span kind);
    void give_back_locks(const LinuxThread& thread);
    std::string awaited(const LinuxThread& thread) const;
    bool is_deadlock() const;

    // kernel_threads.cpp
    struct Clone {
        std::uint64_t flags;
        std::uint32_t stack, parent_word, tls, child_word;
    };
    Result sys_clone(const Arguments&);
    Result sys_clone3(const Arguments&);
    Result sys_exit(const Arguments&);
    Result sys_exit_group(const Arguments&);
    Result sys_set_tls(const Arguments&);
    Result sys_set_tid_address(const Arguments&);
    Result sys_gettid(const Arguments&);
    Result sys_rseq(const Arguments&);
    Result sys_sched_yield(const Arguments&);
    Result sys_sched_getaffinity(const Arguments&);
    Result sys_sched_setaffinity(const Arguments&);
    Result sys_getcpu(const Arguments&);
    Result sys_sched_setscheduler(const Arguments&);
    Result sys_sched_getscheduler(const Arguments&);
    Result sys_sched_setparam(const Arguments&);
    Result sys_sched_getparam(const Arguments&);
    Result sys_sched_get_priority_max(const Arguments&);
    Result sys_sched_get_priority_min(const Arguments&);
    Result sys_sched_rr_get_interval(const Arguments&);
    Result sys_nice(const Arguments&);
    Result sys_getpriority(const Arguments&);
    Result sys_setpriority(const Arguments&);
    Result sys_prctl(const Arguments&);
    Result clone(const Clone& how);
    void end_thread(LinuxThread& thread);
    void restart_sequence();
    LinuxThread* thread_of(std::uint32_t number) const;  // 0: the running one
    std::int64_t set_policy(LinuxThread& thread, int policy, int priority);
    void begin_thread(LinuxThread& child, const Clone& how);

    // kernel_children.cpp
    static constexpr std::uint32_t LEAVES = 0x1000000;  // a child to be waited for again
    Result sys_fork(const Arguments&);
    Result sys_vfork(const Arguments&);
    Result sys_execve(const Arguments&);
    Result sys_wait4(const Arguments&);
    Result sys_waitid(const Arguments&);
    Result fork(const Clone& how);
    void end_process(LinuxProcess& process, std::uint32_t status);
    LinuxProcess* process_of(int number) const;
    void forget(LinuxProcess& process);
    Result wait_for_child(std::int32_t which, std::uint32_t options,
                          std::function<std::int64_t(const LinuxProcess&)> result_of);
    std::optional<std::vector<std::string>> strings_at(std::uint32_t list) const;
    Result become(const ElfProgram& program, std::optional<ElfProgram> interpreter,
                  const std::string& path, const std::vector<std::string>& arguments,
                  const std::vector<std::string>& variables);

    // kernel_system.cpp
    std::shared_ptr<LinuxDevice> hps_led();
    Result sys_pipe(const Arguments&);
    Result sys_pipe2(const Arguments&);
    Result sys_eventfd(const Arguments&);
    Result sys_eventfd2(const Arguments&);
    Result sys_memfd_create(const Arguments&);
    Result sys_link(const Arguments&);
    std::optional<std::string> text_of_process(const LinuxProcess& process,
                                               const std::string& name) const;
    std::optional<std::string> system_text(const std::string& path) const;
    std::uint8_t random_byte();
    std::pair<int, std::shared_ptr<LinuxDevice>> open_system(const std::string& path,
                                                             std::uint32_t flags);
    std::optional<FileStatus> system_status(const std::string& path);
    int remove_system(const std::string& path);
    Result give_two(std::uint32_t to, const std::array<int, 2>& numbers);

    // kernel_sockets.cpp
    Result sys_socket(const Arguments&);
    Result sys_socketpair(const Arguments&);
    Result sys_bind(const Arguments&);
    Result sys_listen(const Arguments&);
    Result sys_getsockname(const Arguments&);
    Result sys_getpeername(const Arguments&);
    Result sys_connect(const Arguments&);
    Result sys_accept(const Arguments&);
    Result sys_accept4(const Arguments&);
    Result sys_shutdown(const Arguments&);
    Result sys_send(const Arguments&);
    Result sys_sendto(const Arguments&);
    Result sys_sendmsg(const Arguments&);
    Result sys_recv(const Arguments&);
    Result sys_recvfrom(const Arguments&);
    Result sys_recvmsg(const Arguments&);
    Result sys_setsockopt(const Arguments&);
    Result sys_getsockopt(const Arguments&);
    static int check_socket(std::uint32_t family, std::uint32_t type, std::uint32_t protocol);
    LinuxSocket* socket_at(std::uint32_t fd, int& error) const;
    std::int64_t address_at(std::uint32_t at, std::uint32_t bytes, SocketAddress& address) const;
    std::int64_t give_address(const SocketAddress& address, std::uint32_t to,
                              std::uint32_t length_at);
    bool is_reachable(const SocketAddress& address);
    bool does_not_wait(std::uint32_t fd) const;
    Result send_to(std::uint32_t fd, const std::vector<Piece>& pieces, std::uint32_t flags,
                   const std::optional<SocketAddress>& to);
    Result receive_from(std::uint32_t fd, std::vector<Piece> pieces, std::uint32_t flags,
                        std::uint32_t name, std::uint32_t length_at, std::uint32_t header);

    // kernel_ipc.cpp
    struct Segment {
        std::uint32_t key, rights;
        std::shared_ptr<SharedMemory> memory;
        int maker;
        bool removed = false;
    };
    struct Semaphores {
        std::uint32_t key, rights;
        std::vector<std::uint16_t> values;
        bool removed = false;
    };
    Result sys_shmget(const Arguments&);
    Result sys_shmat(const Arguments&);
    Result sys_shmdt(const Arguments&);
    Result sys_shmctl(const Arguments&);
    Result sys_semget(const Arguments&);
    Result sys_semctl(const Arguments&);
    Result sys_semop(const Arguments&);
    Result sys_semtimedop(const Arguments&);
    Result sys_semtimedop_time64(const Arguments&);
    std::uint32_t attachments(int segment) const;
    void remove_unused(int segment);
    Result semop(const Arguments&, std::int64_t span);

    // kernel_process.cpp
    Result sys_uname(const Arguments&);
    Result sys_getrandom(const Arguments&);
    Result sys_prlimit64(const Arguments&);
    Result sys_getrlimit(const Arguments&);
    Result sys_getrusage(const Arguments&);
    Result sys_umask(const Arguments&);
    Result sys_done(const Arguments&);  // answers 0
    Result sys_getpid(const Arguments&);
    Result sys_getppid(const Arguments&);
    Result sys_sysinfo(const Arguments&);

    // kernel_signals.cpp
    Result sys_sigaction(const Arguments&);
    Result sys_sigprocmask(const Arguments&);
    Result sys_sigpending(const Arguments&);
    Result sys_sigsuspend(const Arguments&);
    Result sys_sigtimedwait(const Arguments&);
    Result sys_sigtimedwait_time64(const Arguments&);
    Result sys_sigqueueinfo(const Arguments&);
    Result sys_sigaltstack(const Arguments&);
    Result sys_sigreturn(const Arguments&);
    Result sys_rt_sigreturn(const Arguments&);
    Result sys_kill(const Arguments&);
    Result sys_tkill(const Arguments&);
    Result sys_tgkill(const Arguments&);
    Result sys_pause(const Arguments&);
    std::int64_t mask_meanwhile(std::uint32_t address, std::uint32_t bytes);
    Result sigtimedwait(const Arguments&, Span kind);
    void unaligned(ArmCore& core, const ArmFault& fault, const std::string& what);
    // By an instruction of the running thread, so it cannot be blocked.
    void fault(unsigned number, std::uint32_t address, const std::string& why);
    // To any thread of it, or to this one; false: too many are pending.
    bool send(LinuxProcess& process, const LinuxSignal& signal);
    bool send(LinuxThread& thread, const LinuxSignal& signal);
    void typed(unsigned number);
    // Which of the signals would end what it waits for.
    std::uint64_t wakes(const LinuxThread& thread) const;
    void interrupt(LinuxThread& thread);
    void deliver();  // to the running thread
    void die(const LinuxSignal& signal);

    // kernel_schedule.cpp
    std::uint64_t now_ns() const;
    std::uint64_t later_ns(std::uint64_t span_ns) const;  // so long after now, not before that
    Result wait(LinuxWait wait);  // of the running thread, or what it waits for at once
    void resume(LinuxThread& thread, std::optional<std::int64_t> result);
    void look(LinuxThread& thread);
    void look_at_all();
    bool any_waits() const;
    void suspend();  // the running thread waits, or has ended, or makes way
    void go_on();    // with the one that is to run now, when time has come for one
    void account();
    std::uint64_t next_event_ns() const;
    std::string waiting_list() const;  // of each thread
    void run(LinuxThread& thread);
    void stand_still();
    void on_input();
    void feel();

    void not_emulated(const std::string& what);
    // By number, "" if there is none; from the kernel's own header.
    static const char* name_of(std::uint32_t number);

    AddressSpace& memory() const { return *process_->memory; }
    LinuxFiles& files() const { return process_->files; }
    std::vector<LinuxThread*> threads() const;  // of all processes

    ArmCpu& cpu_;
    const LinuxSettings settings_;
    const Outside outside_;
    KernelHelpers helpers_;
    LinuxLoader loader_;
    Terminal terminal_;
    LinuxInput input_;
    LinuxNetwork network_;
    bool unreachable_reported_ = false;
    std::vector<std::unique_ptr<LinuxProcess>> processes_;
    LinuxProcess* process_ = nullptr;   // which a call is about
    LinuxThread* running_ = nullptr;    // whose registers the core has
    AddressSpace* attached_ = nullptr;  // that the core sees
    LinuxScheduler scheduler_;
    std::list<FutexWaiter> waiters_;  // in their order
    int next_number_ = 2;             // of a process or thread
    std::uint64_t since_ns_ = 0;      // when the running one was accounted
    bool yields_ = false;             // the running one, by its own will
    bool changed_ = false;            // files, so that a thread may go on
    bool over_ = false;
    sc_core::sc_event woken_;     // something has come from outside
    sc_core::sc_time line_free_;  // when the console's line has taken all that was printed
    std::uint64_t random_;
    std::map<std::string, std::shared_ptr<SharedMemory>> shared_files_;  // of /dev/shm
    std::map<int, Segment> segments_;
    std::map<int, Semaphores> semaphores_;
    int next_ipc_ = 0;
    std::set<std::uint32_t> unaligned_;        // instructions that are in the log
    std::map<std::string, unsigned> missing_;  // calls that are not emulated, how often
    std::vector<std::weak_ptr<LinuxTimerFile>> timer_files_;
    std::set<std::string> named_files_;  // of the system, that are not there
    std::optional<int> exit_code_;
};

}  // namespace sim
