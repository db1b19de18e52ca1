#include "sim/linux/kernel.h"

#include <cerrno>
#include <csignal>
#include <unordered_map>

#include <fmt/format.h>

#include "arm_syscalls.h"

namespace sim {

namespace {

constexpr std::uint64_t SEED = 0x9E3779B97F4A7C15;
const sc_core::sc_time call_time{1, sc_core::SC_US};
constexpr const char* CROSS_LIBRARIES = "/usr/arm-linux-gnueabihf/lib";  // Debian's

}  // namespace

LinuxKernel::LinuxKernel(ArmCpu& cpu, LinuxSettings settings, Outside outside)
    : cpu_{cpu},
      settings_{std::move(settings)},
      outside_{std::move(outside)},
      helpers_{cpu.core()},
      loader_{cpu},
      terminal_{
          {[&cpu] { return cpu.now(); }, [&cpu](const sc_core::sc_time& time) { cpu.pause(time); },
           [&cpu](const sc_core::sc_event& until, const sc_core::sc_time& at_most) {
               cpu.pause(until, at_most);
           },
           outside_.console, [this](unsigned number) { typed(number); }, [this] { on_input(); }}},
      input_{[] { return sc_core::sc_time_stamp().value() / 1000; }, [this] { feel(); }},
      random_{SEED} {
    const LinuxFiles::Console console{
        outside_.console,
        [this](char* to, std::size_t bytes) { return terminal_.read_now(to, bytes); },
        [this] { return terminal_.readable(); }};
    const LinuxFiles::System system{
        [this](const std::string& path, std::uint32_t flags) { return open_system(path, flags); },
        [this](const std::string& path) { return system_status(path); },
        [this](const std::string& path) { return remove_system(path); }};
    processes_.push_back(std::make_unique<LinuxProcess>(LinuxProcess{
        LinuxProcess::FIRST, 0, std::make_shared<AddressSpace>(cpu.core()),
        LinuxFiles{settings_.root, CROSS_LIBRARIES, settings_.input, console, system}}));
    process_ = processes_.front().get();
    cpu.attach(this);
}

// A hand has done something with the keyboard or the mouse.
void LinuxKernel::feel() {
    changed_ = true;
    woken_.notify(sc_core::SC_ZERO_TIME);
    cpu_.set_alarm(std::min(cpu_.alarm(), sc_core::sc_time_stamp()));
}

// Something has come from outside while a program runs, or all threads wait.
void LinuxKernel::on_input() {
    woken_.notify(sc_core::SC_ZERO_TIME);
    const sc_core::sc_time next = terminal_.next_arrival().value_or(sc_core::sc_max_time());
    if (next < cpu_.alarm()) cpu_.set_alarm(next);
}

void LinuxKernel::boot(ArmCore& core) {
    if (running_ || over_ || !process_->threads.empty())
        return cpu_.end("the program reset the board " + cpu_.where());
    helpers_.connect();
    try {
        std::vector<std::string> arguments{path_of(cpu_.program().elf)};
        arguments.insert(arguments.end(), settings_.arguments.begin(), settings_.arguments.end());
        process_->command = arguments[0];
        process_->set_command_line(arguments);
        attached_ = process_->memory.get();
        attached_->attach();
        process_->break_begin = process_->break_end = loader_.begin(
            memory(), cpu_.program().elf, LinuxLoader::interpreter_of(cpu_.program().elf, files()),
            arguments, first_environment());
    } catch (const std::runtime_error& e) {  // SystemC must not see exceptions
        return cpu_.end(e.what());
    }
    process_->threads.push_back(
        std::make_unique<LinuxThread>(LinuxThread{process_->number, *process_}));
    LinuxThread& first = *process_->threads.back();
    first.save(core);
    scheduler_.add(first, false);
    go_on();
}

void LinuxKernel::call(ArmCore& core) {
    static const auto by_number = [] {
        std::unordered_map<std::uint32_t, Result (LinuxKernel::*)(const Arguments&)> all;
        for (const Call& call : calls()) all.emplace(call.number, call.answer);
        return all;
    }();
    cpu_.work(call_time);
    const std::uint32_t number = core.reg(7);
    if (const auto call = by_number.find(number); call != by_number.end()) {
        const Arguments arguments{core.reg(0), core.reg(1), core.reg(2), core.reg(3),
                                  core.reg(4), core.reg(5), core.reg(6)};
        if (const Result result = (this->*call->second)(arguments))
            core.set_reg(0, static_cast<std::uint32_t>(*result));
        return go_on();
    }
    const std::string name = name_of(number);
    not_emulated(name.empty() ? std::to_string(number) : name);
    core.set_reg(0, static_cast<std::uint32_t>(-ENOSYS));
    go_on();
}

// It is said in the log once.
void LinuxKernel::not_emulated(const std::string& what) {
    if (++missing_[what] > 1) return;
    const std::uint32_t number = cpu_.core().reg(7);
    outside_.log(fmt::format("system call {}{} is not emulated: ENOSYS, {}", number,
                             what == std::to_string(number) ? "" : " (" + what + ")",
                             cpu_.where()));
}

std::string LinuxKernel::missing() const {
    std::string all;
    for (const auto& [name, times] : missing_)
        all +=
            (all.empty() ? "" : "; ") + name + (times > 1 ? fmt::format(", {} times", times) : "");
    return all;
}

void LinuxKernel::exception(ArmCore& core, ArmException exception, const ArmFault& abort,
                            const std::string& what) {
    switch (exception) {
        case ArmException::DATA_ABORT:
            if (abort.mmu && abort.status == fault_status::ALIGNMENT)
                unaligned(core, abort, what);
            else if (!abort.mmu)
                fault(SIGBUS, abort.address, what);
            else
                fault(SIGSEGV, abort.address,
                      fmt::format("{} 0x{:08X}", abort.write ? "write to" : "read from",
                                  abort.address));
            break;
        case ArmException::PREFETCH_ABORT:
            if (what == "breakpoint instruction")
                fault(SIGTRAP, core.pc(), what);
            else
                fault(SIGSEGV, core.pc(), "no instruction to be read");
            break;
        default: fault(SIGILL, core.pc(), what); break;
    }
    go_on();
}

const char* LinuxKernel::name_of(std::uint32_t number) {
    for (const ArmSyscall& call : ARM_SYSCALLS)
        if (call.number == number) return call.name;
    return "";
}

// ---- The calls ----------------------------------------------------------------------------------

const std::vector<LinuxKernel::Call>& LinuxKernel::calls() {
    using K = LinuxKernel;
    static const std::vector<Call> calls{
        {NR_brk, &K::sys_brk},
        {NR_mmap2, &K::sys_mmap2},
        {NR_munmap, &K::sys_munmap},
        {NR_mprotect, &K::sys_mprotect},
        {NR_mremap, &K::sys_mremap},
        {NR_madvise, &K::sys_done},
        {NR_cacheflush, &K::sys_cacheflush},

        {NR_open, &K::sys_open},
        {NR_openat, &K::sys_openat},
        {NR_creat, &K::sys_creat},
        {NR_close, &K::sys_close},
        {NR_read, &K::sys_read},
        {NR_write, &K::sys_write},
        {NR_readv, &K::sys_readv},
        {NR_writev, &K::sys_writev},
        {NR_pread64, &K::sys_pread64},
        {NR_pwrite64, &K::sys_pwrite64},
        {NR_lseek, &K::sys_lseek},
        {NR__llseek, &K::sys_llseek},
        {NR_ftruncate64, &K::sys_ftruncate64},
        {NR_ftruncate, &K::sys_ftruncate},
        {NR_link, &K::sys_link},
        {NR_fsync, &K::sys_fsync},
        {NR_fdatasync, &K::sys_fsync},
        {NR_dup, &K::sys_dup},
        {NR_dup2, &K::sys_dup2},
        {NR_dup3, &K::sys_dup2},
        {NR_fcntl, &K::sys_fcntl},
        {NR_fcntl64, &K::sys_fcntl},
        {NR_ioctl, &K::sys_ioctl},

        {NR_pipe, &K::sys_pipe},
        {NR_pipe2, &K::sys_pipe2},
        {NR_eventfd, &K::sys_eventfd},
        {NR_eventfd2, &K::sys_eventfd2},
        {NR_memfd_create, &K::sys_memfd_create},

        {NR_socket, &K::sys_socket},
        {NR_socketpair, &K::sys_socketpair},
        {NR_bind, &K::sys_bind},
        {NR_listen, &K::sys_listen},
        {NR_getsockname, &K::sys_getsockname},
        {NR_getpeername, &K::sys_getpeername},
        {NR_connect, &K::sys_connect},
        {NR_accept, &K::sys_accept},
        {NR_accept4, &K::sys_accept4},
        {NR_shutdown, &K::sys_shutdown},
        {NR_send, &K::sys_send},
        {NR_sendto, &K::sys_sendto},
        {NR_sendmsg, &K::sys_sendmsg},
        {NR_recv, &K::sys_recv},
        {NR_recvfrom, &K::sys_recvfrom},
        {NR_recvmsg, &K::sys_recvmsg},
        {NR_setsockopt, &K::sys_setsockopt},
        {NR_getsockopt, &K::sys_getsockopt},

        {NR_shmget, &K::sys_shmget},
        {NR_shmat, &K::sys_shmat},
        {NR_shmdt, &K::sys_shmdt},
        {NR_shmctl, &K::sys_shmctl},
        {NR_semget, &K::sys_semget},
        {NR_semctl, &K::sys_semctl},
        {NR_semop, &K::sys_semop},
        {NR_semtimedop, &K::sys_semtimedop},
        {NR_semtimedop_time64, &K::sys_semtimedop_time64},

        {NR_fstat64, &K::sys_fstat64},
        {NR_stat64, &K::sys_stat64},
        {NR_lstat64, &K::sys_lstat64},
        {NR_fstatat64, &K::sys_fstatat64},
        {NR_statx, &K::sys_statx},
        {NR_access, &K::sys_access},
        {NR_faccessat, &K::sys_faccessat},
        {NR_faccessat2, &K::sys_faccessat},
        {NR_unlink, &K::sys_unlink},
        {NR_unlinkat, &K::sys_unlinkat},
        {NR_rmdir, &K::sys_rmdir},
        {NR_mkdir, &K::sys_mkdir},
        {NR_mkdirat, &K::sys_mkdirat},
        {NR_rename, &K::sys_rename},
        {NR_renameat, &K::sys_renameat},
        {NR_readlink, &K::sys_readlink},
        {NR_readlinkat, &K::sys_readlinkat},
        {NR_getcwd, &K::sys_getcwd},
        {NR_chdir, &K::sys_chdir},
        {NR_fchdir, &K::sys_fchdir},
        {NR_getdents64, &K::sys_getdents64},
        {NR_umask, &K::sys_umask},

        {NR_clock_gettime, &K::sys_clock_gettime},
        {NR_clock_gettime64, &K::sys_clock_gettime64},
        {NR_clock_getres, &K::sys_clock_getres},
        {NR_clock_getres_time64, &K::sys_clock_getres_time64},
        {NR_gettimeofday, &K::sys_gettimeofday},
        {NR_times, &K::sys_times},
        {NR_nanosleep, &K::sys_nanosleep},
        {NR_clock_nanosleep, &K::sys_clock_nanosleep},
        {NR_clock_nanosleep_time64, &K::sys_clock_nanosleep_time64},
        {NR_futex, &K::sys_futex},
        {NR_futex_time64, &K::sys_futex_time64},
        {NR_pause, &K::sys_pause},
        {NR_setitimer, &K::sys_setitimer},
        {NR_getitimer, &K::sys_getitimer},
        {NR_timerfd_create, &K::sys_timerfd_create},
        {NR_timerfd_settime, &K::sys_timerfd_settime},
        {NR_timerfd_settime64, &K::sys_timerfd_settime64},
        {NR_timerfd_gettime, &K::sys_timerfd_gettime},
        {NR_timerfd_gettime64, &K::sys_timerfd_gettime64},

        {NR__newselect, &K::sys_select},
        {NR_pselect6, &K::sys_pselect6},
        {NR_pselect6_time64, &K::sys_pselect6_time64},
        {NR_poll, &K::sys_poll},
        {NR_ppoll, &K::sys_ppoll},
        {NR_ppoll_time64, &K::sys_ppoll_time64},
        {NR_epoll_create, &K::sys_epoll_create},
        {NR_epoll_create1, &K::sys_epoll_create1},
        {NR_epoll_ctl, &K::sys_epoll_ctl},
        {NR_epoll_wait, &K::sys_epoll_wait},
        {NR_epoll_pwait, &K::sys_epoll_pwait},

        {NR_exit, &K::sys_exit},
        {NR_exit_group, &K::sys_exit_group},
        {NR_clone, &K::sys_clone},
        {NR_fork, &K::sys_fork},
        {NR_vfork, &K::sys_vfork},
        {NR_execve, &K::sys_execve},
        {NR_wait4, &K::sys_wait4},
        {NR_waitid, &K::sys_waitid},
        {NR_clone3, &K::sys_clone3},
        {NR_gettid, &K::sys_gettid},
        {NR_sched_yield, &K::sys_sched_yield},
        {NR_sched_setaffinity, &K::sys_sched_setaffinity},
        {NR_sched_setscheduler, &K::sys_sched_setscheduler},
        {NR_sched_getscheduler, &K::sys_sched_getscheduler},
        {NR_sched_setparam, &K::sys_sched_setparam},
        {NR_sched_getparam, &K::sys_sched_getparam},
        {NR_sched_get_priority_max, &K::sys_sched_get_priority_max},
        {NR_sched_get_priority_min, &K::sys_sched_get_priority_min},
        {NR_sched_rr_get_interval, &K::sys_sched_rr_get_interval},
        {NR_getcpu, &K::sys_getcpu},
        {NR_nice, &K::sys_nice},
        {NR_getpriority, &K::sys_getpriority},
        {NR_setpriority, &K::sys_setpriority},
        {NR_prctl, &K::sys_prctl},
        {NR_set_tls, &K::sys_set_tls},
        {NR_set_tid_address, &K::sys_set_tid_address},
        {NR_set_robust_list, &K::sys_set_robust_list},
        {NR_get_robust_list, &K::sys_get_robust_list},
        {NR_rseq, &K::sys_rseq},
        {NR_uname, &K::sys_uname},
        {NR_getrandom, &K::sys_getrandom},
        {NR_prlimit64, &K::sys_prlimit64},
        {NR_ugetrlimit, &K::sys_getrlimit},
        {NR_getrusage, &K::sys_getrusage},
        {NR_sysinfo, &K::sys_sysinfo},
        {NR_sched_getaffinity, &K::sys_sched_getaffinity},
        {NR_getpid, &K::sys_getpid},
        {NR_getpgrp, &K::sys_getpid},
        {NR_getppid, &K::sys_getppid},
        {NR_getuid32, &K::sys_done},
        {NR_geteuid32, &K::sys_done},
        {NR_getgid32, &K::sys_done},
        {NR_getegid32, &K::sys_done},
        {NR_rt_sigaction, &K::sys_sigaction},
        {NR_rt_sigprocmask, &K::sys_sigprocmask},
        {NR_sigaltstack, &K::sys_sigaltstack},
        {NR_sigreturn, &K::sys_sigreturn},
        {NR_rt_sigreturn, &K::sys_rt_sigreturn},
        {NR_rt_sigpending, &K::sys_sigpending},
        {NR_rt_sigsuspend, &K::sys_sigsuspend},
        {NR_rt_sigtimedwait, &K::sys_sigtimedwait},
        {NR_rt_sigtimedwait_time64, &K::sys_sigtimedwait_time64},
        {NR_rt_sigqueueinfo, &K::sys_sigqueueinfo},
        {NR_kill, &K::sys_kill},
        {NR_tkill, &K::sys_tkill},
        {NR_tgkill, &K::sys_tgkill},
    };
    return calls;
}

}  // namespace sim
