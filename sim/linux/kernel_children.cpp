// kernel_children.cpp - LinuxKernel's processes: fork, exec, exit, wait
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::size_t MOST_PROCESSES = 256;

// Which forgets those that have ended.
void give_children_to_init(std::vector<std::unique_ptr<LinuxProcess>>& processes, int of) {
    for (const auto& other : processes)
        if (other->parent == of) other->parent = LinuxProcess::INIT;
    const auto is_over = [](const auto& one) {
        return one->parent == LinuxProcess::INIT && one->status;
    };
    processes.erase(std::remove_if(processes.begin(), processes.end(), is_over), processes.end());
}
constexpr std::int32_t CHILD_EXITED = 1, CHILD_KILLED = 2;  // siginfo's si_code
constexpr std::uint32_t NO_HANG = 1;

}  // namespace

// ---- Fork ---------------------------------------------------------------------------------------

// A copy of the running process, or with VM, as vfork has it, one in the same memory.
LinuxKernel::Result LinuxKernel::fork(const Clone& how) {
    using namespace arm_clone;
    if (processes_.size() >= MOST_PROCESSES) return -EAGAIN;
    LinuxProcess& parent = *process_;
    auto memory = how.flags & VM ? parent.memory : parent.memory->copy();
    if (!memory) return -ENOMEM;
    const int number = next_number_++;
    auto made = std::make_unique<LinuxProcess>(
        LinuxProcess{number, how.flags & PARENT ? parent.parent : parent.number, std::move(memory),
                     parent.files, parent.signals});
    LinuxProcess& child = *made;
    child.break_begin = parent.break_begin;
    child.break_end = parent.break_end;
    child.umask = parent.umask;
    child.command = parent.command;
    child.folder = parent.folder;
    child.group = parent.group;
    child.session = parent.session;
    child.command_line = parent.command_line;
    child.segments = parent.segments;
    child.end_signal = static_cast<unsigned>(how.flags & EXIT_SIGNAL);
    processes_.push_back(std::move(made));
    child.threads.push_back(std::make_unique<LinuxThread>(number, child));
    LinuxThread& thread = *child.threads.back();
    begin_thread(thread, how);
    thread.sequences = how.flags & VM ? 0 : running_->sequences;
    thread.signals.stack = running_->signals.stack;
    thread.signals.stack_size = running_->signals.stack_size;
    if (how.flags & VFORK) {  // until its child has ended, or has other memory
        LinuxWait wait;
        wait.what = fmt::format("process {} to be another program, or to end", number);
        wait.inside = wait.uninterrupted = true;
        wait.look = [&child, this, number](LinuxWait&) -> Result {
            const bool there = std::any_of(
                processes_.begin(), processes_.end(),
                [&](const auto& p) { return p.get() == &child && p->number == number; });
            return there && !child.status && child.memory == process_->memory ? Result{} : number;
        };
        return this->wait(std::move(wait));
    }
    return number;
}

LinuxKernel::Result LinuxKernel::sys_fork(const Arguments&) { return clone({SIGCHLD, 0, 0, 0, 0}); }

LinuxKernel::Result LinuxKernel::sys_vfork(const Arguments&) {
    return clone({arm_clone::VM | arm_clone::VFORK | SIGCHLD, 0, 0, 0, 0});
}

// ---- The end of one -----------------------------------------------------------------------------

// `status`: as waitpid() has it.  That of the first ends the run.
void LinuxKernel::end_process(LinuxProcess& process, std::uint32_t status) {
    while (!process.threads.empty()) end_thread(*process.threads.back());
    process.files.close_all(false);
    message_queues_.forget_owner(process.number, nullptr);
    process.segments.clear();
    if (process.memory.get() == attached_ && process.memory.use_count() == 1) {
        attached_->detach();
        attached_ = nullptr;
    }
    process.memory = nullptr;
    process.status = status;
    changed_ = true;
    give_children_to_init(processes_, process.number);
    LinuxProcess* const parent = process_of(process.parent);
    if (!parent) return forget(process);
    const int code = static_cast<int>(status >> 8), by = static_cast<int>(status & 0x7F);
    if (process.end_signal != 0)
        send(*parent, {process.end_signal,
                       by ? CHILD_KILLED : CHILD_EXITED,
                       {static_cast<std::uint32_t>(process.number), 0,
                        static_cast<std::uint32_t>(by ? by : code),
                        static_cast<std::uint32_t>(process.used_ns / TICK_NS)},
                       "a child ended"});
    constexpr std::uint32_t IGNORED = 1;
    if (parent->signals.actions[SIGCHLD].handler == IGNORED) forget(process);
}

LinuxProcess* LinuxKernel::process_of(int number) const {
    for (const auto& process : processes_)
        if (process->number == number) return process.get();
    return nullptr;
}

// It has ended, and somebody knows.
void LinuxKernel::forget(LinuxProcess& process) {
    if (process_ == &process) process_ = processes_.front().get();
    processes_.erase(std::find_if(processes_.begin(), processes_.end(),
                                  [&](const auto& one) { return one.get() == &process; }));
}

LinuxKernel::Result LinuxKernel::sys_exit_group(const Arguments& a) {
    const std::uint32_t code = a[0] & 0xFF;
    if (process_->number != LinuxProcess::FIRST) {
        end_process(*process_, code << 8);
        return std::nullopt;
    }
    if (!modules_.empty()) return leave_modules(a);
    end_run(code, cpu_.where());
    return std::nullopt;
}

// The first process has ended.
void LinuxKernel::end_run(std::uint32_t code, const std::string& where) {
    over_ = true;
    exit_code_ = static_cast<int>(code);
    const auto others = std::count_if(processes_.begin(), processes_.end(),
                                      [](const auto& process) { return !process->status; });
    if (others > 1)
        outside_.log(fmt::format(
            "the program has ended, and with it {} that it had begun, {}",
            others == 2 ? "a process" : fmt::format("{} processes", others - 1), where));
    std::string why = loader_.failure(code);
    if (why.empty() && !loader_.missing().empty())
        outside_.log(fmt::format("the program looked for the library {}", loader_.missing()));
    if (code != 0 && why.empty())
        why = fmt::format("the program ended with exit code {} {}", code, where);
    cpu_.end(why);
}

// ---- Waiting for one ----------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::wait_for_child(
    std::int32_t which, std::uint32_t options,
    std::function<std::int64_t(const LinuxProcess&)> result_of) {
    LinuxWait wait;
    wait.what = which > 0 ? fmt::format("the end of process {}", which) : "the end of a process";
    wait.inside = wait.restarts = true;
    wait.look = [this, which, options, result_of = std::move(result_of), own = process_->number,
                 group = which == 0 ? process_->group : -which](LinuxWait&) -> Result {
        bool any = false;
        for (const auto& process : processes_) {
            const bool is_meant =
                which == -1 || process->number == which || (which <= 0 && process->group == group);
            if (process->parent != own || !is_meant) continue;
            any = true;
            if (!process->status) continue;
            const std::int64_t result = result_of(*process);
            if (result < 0 || (options & LEAVES)) return result;
            process_->used_by_children_ns += process->used_ns + process->used_by_children_ns;
            forget(*process);
            return result;
        }
        if (!any) return -ECHILD;
        return options & NO_HANG ? Result{0} : std::nullopt;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_wait4(const Arguments& a) {
    return wait_for_child(
        static_cast<std::int32_t>(a[0]), a[2] & ~LEAVES,
        [this, to = a[1], usage = a[3]](const LinuxProcess& child) -> std::int64_t {
            const auto us = child.used_ns / 1000;
            const std::uint32_t used[18] = {static_cast<std::uint32_t>(us / 1'000'000),
                                            static_cast<std::uint32_t>(us % 1'000'000)};
            const bool given = (to == 0 || memory().write(to, &*child.status, 4)) &&
                               (usage == 0 || memory().write(usage, used, sizeof used));
            return given ? child.number : -EFAULT;
        });
}

LinuxKernel::Result LinuxKernel::sys_waitid(const Arguments& a) {
    constexpr std::uint32_t ANY = 0, ONE = 1, GROUP = 2, EXITED = 4;
    if (a[0] > GROUP || !(a[3] & EXITED)) return -EINVAL;
    const auto named = static_cast<std::int32_t>(a[1]);
    static_assert(ANY == 0);
    return wait_for_child(a[0] == ONE     ? named
                          : a[0] == GROUP ? -named
                                          : -1,
                          a[3], [this, to = a[2]](const LinuxProcess& child) -> std::int64_t {
                              const std::uint32_t by = *child.status & 0x7F;
                              const std::uint32_t info[32] = {
                                  SIGCHLD,
                                  0,
                                  static_cast<std::uint32_t>(by ? CHILD_KILLED : CHILD_EXITED),
                                  static_cast<std::uint32_t>(child.number),
                                  0,
                                  by ? by : *child.status >> 8};
                              return to == 0 || memory().write(to, info, sizeof info) ? 0 : -EFAULT;
                          });
}

// ---- Another program ----------------------------------------------------------------------------

std::optional<std::vector<std::string>> LinuxKernel::strings_at(std::uint32_t list) const {
    constexpr std::size_t MOST = 4096;
    std::vector<std::string> all;
    for (std::uint32_t address; list != 0 && all.size() < MOST; list += 4) {
        if (!memory().read(list, &address, sizeof address)) return std::nullopt;
        if (address == 0) return all;
        auto text = memory().string(address);
        if (!text) return std::nullopt;
        all.push_back(std::move(*text));
    }
    return all;
}

LinuxKernel::Result LinuxKernel::sys_execve(const Arguments& a) {
    const auto path = memory().string(a[0]);
    const auto arguments = strings_at(a[1]), variables = strings_at(a[2]);
    if (!path || !arguments || !variables) return -EFAULT;
    const bool itself = *path == "/proc/self/exe" || *path == path_of(cpu_.program().elf);
    ElfProgram program;
    if (itself) {
        program = cpu_.program().elf;
    } else {
        const int host = process_->files.open_to_load(*path);
        if (host < 0) {
            if (named_files_.insert(*path).second)
                outside_.log(
                    fmt::format("{} cannot be run: it is not in the folder of "
                                "--linux-root, {}",
                                *path, cpu_.where()));
            return host;
        }
        try {
            program = LinuxLoader::load(*path, host);
            if (program.is_modules())
                throw ElfError{"is a kernel module: insmod loads it, or --module"};
        } catch (const std::exception& e) {
            outside_.log(fmt::format("{} cannot be run: {}", *path, e.what()));
            return -ENOEXEC;
        }
    }
    try {
        return become(program, LinuxLoader::interpreter_of(program, files()), *path, *arguments,
                      *variables);
    } catch (const std::runtime_error& e) {
        outside_.log(e.what());
        return -ENOENT;
    }
}

// The present memory, threads and handlers are no more.
LinuxKernel::Result LinuxKernel::become(const ElfProgram& program,
                                        std::optional<ElfProgram> interpreter,
                                        const std::string& path,
                                        const std::vector<std::string>& arguments,
                                        const std::vector<std::string>& variables) {
    LinuxProcess& process = *process_;
    LinuxThread& thread = *running_;
    for (std::size_t i = process.threads.size(); i-- > 0;)
        if (process.threads[i].get() != &thread) end_thread(*process.threads[i]);
    auto memory = std::make_shared<AddressSpace>(cpu_.core());
    if (attached_) attached_->detach();
    attached_ = memory.get();
    attached_->attach();
    const auto before = std::exchange(process.memory, memory);
    try {
        process.break_begin = process.break_end =
            loader_.begin(*memory, program, std::move(interpreter), arguments, variables);
    } catch (const std::runtime_error& e) {
        die({SIGKILL, 0, {}, fmt::format("{} (", e.what())});
        return std::nullopt;
    }
    process.files.close_all(true);
    message_queues_.forget_owner(process.number, nullptr);
    process.segments.clear();
    delete_posix_timers(process);
    process.command = path;
    process.set_command_line(arguments);
    for (LinuxSignals::Action& action : process.signals.actions)
        if (action.handled()) action = {};
    thread.number = process.number;
    thread.clears = thread.robust_list = thread.sequences = 0;
    thread.signals.stack = thread.signals.stack_size = 0;
    thread.name.clear();
    thread.tls = 0;
    helpers_.set_tls(0);
    for (unsigned i = 0; i < 32; ++i) cpu_.core().set_vfp(i, 0);
    cpu_.core().set_fpscr(0);
    changed_ = true;  // who waits for it after vfork
    return std::nullopt;
}

}  // namespace sim
