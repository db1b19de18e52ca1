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
const sc_core::sc_time module_call_time{100, sc_core::SC_NS};  // a function's, within the kernel
// Debian's: the cross compiler's, and those of packages for armhf (libusb-1.0-0-dev:armhf).
const std::vector<std::filesystem::path> libraries{"/usr/arm-linux-gnueabihf/lib",
                                                   "/usr/lib/arm-linux-gnueabihf"};

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
      console_{outside_.console,
               [this](char* to, std::size_t bytes) { return terminal_.read_now(to, bytes); },
               [this] { return terminal_.readable(); }},
      system_{
          [this](const std::string& path, std::uint32_t flags) { return open_system(path, flags); },
          [this](const std::string& path, bool of_link) { return system_status(path, of_link); },
          [this](const std::string& path) { return remove_system(path); },
          [this](const std::string& path) { return system_target(path); }},
      input_{[this] { feel(); }},
      usb_{input_, uevents_, [&cpu] { return cpu.now().value(); }, [this] { feel(); }},
      gpio_{{[this](std::uint32_t address, std::uint32_t clear, std::uint32_t set) {
                 return change_register(address, clear, set);
             },
             [this](unsigned number) { return listen_to(number); },
             [this](unsigned pin) { return pin == LinuxGpio::HPS_LED && led_.is_bound(); }}},
      led_{{[this](bool lit) { gpio_.drive(LinuxGpio::HPS_LED, lit); },
            [this] { return !gpio_.is_exported(LinuxGpio::HPS_LED); },
            [this] { return now_ns(); }}},
      host_network_{settings_.network},
      random_{SEED} {
    processes_.push_back(std::make_unique<LinuxProcess>(LinuxProcess{
        LinuxProcess::FIRST, LinuxProcess::SHELL, std::make_shared<AddressSpace>(cpu.core()),
        LinuxFiles{settings_.root, libraries, settings_.input, console_, system_}}));
    process_ = processes_.front().get();
    cpu.attach(this);
}

// A hand has done something with a USB device, or that has.
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
        load_first_modules();
        if (cpu_.program().elf.is_modules()) return go_on();
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
    process_->threads.push_back(std::make_unique<LinuxThread>(process_->number, *process_));
    LinuxThread& first = *process_->threads.back();
    first.save(core);
    if (modules_.empty()) {
        scheduler_.add(first, false);
        return go_on();
    }
    LinuxWait wait;
    wait.what = "the modules to be initialised";
    wait.inside = wait.uninterrupted = true;
    wait.look = [this, r0 = first.r[0]](LinuxWait&) {
        return modules_are_initialised() ? Result{r0} : std::nullopt;
    };
    first.wait = std::move(wait);
    go_on();
}

void LinuxKernel::call(ArmCore& core) {
    static const auto by_number = [] {
        std::unordered_map<std::uint32_t, Result (LinuxKernel::*)(const Arguments&)> all;
        for (const Call& call : calls()) all.emplace(call.number, call.answer);
        return all;
    }();
    const std::uint32_t number = core.reg(7);
    const bool by_module = process_->module && number == KMOD_CALL;
    cpu_.work(by_module ? module_call_time : call_time);
    const auto call = by_number.find(number);
    if (by_module || call != by_number.end()) {
        const Arguments arguments{core.reg(0), core.reg(1), core.reg(2), core.reg(3),
                                  core.reg(4), core.reg(5), core.reg(6)};
        Result result;
        try {
            result = by_module ? call_of_module(arguments) : (this->*call->second)(arguments);
        } catch (const std::bad_alloc&) {  // the host has no more, of memory or of files
            result = -ENOMEM;
        }
        if (result) core.set_reg(0, static_cast<std::uint32_t>(*result));
        return go_on();
    }
    const std::string name = name_of(number);
    not_emulated(name.empty() ? std::to_string(number) : name);
    core.set_reg(0, static_cast<std::uint32_t>(-ENOSYS));
    go_on();
}

// It is in the log once.
void LinuxKernel::not_emulated(const std::string& what) {
    auto& [times, first] = missing_[what];
    if (++times > 1) return;
    first = cpu_.where();
    const std::uint32_t number = cpu_.core().reg(7);
    outside_.log(fmt::format("system call {}{} is not emulated: ENOSYS, {}", number,
                             what == std::to_string(number) ? "" : " (" + what + ")", first));
}

std::vector<std::string> LinuxKernel::missing() const {
    constexpr std::size_t MOST = 20;
    std::vector<std::string> all;
    for (const auto& [name, missing] : missing_) {
        const auto& [times, first] = missing;
        if (all.size() == MOST) {
            all.push_back(fmt::format("{} other calls", missing_.size() - MOST));
            break;
        }
        all.push_back(times == 1 ? fmt::format("{}, {}", name, first)
                                 : fmt::format("{}, {} times, first {}", name, times, first));
    }
    return all;
}

void LinuxKernel::exception(ArmCore& core, ArmException exception, const ArmFault& abort,
                            const std::string& what) {
    using namespace arm_signal_code;
    switch (exception) {
        case ArmException::DATA_ABORT:
            if (abort.mmu && abort.status == fault_status::ALIGNMENT)
                unaligned(core, abort, what);
            else if (!abort.mmu)
                fault({SIGBUS, EXTERNAL_ABORT, {abort.address}, what});
            else if (memory().is_after_file(abort.address))
                after_file(abort.address);
            else
                fault({SIGSEGV,
                       memory().at(abort.address) ? NOT_ALLOWED : NOT_MAPPED,
                       {abort.address},
                       fmt::format("{} 0x{:08X}", abort.write ? "write to" : "read from",
                                   abort.address)});
            break;
        case ArmException::PREFETCH_ABORT:
            if (what == "breakpoint instruction")
                fault({SIGTRAP, BREAKPOINT, {core.pc()}, what});
            else
                fault({SIGSEGV,
                       memory().at(core.pc()) ? NOT_ALLOWED : NOT_MAPPED,
                       {core.pc()},
                       "no instruction to be read"});
            break;
        default: fault({SIGILL, ILLEGAL_OPCODE, {core.pc()}, what}); break;
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
    static const std::vector<Call> calls{
#define CALL(name, answer) {NR_##name, &LinuxKernel::sys_##answer},
#define ALSO CALL
#include "sim/linux/kernel_calls.def"
#undef ALSO
#undef CALL
    };
    return calls;
}

}  // namespace sim
