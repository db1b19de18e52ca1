// kernel.h - the Linux kernel's user interface for a program of 32 bits.
//
// The simulator executes system calls, like gem5's syscall emulation.  The program itself runs on
// the modelled processor in user mode, and accesses registers by mapping /dev/mem.
//
// Time is the simulated time since power-on, the same on all clocks; CLOCK_REALTIME therefore
// begins in 1970.  A system call takes 1 us, about as on the board; sleeping lets simulated time
// pass, and so does printing more than the console's line of 115,200 baud has taken away.
// The first process is number 101, of user 0; random bytes are by a fixed seed: runs without
// --network are identical.
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
// Timers of setitimer, alarm, timer_create and timerfd; /dev/i2c-0; the processor's pins and LED
// (gpio.h, led.h); USB devices (usb_bus.h); kernel modules (modules.h).
//
// Not handled: /dev/spidev (the DE1-SoC's device tree for Linux has no SPI device); job control;
// owners of files other than root; mutexes with priority inheritance; the second processor: threads
// never run at the same time; no vDSO; a program may access a module's memory.  Timers of processor
// time expire when they are due, not by a tick of 10 ms; a process's time in the kernel is its own.
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
#include "sim/hps/pixel_buffer.h"
#include "sim/linux/address_space.h"
#include "sim/linux/files.h"
#include "sim/linux/gpio.h"
#include "sim/linux/host_sockets.h"
#include "sim/linux/input.h"
#include "sim/linux/ipc.h"
#include "sim/linux/ipc_messages.h"
#include "sim/linux/led.h"
#include "sim/linux/linux_settings.h"
#include "sim/linux/loader.h"
#include "sim/linux/message_queues.h"
#include "sim/linux/modules.h"
#include "sim/linux/own_files.h"
#include "sim/linux/process.h"
#include "sim/linux/scheduler.h"
#include "sim/linux/signals.h"
#include "sim/linux/start.h"
#include "sim/linux/terminal.h"
#include "sim/linux/thread.h"
#include "sim/linux/timers.h"
#include "sim/linux/uevents.h"
#include "sim/linux/usb_bus.h"
#include "sim/pins/pins.h"

namespace sim {

class UsbFile;

class LinuxKernel final : public ArmKernel {
public:
    struct Outside {
        std::function<void(char)> console;
        std::function<void(const std::string&)> log;
        // A register on the bus, for drivers; false: refused.
        std::function<bool(bool write, std::uint32_t address, std::uint32_t& value)> access;
        I2cDevices* i2c0;                   // what /dev/i2c-0 has; may be none
        std::optional<PixelBuffer> pixels;  // of /dev/fb0; or there is none
    };

    // Attaches itself.  std::runtime_error if the root cannot be opened.
    LinuxKernel(ArmCpu& cpu, LinuxSettings settings, Outside outside);
    ~LinuxKernel() { over_ = true; }  // nobody answers requests to close files
    LinuxKernel(const LinuxKernel&) = delete;

    // At the console.
    Terminal& terminal() { return terminal_; }
    const Terminal& terminal() const { return terminal_; }

    // The board's USB devices, before it boots.
    void plug_in(UsbPorts& ports);

    // As `kill` from another shell sends it, now; if there is no such process the log has a line.
    void signal_from_outside(unsigned number, int process);

    // Calls that returned ENOSYS because they are not emulated, with their first place: "clone3, 2
    // times, first at 1.5 ms, PC 0x00010A66 in main"; at most twenty, and how many others.
    std::vector<std::string> missing() const;

    // The program's, once it has called exit; or as a shell has it, if ^C or ^\ has ended it.
    std::optional<int> exit_code() const { return exit_code_; }

    // What it waits for, "standard input"; or "".
    std::string waiting() const;

    // What the modules have printed, as `dmesg` shows it; "" without modules.
    const std::string& messages() const { return messages_; }

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
    void interrupt_raised() override;
    bool may_interrupt() const override;
    void exception(ArmCore& core, ArmException, const ArmFault&, const std::string& what) override;

    // kernel_memory.cpp
    std::int64_t map_bus(const Arguments&, std::uint32_t bytes, unsigned access,
                         std::uint32_t page);
    std::int64_t map_shared(const Arguments&, std::uint32_t bytes, unsigned access,
                            std::shared_ptr<SharedMemory> shared, bool as_copy);
    std::int64_t fill_from_file(int fd, std::uint32_t begin, std::uint32_t bytes,
                                std::int64_t offset);
    void files_changed();  // their sizes
    void after_file(std::uint32_t address);
    std::optional<std::uint32_t> place_of(std::uint32_t wish, std::uint32_t bytes,
                                          std::uint32_t flags) const;

    // kernel_files.cpp
    Result open(std::uint32_t folder, std::uint32_t path, std::uint32_t flags, std::uint32_t mode);
    static Piece first_of(const std::vector<Piece>& pieces);
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
    static constexpr std::uint64_t TICK_NS = 10'000'000;               // clock_t's, USER_HZ
    static constexpr std::uint64_t LONGEST_NS = NS * 3600 * 24 * 100;  // SystemC's time is finite
    std::uint64_t used_ns(const LinuxProcess& process) const;          // of the processor
    std::uint64_t used_ns(const LinuxThread& thread) const;
    std::optional<std::uint64_t> clock_ns(std::uint32_t clock) const;
    Result sleep(std::uint32_t flags, std::uint32_t span, bool wide, std::uint32_t left);
    std::int64_t give_time(std::uint32_t to, std::uint64_t ns, bool wide);

    // kernel_timers.cpp
    enum class Span { TIMEVAL, TIMESPEC, TIMESPEC64 };  // struct timeval and so on
    Result timerfd(const Arguments&, Span kind, bool sets);
    // `used`: on a clock of processor time, which is this now.
    std::int64_t set_timer(LinuxTimer& timer, std::uint32_t from, std::uint32_t old, Span kind,
                           bool absolute, std::optional<std::uint64_t> used = {});
    std::int64_t give_timer(std::uint32_t to, const LinuxTimer& timer, Span kind,
                            std::uint64_t now);
    std::uint64_t next_timer_ns() const;
    void expire_timers();

    // kernel_posix_timers.cpp
    std::optional<std::uint64_t> now_of(const PosixTimer& timer) const;
    std::uint64_t at_used_ns(std::uint64_t at_ns, std::uint64_t used) const;
    std::uint64_t next_posix_timer_ns() const;
    void expire_posix_timers();
    void expire(LinuxProcess& process, int number, PosixTimer& timer);
    void go_on_with_timer(LinuxProcess& process, LinuxSignal& signal);
    void delete_posix_timers(LinuxProcess& process);
    std::int64_t clock_for_timer(std::uint32_t clock, PosixTimer& timer) const;
    Result timer_settime(const Arguments&, Span kind);
    Result timer_gettime(const Arguments&, Span kind);

    // kernel_wait.cpp
    std::int64_t span_at(std::uint32_t address, Span kind) const;
    void give_span(std::uint32_t address, Span kind, std::uint64_t ns);
    void name_source(std::string& what, int fd) const;
    bool goes_on(LinuxWait& wait, bool unknown, std::uint64_t end_ns) const;
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
    void end_run(std::uint32_t code, const std::string& where);
    LinuxProcess* process_of(int number) const;
    void forget(LinuxProcess& process);
    Result wait_for_child(std::int32_t which, std::uint32_t options,
                          std::function<std::int64_t(const LinuxProcess&)> result_of);
    std::optional<std::vector<std::string>> strings_at(std::uint32_t list) const;
    Result become(const ElfProgram& program, std::optional<ElfProgram> interpreter,
                  const std::string& path, const std::vector<std::string>& arguments,
                  const std::vector<std::string>& variables);

    // kernel_system.cpp
    std::shared_ptr<AttributeFile> open_attribute(const std::string& path);
    std::optional<std::string> text_of_process(const LinuxProcess&, const LinuxThread*,
                                               const std::string& name) const;
    std::optional<std::string> system_text(const std::string& path) const;
    std::string modules_text() const;
    std::string interrupts_text() const;
    std::uint8_t random_byte();
    std::pair<int, std::shared_ptr<LinuxDevice>> open_system(const std::string& path,
                                                             std::uint32_t flags);
    std::optional<FileStatus> system_status(const std::string& path, bool of_link);
    std::optional<std::string> system_target(const std::string& path);
    // The same by a path without links, of what is no folder.
    std::pair<int, std::shared_ptr<LinuxDevice>> open_own(const std::string& path,
                                                          std::uint32_t flags);
    std::optional<FileStatus> status_of_own(const std::string& path);
    OwnFiles own_files();
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

    // kernel_mqueue.cpp
    std::shared_ptr<MessageQueue> message_queue(std::uint32_t fd,
                                                std::optional<std::uint32_t> access) const;
    std::int64_t end_of_wait(std::uint32_t address, Span kind, LinuxWait& wait) const;
    Result mq_send(const Arguments&, Span kind);
    Result mq_receive(const Arguments&, Span kind);
    void notify_of(MessageQueue& queue);
    void forget_notice(std::uint32_t fd);
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
    std::uint32_t attachments(int segment) const;
    void remove_unused(int segment);
    Result semop(const Arguments&, std::int64_t span);

    // kernel_modules.cpp
    AddressSpace& kernel_space();
    std::optional<KernelModule*> module_named(const std::string& name) const;
    KernelModule& load_module(ElfProgram program, std::vector<std::string> parameters,
                              std::function<void(int)> on_initialised);
    void load_first_module(const ElfProgram& elf, const std::vector<std::string>& parameters,
                           const std::filesystem::path& file);
    void load_first_modules();
    bool modules_are_initialised() const;
    Result insert_module(const std::string& path, const std::string& host,
                         std::uint32_t parameters);
    Result remove_module(KernelModule& module, LinuxThread* thread);
    Result leave_modules(const Arguments&);
    void unload(KernelModule& module);
    // kernel_module_requests.cpp
    Result request(KernelModule& module, ModuleRequest request, const std::string& what);
    Result request(int fd, ModuleFile& file, kmod_operation operation, std::uint32_t a,
                   std::uint32_t b, std::uint32_t c = 0);
    void serve(KernelModule& module, LinuxThread& server);
    Result module_next(KernelModule& module, std::uint32_t at);
    void finish(KernelModule& module, const ModuleRequest& request, std::int64_t result);
    void forget_requests_of(const LinuxThread& thread);
    const LinuxProcess* process_below(const LinuxThread& thread) const;
    std::optional<ModuleNode> module_node(const std::string& path) const;
    static FileStatus status_of(const ModuleNode& node);
    std::optional<FileStatus> module_status(const std::string& path) const;
    ModuleFile* module_file(int fd) const;  // or nullptr
    Result open_module(const ModuleNode& node, const std::string& path, std::uint32_t flags);
    void poll_again();
    void poll_module(ModuleFile& file);
    Result map_module(int fd, ModuleFile& file, const Arguments& a, std::uint32_t bytes);
    std::int64_t mknod(std::uint32_t folder, std::uint32_t path, std::uint32_t mode,
                       std::uint32_t number);
    // kernel_module_calls.cpp
    Result call_of_module(const Arguments&);
    std::int64_t module_copy(std::uint32_t to, std::uint32_t from, std::uint32_t bytes,
                             bool to_program);
    Result module_sleep(KernelModule& module, const Arguments&);
    bool is_in_module(const LinuxThread& thread) const;
    void print_message(const std::string& text, int level);
    std::uint32_t change_register(std::uint32_t address, std::uint32_t clear, std::uint32_t set);
    void route_interrupt(unsigned number, bool by_edge);
    int listen_to(unsigned number);
    void mask_interrupt(unsigned number);
    void unmask_interrupt(unsigned number);
    std::int64_t enable_interrupt(KernelModule& module, unsigned number, std::uint32_t trigger,
                                  std::uint32_t name);
    Result wait_for_interrupt(unsigned number);
    void take_interrupts();
    std::map<unsigned, ModuleInterrupt>::const_iterator handled_interrupt() const;
    std::uint64_t lockup_ns() const;
    void find_lockup();
    std::string place_in_module(std::uint32_t pc) const;
    std::string line_in_module(std::uint32_t pc) const;
    void stop_by_fault(unsigned signal, std::uint32_t address, const std::string& why);
    void stop_by_bug(const std::string& what, std::uint32_t pc);

    // kernel_signals.cpp
    std::int64_t mask_meanwhile(std::uint32_t address, std::uint32_t bytes);
    Result sigtimedwait(const Arguments&, Span kind);
    void unaligned(ArmCore& core, const ArmFault& fault, const std::string& what);
    // By an instruction of the running thread, so it cannot be blocked.
    void fault(const LinuxSignal&);
    // To any thread of it, or to this one; false: too many are pending.
    bool send(LinuxProcess& process, const LinuxSignal& signal);
    bool send(LinuxThread& thread, const LinuxSignal& signal);
    void typed(unsigned number);
    void receive_from_outside();
    // The first that is not among `blocked`.
    std::optional<LinuxSignal> take_signal(LinuxThread& thread, std::uint64_t blocked);
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
    LinuxThread& caller() const { return looks_ ? *looks_ : *running_; }  // of a call
    void look_at_all();
    bool any_waits() const;
    void suspend();  // the running thread waits, or has ended, or makes way
    void go_on();    // with the one that is to run now, when time has come for one
    void account();
    std::uint64_t next_event_ns() const;
    std::string waiting_list() const;  // of each thread
    LinuxThread& next_thread();
    void attach_memory_of(const LinuxThread& thread);
    void run(LinuxThread& thread);
    void stand_still();
    void on_input();
    void feel();
    // kernel_debug.cpp
    std::vector<ArmThread> thread_list() const override;
    unsigned running_thread() const override;
    ArmRegisters* saved_registers(unsigned thread) override;
    void show_memory_of(unsigned thread) override;
    std::vector<ArmModule> module_list() const override;

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
    const LinuxFiles::Console console_;
    const LinuxFiles::System system_;
    LinuxInput input_;
    sc_core::sc_event woken_;  // something has come from outside
    UeventGroup uevents_;
    UsbBus usb_;
    LinuxGpio gpio_;
    LinuxLed led_;
    HostNetwork host_network_;
    LinuxNetwork network_{host_network_};
    bool unreachable_reported_ = false;
    std::shared_ptr<AddressSpace> kernel_memory_;  // of all modules; none without
    std::vector<std::unique_ptr<KernelModule>> modules_;
    std::vector<std::string> first_modules_;  // that the run itself has loaded
    std::shared_ptr<SharedMemory> carried_;   // the ELF file of those that the program brings
    std::map<unsigned, ModuleInterrupt> interrupts_;
    std::map<std::string, std::uint32_t> nodes_;  // made by mknod, and their numbers
    std::string messages_;
    std::uint32_t dma_end_ = 0;
    std::vector<std::unique_ptr<LinuxProcess>> processes_;
    LinuxProcess* process_ = nullptr;   // which a call is about
    LinuxThread* running_ = nullptr;    // whose registers the core has
    LinuxThread* next_ = nullptr;       // that runs at once after it, if it can
    LinuxThread* looks_ = nullptr;      // that waits, while its LinuxWait looks
    AddressSpace* attached_ = nullptr;  // that the core sees
    AddressSpace* shown_ = nullptr;     // by a debugger, in place of it
    LinuxScheduler scheduler_;
    std::list<FutexWaiter> waiters_;             // in their order
    int next_number_ = LinuxProcess::FIRST + 1;  // of a process or thread
    std::uint64_t since_ns_ = 0;                 // when the running one was accounted
    bool yields_ = false;                        // the running one, by its own will
    bool changed_ = false;                       // files, so that a thread may go on
    bool over_ = false;
    bool frame_reader_runs_ = false;
    sc_core::sc_time line_free_;  // when the console's line has taken all that was printed
    std::uint64_t random_;
    std::map<std::string, std::shared_ptr<SharedMemory>> shared_files_;  // of /dev/shm
    MessageQueues message_queues_;
    std::map<int, ipc::Segment> segments_;
    std::map<int, ipc::Semaphores> semaphores_;
    std::map<int, IpcMessages> ipc_messages_;
    int next_ipc_ = 0;
    std::set<std::uint32_t> unaligned_;  // instructions that are in the log
    // Calls that are not emulated: how often, and where first, as in messages.
    std::map<std::string, std::pair<unsigned, std::string>> missing_;
    std::vector<std::weak_ptr<LinuxTimerFile>> timer_files_;
    std::set<std::string> named_files_;  // of the system, that are not there
    std::optional<int> exit_code_;
    std::vector<std::pair<unsigned, int>> from_outside_;  // signals, and to which process
};

}  // namespace sim
