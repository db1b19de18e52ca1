#include "sim/run/arm_run.h"

#include <stdexcept>

#include <fmt/format.h>

#include "sim/chip/computer.h"
#include "sim/report/seconds.h"
#include "sim/report/whole_file.h"
#include "sim/run/file_kind.h"

namespace sim {

bool runs_on_linux(const RunOptions& options) {
    refuse_no_program(options.elf);
    return options.system == "linux" || (options.system == "auto" && expects_linux(options.elf));
}

ArmProgram load_program(const RunOptions& options, bool on_linux) {
    if (!on_linux && !options.arguments.empty())
        throw std::runtime_error{options.elf.string() +
                                 ": arguments behind -- are for Linux programs (--system linux)"};
    if (!on_linux && !options.linux_root.empty())
        throw std::runtime_error{options.elf.string() +
                                 ": --linux-root is for Linux programs (--system linux)"};
    if (!on_linux && !options.input.empty())
        throw std::runtime_error{options.elf.string() +
                                 ": --stdin is for Linux programs (--system linux)"};
    ElfProgram elf = load_elf(options.elf, on_linux ? linux_memory() : program_memory());
    if (!on_linux) elf.leave_only_sections();
    return {std::move(elf), options.cpi};
}

ArmRun::ArmRun(ArmCpu& cpu, Bus& bus, I2cDevices* i2c0, const RunOptions& options, bool on_linux,
               Recorder& recorder, BoardObserver& observer)
    : options_{options}, cpu_{cpu}, bus_{bus} {
    const auto print = [&observer](char c) { observer.console(c, SerialLine::UART); };
    const auto log = [&observer](const std::string& line) { observer.log(line); };
    const auto access = [&bus](bool write, std::uint32_t address, std::uint32_t& value) {
        sc_core::sc_time delay;
        return bus.transfer(write, address, reinterpret_cast<unsigned char*>(&value), sizeof value,
                            delay);
    };
    if (on_linux)
        kernel_.emplace(cpu, LinuxSettings{options.linux_root, options.arguments, options.input},
                        LinuxKernel::Outside{print, log, access, i2c0});
    else
        semihosting_.emplace(cpu, Semihosting::Outside{print, log});
    if (!options.profile.empty() || traces_a_part(options)) {
        profile_.emplace(cpu.program().elf);
        cpu.core().attach(&*profile_);
    }
    if (traces_a_part(options))
        calls_.emplace(*profile_, cpu,
                       options.trace_to ? sc_core::sc_time::from_value(options.trace_to->ps)
                                        : sc_core::sc_max_time());
    recorder.on_frame = [this] { budget_.frame_ended(cpu_.counts(), sc_core::sc_time_stamp()); };
}

void ArmRun::plug_in(Ps2Keyboard& keyboard, Ps2Mouse& mouse) {
    if (!kernel_) return;
    LinuxInput& input = kernel_->input();
    keyboard.set_listener([&input](std::uint16_t key, bool down) { input.key(key, down); });
    mouse.set_listener({[&input](int right, int up) { input.move(right, up); },
                        [&input](int notches) { input.turn(notches); },
                        [&input](MouseButton which, bool down) {
                            input.button(static_cast<unsigned>(which), down);
                        }});
}

RunReport::Program ArmRun::program() const {
    const ArmCpu::Counts counts = cpu_.counts();
    const ArmCpu::Position at = cpu_.position();
    RunReport::Program program;
    program.elf = cpu_.program().elf.file.string();
    program.cpi = cpu_.program().cpi;
    program.instructions = counts.instructions;
    program.interrupts = counts.interrupts;
    program.aborts = counts.aborts;
    program.asleep_s = seconds(counts.asleep);
    program.on_bus_s = seconds(counts.on_bus);
    program.pc = at.pc;
    program.function = at.function;
    program.frames = budget_.figures();
    program.exit_code = kernel_ ? kernel_->exit_code() : semihosting_->exit_code();
    program.waiting = waiting();
    return program;
}

std::string ArmRun::waiting() const {
    const ArmCpu::Position at = cpu_.position();
    if (at.ended) return "nothing: it has ended";
    if (kernel_ && !kernel_->waiting().empty()) return kernel_->waiting();
    if (terminal().waits()) return "standard input";
    if (at.sleeping) return "an interrupt";
    if (at.polled) {
        const std::string name = bus_.register_at(*at.polled);
        return fmt::format("a change of 0x{:08X}{}{}{}", *at.polled, name.empty() ? "" : " (", name,
                           name.empty() ? "" : ")");
    }
    return "";
}

void ArmRun::write_profile() const {
    if (!options_.profile.empty()) write_whole_file(options_.profile, profile_->callgrind());
}

}  // namespace sim
