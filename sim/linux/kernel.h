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
// Timers of setitimer, alarm and timerfd; /dev/i2c-0; the processor's LED below /sys/class/leds;
// USB devices as input devices and by usbfs (usb_bus.h).
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
#include "sim/linux/own_files.h"
#include "sim/linux/process.h"
#include "sim/linux/scheduler.h"
#include "sim/linux/signals.h"
#include "sim/linux/sockets.h"
#include "sim/linux/start.h"
#include "sim/linux/terminal.h"
#include "sim/linux/thread.h"
#include "sim/linux/timers.h"
#include "sim/linux/uevents.h"
#include "sim/linux/usb_bus.h"
#include "sim/pins/pins.h"

namespace sim {

class UsbFile;

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

    // The board's USB devices, before it boots.
    void plug_in(UsbPorts& ports);

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
    // What answers each: sys_brk(), sys_open() and so on.
#define CALL(name, answer) Result sys_##answer(const Arguments&);
#define ALSO(name, answer)
#include "sim/linux/kernel_calls.def"
#undef ALSO
#undef CALL
    struct Piece {  // of the program's memory
        std::uint32_t address, bytes;
    };

    void boot(ArmCore& core) override;
    void call(ArmCore& core) override;
    void alarm(ArmCore& core) override;
    void exception(ArmCore& core, ArmException, const ArmFault&, const std::string& what) override;

    // kernel_memory.cpp
    std::int64_t map_bus(const Arguments&, std::uint32_t bytes, unsigned access,
                         std::uint32_t page);
    std::int64_t map_shared(const Arguments&, std::uint32_t bytes, unsigned access,
                            std::shared_ptr<SharedMemory> shared, bool as_copy);
    std::int64_t fill_from_file(int fd, std::uint32_t begin, std::uint32_t bytes,
                                std::int64_t offset);
    std::optional<std::uint32_t> place_of(std::uint32_t wish, std::uint32_t bytes,
                                          std::uint32_t flags) const;

    // kernel_files.cpp
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
    std::int64_t change_folder(const std::string& path);
    std::pair<std::int64_t, std::string> path_at(std::uint32_t folder, std::uint32_t address) const;
    std::int64_t give_status(const std::pair<int, FileStatus>& status, std::uint32_t to);
    std::int64_t give_link(const std::string& path, std::uint32_t to, std::uint32_t size);

    // kernel_time.cpp
    static constexpr std::uint64_t NS = 1'000'000'000;                 // per second
    static constexpr std::uint64_t LONGEST_NS = NS * 3600 * 24 * 100;  // SystemC's time is finite
    std::uint64_t used_ns(const LinuxProcess& process) const;          // of the processor
    std::uint64_t used_ns(const LinuxThread& thread) const;
    std::optional<std::uint64_t> clock_ns(std::uint32_t clock) const;
    Result sleep(std::uint32_t flags, std::uint32_t span, bool wide, std::uint32_t left);
    std::int64_t give_time(std::uint32_t to, std::uint64_t ns, bool wide);

    // kernel_timers.cpp
    enum class Span { TIMEVAL, TIMESPEC, TIMESPEC64 };  // struct timeval and so on
    Result timerfd(const Arguments&, Span kind, bool sets);
    std::int64_t set_timer(LinuxTimer& timer, std::uint32_t from, std::uint32_t old, Span kind,
                           bool absolute);
    std::int64_t give_timer(std::uint32_t to, const LinuxTimer& timer, Span kind);
    std::uint64_t next_timer_ns() const;
    void expire_timers();

    // kernel_wait.cpp
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
    Result clone(const Clone& how);
    void end_thread(LinuxThread& thread);
    void restart_sequence();
    LinuxThread* thread_of(std::uint32_t number) const;  // 0: the running one
    std::int64_t set_policy(LinuxThread& thread, int policy, int priority);
    void begin_thread(LinuxThread& child, const Clone& how);

    // kernel_children.cpp
    static constexpr std::uint32_t LEAVES = 0x1000000;  // a child to be waited for again
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
    std::optional<std::string> text_of_process(const LinuxProcess& process,
                                               const std::string& name) const;
    std::optional<std::string> system_text(const std::string& path) const;
    std::uint8_t random_byte();
    std::pair<int, std::shared_ptr<LinuxDevice>> open_system(const std::string& path,
                                                             std::uint32_t flags);
    std::optional<FileStatus> system_status(const std::string& path, bool of_link);
    std::optional<std::string> system_target(const std::string& path) const;
    // The same by a path without links, of what is no folder.
    std::pair<int, std::shared_ptr<LinuxDevice>> open_own(const std::string& path,
                                                          std::uint32_t flags);
    std::optional<FileStatus> status_of_own(const std::string& path);
    OwnFiles own_files() const;
    std::int64_t give_file_system(const std::string& path, std::uint32_t to, bool wide);
    int remove_system(const std::string& path);
    Result give_two(std::uint32_t to, const std::array<int, 2>& numbers);

    // kernel_sockets.cpp
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

    // kernel_usb.cpp
    static constexpr std::uint32_t NETLINK = 16;  // a family of sockets
    Result usb_control(int fd, UsbFile& file, const Arguments&);
    UeventSocket* uevents_at(std::uint32_t fd) const;
    Result uevent_socket(const Arguments&);
    std::int64_t bind_uevents(UeventSocket& socket, const Arguments&);
    std::int64_t name_uevents(const UeventSocket& socket, const Arguments&);
    std::int64_t set_uevents(UeventSocket& socket, const Arguments&);
    Result receive_uevent(std::uint32_t fd, const Arguments&);

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
    std::uint32_t attachments(int segment) const;
    void remove_unused(int segment);
    Result semop(const Arguments&, std::int64_t span);

    // kernel_signals.cpp
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
    sc_core::sc_event woken_;  // something has come from outside
    UeventGroup uevents_;
    UsbBus usb_;
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
