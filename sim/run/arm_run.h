// arm_run.h - what a run with --cpu arm has besides: its ELF, a kernel for Linux programs, figures.
#pragma once

#include <memory>
#include <optional>

#include "sim/board/signal_receiver.h"
#include "sim/board/usb_ports.h"
#include "sim/chip/computer.h"
#include "sim/cpu/arm_cpu.h"
#include "sim/debug/semihosting.h"
#include "sim/linux/kernel.h"
#include "sim/run/plan.h"
#include "sim/run/program_run.h"

namespace sim {

// ElfError; std::runtime_error for options that only a Linux program has.
ArmProgram load_program(const RunPlan& plan);

class ArmRun final : public ProgramRun, public SignalReceiver {
public:
    // `processor` has an ArmCpu.  Attaches to that, and to the recorder's frames.  What a Linux
    // program prints, or another by semihosting, goes to `observer`.
    // `computer` is `processor` where the chip has this project's own fabric, or null.
    ArmRun(ProcessorSystem& processor, Computer* computer, I2cDevices* i2c0, const RunPlan& plan,
           Recorder& recorder, BoardObserver& observer);

    // At the console of these; or that nobody will.
    void type(const std::string& text) { terminal().type(text); }
    void close_input() { terminal().close(); }
    // Of a Linux program.
    void send(unsigned signal, int process) override {
        kernel_->signal_from_outside(signal, process);
    }
    // What is on the board's USB ports, for a Linux program.
    void plug_in(UsbPorts& usb);

    bool on_linux() const override { return kernel_.has_value(); }
    std::vector<std::string> missing_calls() const override {
        return kernel_ ? kernel_->missing() : std::vector<std::string>{};
    }
    // Of its modules, as `dmesg` shows them; or "".
    std::string kernel_messages() const { return kernel_ ? kernel_->messages() : ""; }
    RunReport::Program program() const override;
    std::string waiting() const override;
    std::vector<std::string> missed_interrupts() override;

private:
    Terminal& terminal() { return kernel_ ? kernel_->terminal() : semihosting_->terminal(); }
    const Terminal& terminal() const {
        return kernel_ ? kernel_->terminal() : semihosting_->terminal();
    }

    const std::vector<std::string> network_;  // that a Linux program reaches
    ProcessorSystem& processor_;
    Computer* const computer_;
    ArmCpu& cpu_;
    std::optional<LinuxKernel> kernel_;
    std::optional<Semihosting> semihosting_;  // where there is no kernel
};

}  // namespace sim
