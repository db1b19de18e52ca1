#include "sim/run/arm_run.h"

#include <iterator>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/hps/bridge_windows.h"
#include "sim/run/file_kind.h"
#include "sim/run/missed_interrupts.h"

namespace sim {

// Of a project's design it is known later what is behind the bridges.
static std::vector<MemoryRange> memory_for(const RunPlan& plan) {
    std::vector<MemoryRange> memory = program_memory();
    if (!plan.has_project()) return memory;
    memory.back() = {H2F_BASE, H2F_SIZE};
    memory.push_back({LW_BASE, LW_SIZE});
    return memory;
}

ArmProgram load_program(const RunPlan& plan) {
    const ProgramDescription& program = plan.description.program;
    const bool on_linux = plan.on_linux;
    if (!on_linux && !program.arguments.empty())
        throw std::runtime_error{program.elf.string() +
                                 ": arguments after -- are for Linux programs (--system linux)"};
    if (!on_linux && !program.linux_root.empty())
        throw std::runtime_error{program.elf.string() +
                                 ": --linux-root is for Linux programs (--system linux)"};
    if (!on_linux && !program.modules.empty())
        throw std::runtime_error{program.elf.string() +
                                 ": --module is for Linux programs (--system linux)"};
    if (!on_linux && !program.input.empty())
        throw std::runtime_error{program.elf.string() +
                                 ": --stdin is for Linux programs (--system linux)"};
    if (!on_linux && !program.network.empty())
        throw std::runtime_error{program.elf.string() +
                                 ": --network is for Linux programs (--system linux)"};
    ElfProgram elf = on_linux ? load_elf(program.elf, linux_memory(), Linking::ANY)
                              : load_elf(program.elf, memory_for(plan));
    if (!on_linux) elf.leave_only_sections();
    return {std::move(elf), program.cpi};
}

// Of --module; ElfError.
static std::vector<LinuxSettings::Module> load_modules(const std::vector<std::string>& options) {
    std::vector<LinuxSettings::Module> all;
    for (const std::string& option : options) {
        std::istringstream stream{option};
        std::vector<std::string> words{std::istream_iterator<std::string>{stream}, {}};
        if (words.empty()) throw ElfError{"--module: expected a file, got nothing"};
        ElfProgram elf = load_elf(words.front(), linux_memory(), Linking::ANY);
        if (!elf.is_modules())
            throw ElfError{words.front() +
                           ": is a program, expected a kernel module that de1sim link has made"};
        words.erase(words.begin());
        all.push_back({std::move(elf), std::move(words)});
    }
    return all;
}

// Of --network; std::runtime_error.
static std::vector<NamedPeer> named_peers(const std::vector<std::string>& options) {
    std::vector<NamedPeer> all;
    for (const std::string& option : options) all.push_back(NamedPeer::from(option));
    return all;
}

ArmRun::ArmRun(ProcessorSystem& processor, Computer* computer, I2cDevices* i2c0,
               const RunPlan& plan, Recorder& recorder, BoardObserver& observer)
    : ProgramRun{*processor.arm, processor.bus, plan, recorder},
      network_{plan.description.program.network},
      processor_{processor},
      computer_{computer},
      cpu_{*processor.arm} {
    const ProgramDescription& program = plan.description.program;
    const auto print = [&observer](char c) { observer.console(c, SerialLine::UART); };
    const auto log = [&observer](const std::string& line) { observer.log(line); };
    const auto access = [&bus = processor.bus](bool write, std::uint32_t address,
                                               std::uint32_t& value) {
        sc_core::sc_time delay;
        return bus.transfer(write, address, reinterpret_cast<unsigned char*>(&value), sizeof value,
                            delay);
    };
    if (plan.on_linux)
        kernel_.emplace(cpu_,
                        LinuxSettings{program.linux_root, program.arguments, program.input,
                                      load_modules(program.modules), named_peers(program.network)},
                        LinuxKernel::Outside{print, log, access, i2c0, processor.pixel_buffer()});
    else
        semihosting_.emplace(cpu_, Semihosting::Outside{print, log});
    if (Profile* const wanted = profile()) cpu_.core().attach(wanted);
}

void ArmRun::plug_in(UsbPorts& usb) {
    if (kernel_) kernel_->plug_in(usb);
}

RunReport::Program ArmRun::program() const {
    RunReport::Program program = ProgramRun::program();
    program.exit_code = kernel_ ? kernel_->exit_code() : semihosting_->exit_code();
    program.network = network_;
    return program;
}

std::string ArmRun::waiting() const {
    if (!cpu_.position().ended) {
        if (kernel_ && !kernel_->waiting().empty()) return kernel_->waiting();
        if (terminal().waits()) return "standard input";
    }
    return ProgramRun::waiting();
}

std::vector<std::string> ArmRun::missed_interrupts() {
    return sim::missed_interrupts(processor_, computer_);
}

}  // namespace sim
