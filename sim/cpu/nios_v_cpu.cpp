#include "sim/cpu/nios_v_cpu.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/text/seconds.h"

namespace sim {

using sc_core::sc_time;
using sc_core::SC_ZERO_TIME;

namespace {

constexpr double CLOCK_PS = 10'000;  // 100 MHz
constexpr unsigned MANY_REPETITIONS = 1000, MANY_POLLS = 16;
constexpr std::uint32_t EXIT = 93;  // newlib's number of the environment call
constexpr unsigned RA = 1, A0 = 10, A7 = 17;
const sc_time spin_limit{100, sc_core::SC_MS}, handler_grace{1, sc_core::SC_MS};

// Of floating point by the vendor's manual, "Floating Point Operations".
RiscvClocks nios_v_clocks() {
    RiscvClocks clocks;
    clocks.taken = clocks.jump = 3;
    clocks.multiply = 3;
    clocks.divide = 35;
    clocks.float_multiply = 2;
    clocks.float_fused = 3;
    clocks.float_divide = 14;
    clocks.float_root = 12;
    clocks.float_convert = 3;
    clocks.float_choose = 2;
    return clocks;
}

}  // namespace

NiosVCpu::NiosVCpu(const sc_core::sc_module_name& name, NiosVProgram program, Log log)
    : ProgramCpu{name},
      program_{std::move(program)},
      log_{std::move(log)},
      abort_log_{log_},
      core_{*this, RiscvFpu::Style::NIOS_V, nios_v_clocks()},
      runaway_{core_, program_.elf},
      time_{core_, static_cast<std::uint64_t>(std::llround(CLOCK_PS * program_.cpi))} {
    SC_HAS_PROCESS(NiosVCpu);
    SC_THREAD(run);
    set_stack_size(STACK_BYTES);
}

// ---- Time ---------------------------------------------------------------------------------------

void NiosVCpu::sync() {
    if (!time_.is_at_horizon()) return;
    wait(time_.ahead());
    time_.ahead() = SC_ZERO_TIME;
    ++events_;
}

// After an access, which has advanced the time and may have changed the lines.
void NiosVCpu::run_on() {
    if (waited_ || core_.pending_interrupt())
        core_.stop_soon();
    else
        core_.stop_after(time_.budget());
}

void NiosVCpu::sleep() {
    wait(time_.ahead());
    time_.ahead() = SC_ZERO_TIME;
    ++events_;
    asleep_since_ = sc_core::sc_time_stamp();
    asleep_ = true;
    while (!core_.is_pending() && !woken_) wait(wake_);
    asleep_ = false;
    counts_.asleep += sc_core::sc_time_stamp() - asleep_since_;
}

void NiosVCpu::set_lines(std::uint32_t lines) {
    if (lines == lines_) return;
    lines_ = lines;
    core_.set_pending(lines);
    if (!core_.is_pending()) return;
    wake_.notify(SC_ZERO_TIME);
    if (running_) core_.stop_soon();
}

std::uint64_t NiosVCpu::cycles() { return now().value() / static_cast<std::uint64_t>(CLOCK_PS); }

// ---- The program --------------------------------------------------------------------------------

void NiosVCpu::run() {
    process_ = sc_core::sc_get_current_process_handle();
    map();
    load();
    core_.reset(program_.elf.entry);
    if (inspector_) inspector_->on_start();
    while (!fault() && !ended_) {
        time_.account();
        sync();
        if (!inspector_ || !inspector_->holds_interrupts()) take_interrupt();
        woken_ = false;
        const bool steps = inspector_ && inspector_->on_quantum();
        running_ = true;
        waited_ = false;
        const RiscvStop stop =
            steps ? core_.step() : core_.run(std::max<std::uint64_t>(time_.budget(), 1));
        running_ = false;
        time_.account();
        if (stop == RiscvStop::WFI) sleep();
        if (stop == RiscvStop::TRAP) trapped(core_.trap());
        check();
    }
}

void NiosVCpu::take_interrupt() {
    const auto interrupt = core_.pending_interrupt();
    if (!interrupt) return;
    if (!core_.has_set_mtvec()) {
        if (inspector_ && inspector_->on_failure(interrupt->cause)) return;
        fail(fmt::format("interrupt {} came {}; it has no handler: mtvec was never written",
                         interrupt->cause & ~riscv_cause::INTERRUPT, where()));
        return;
    }
    ++counts_.interrupts;
    core_.enter(*interrupt);
    handler_ = core_.pc();
}

std::string NiosVCpu::describe(const RiscvTrap& trap) const {
    using namespace riscv_cause;
    switch (trap.cause) {
        case FETCH_MISALIGNED:
            return fmt::format("jump to 0x{:08X}, which is no multiple of 4", trap.value);
        case FETCH_FAULT:
            return fmt::format("no instruction to be read at 0x{:08X} ({}; ra 0x{:08X}{})",
                               trap.value, why_refused(trap.value), core_.reg(RA), callers());
        case ILLEGAL:
            if (trap.value == 0) return "the program ran off its code into zeros";
            if ((trap.value & 3) != 3)
                return fmt::format(
                    "illegal instruction 0x{:04X}: a compressed one, which Nios V does not have "
                    "(-march=rv32im_zicsr)",
                    trap.value & 0xFFFF);
            return fmt::format("illegal instruction 0x{:08X}", trap.value);
        case BREAKPOINT: return "breakpoint instruction";
        case LOAD_MISALIGNED:
        case STORE_MISALIGNED:
            return fmt::format("{} at 0x{:08X} is not aligned",
                               trap.cause == LOAD_MISALIGNED ? "load" : "store", trap.value);
        case LOAD_FAULT:
        case STORE_FAULT:
            return fmt::format("access fault: {} at 0x{:08X} ({})",
                               trap.cause == LOAD_FAULT ? "load" : "store", trap.value,
                               bus_answer_);
        default: return "environment call (ecall)";
    }
}

// It ends the program as it is meant to.  The board's debugger, which has loaded the program, takes
// EBREAK for itself, whether there is a handler or not.
bool NiosVCpu::ends(const RiscvTrap& trap) {
    if (trap.cause == riscv_cause::BREAKPOINT)
        log_("the program has stopped for a debugger (ebreak) " + where());
    else if (trap.cause == riscv_cause::ECALL && core_.reg(A7) == EXIT && !core_.has_set_mtvec())
        exit_code_ = static_cast<int>(core_.reg(A0));
    else
        return false;
    ended_ = true;
    over_since_ = now();
    return true;
}

// Why the program cannot recover from this trap, or "".
std::string NiosVCpu::hopeless(const RiscvTrap& trap) {
    if (!core_.has_set_mtvec()) return "; it has no handler: mtvec was never written";
    if (const std::uint32_t pc = core_.pc(); pc == handler_ || pc == core_.handler(trap)) {
        const std::string no_code = runaway_.no_code_at(pc);
        return no_code.empty() ? ", at the first instruction of its own handler"
                               : fmt::format("; mtvec (0x{:08X}) leads to 0x{:08X}, {}",
                                             core_.csr(riscv_csr::MTVEC).value(), pc, no_code);
    }
    if (const std::string data = runaway_.data_at(core_.pc()); !data.empty())
        return fmt::format("; the program has gone into its data, {}", data);
    if (in_handler() && core_.pc() == nested_pc_) return ", for the second time within its handler";
    nested_pc_ = in_handler() ? core_.pc() : 1;
    std::array<std::uint32_t, 33> state{};
    for (unsigned i = 0; i < 32; ++i) state[i] = core_.reg(i);
    state[32] = core_.pc();
    repetitions_ = state == repeated_ ? repetitions_ + 1 : 1;
    repeated_ = state;
    return repetitions_ >= MANY_REPETITIONS && trap.cause != riscv_cause::ECALL
               ? fmt::format(", to which its handler has returned {} times", repetitions_)
               : "";
}

void NiosVCpu::trapped(const RiscvTrap& trap) {
    using namespace riscv_cause;
    if (trap.cause == BREAKPOINT && inspector_ && inspector_->on_breakpoint()) return;
    if (ends(trap)) return;
    counts_.aborts +=
        trap.cause == FETCH_FAULT || trap.cause == LOAD_FAULT || trap.cause == STORE_FAULT;
    const bool failed = trap.cause != ECALL && trap.cause != BREAKPOINT;
    const std::string stack =
        failed ? runaway_.stack_at_trap(trap.cause == STORE_FAULT ? std::optional{trap.value}
                                                                  : std::nullopt)
               : "";
    const std::string what = describe(trap) + " " + where() + (stack.empty() ? "" : "; ") + stack;
    if (const std::string why = hopeless(trap); !why.empty()) {
        if (inspector_ && inspector_->on_failure(trap.cause)) return;
        abort_log_.failed(what);
        fail(what + why + callers());
        return;
    }
    if (failed) {
        abort_log_.happened(trap.cause, core_.pc(), what);
        if (!in_handler()) open_ = Open{trap.cause, what, core_.returns(), now(), {}};
    }
    core_.enter(trap);
    handler_ = core_.pc();
}

// On a jump to itself, which only an interrupt could end.
bool NiosVCpu::stands_still() const {
    constexpr std::uint32_t JUMP_TO_ITSELF = 0x0000006F, BRANCH_TO_ITSELF = 0x00000063;
    std::uint32_t word = 0;
    const bool masked = !(core_.csr(riscv_csr::MSTATUS).value() & riscv_mstatus::MIE) ||
                        core_.csr(riscv_csr::MIE).value() == 0;
    return masked && core_.read_ram(core_.pc(), &word, sizeof word) &&
           (word == JUMP_TO_ITSELF || word == BRANCH_TO_ITSELF);
}

// After each quantum: whether the program has failed, or has ended.
void NiosVCpu::check() {
    if (open_ && !in_handler()) {
        abort_log_.handled();
        open_.reset();
    }
    if (ended_ || fault()) return;
    if (const std::string stack = runaway_.check(); !stack.empty()) {
        if (inspector_ && inspector_->on_failure(riscv_cause::STORE_FAULT)) return;
        fail("the program ran out of stack " + where() + "; " + stack + callers());
        return;
    }
    if (!stands_still()) {
        over_since_.reset();
        if (open_) open_->spins_from.reset();
    } else if (!open_) {
        if (!over_since_ && !inspector_) over_since_ = now();
    } else if (!open_->spins_from) {
        open_->spins_from = now();
    } else if (now() - *open_->spins_from >= spin_limit) {
        open_->spins_from.reset();
        if (inspector_ && inspector_->on_failure(open_->cause)) return;
        abort_log_.failed(open_->text);
        fail(open_->text + "; its handler loops for ever, " + where());
    }
}

std::optional<std::string> NiosVCpu::unfinished() const {
    if (!in_handler() || sc_core::sc_time_stamp() < open_->since + handler_grace)
        return std::nullopt;
    return open_->text + "; its handler was not left, " + where();
}

sc_time NiosVCpu::ended_for() const {
    const sc_time stamp = sc_core::sc_time_stamp();
    return over_since_ ? stamp - std::min(*over_since_, stamp) : SC_ZERO_TIME;
}

// ---- Words --------------------------------------------------------------------------------------

std::string NiosVCpu::named(std::uint32_t address) const {
    const std::string function = program_.elf.function(address);
    return fmt::format("0x{:08X}{}{}", address, function.empty() ? "" : " in ", function);
}

std::string NiosVCpu::where() const {
    return fmt::format("at {:.6f} ms, PC {}", seconds(now()) * 1e3, named(core_.pc()));
}

std::string NiosVCpu::callers() const {
    const std::string caller = program_.elf.function(core_.reg(RA));
    return caller.empty() ? "" : "; called from " + caller;
}

std::string NiosVCpu::accessed() const { return ", " + where(); }

void NiosVCpu::conclude() {
    if (fault() || unfinished()) abort_log_.handled();
    abort_log_.end();
    final_ = position();
}

ProgramCpu::Position NiosVCpu::position() {
    if (final_) return *final_;
    const std::uint32_t pc = core_.pc();
    return {pc, program_.elf.function(pc), asleep_, ended_,
            !asleep_ && polls_ >= MANY_POLLS ? std::optional{polled_} : std::nullopt};
}

ProgramCpu::Counts NiosVCpu::counts() const {
    Counts counts = counts_;
    counts.instructions = core_.instructions();
    if (asleep_) counts.asleep += sc_core::sc_time_stamp() - asleep_since_;
    return counts;
}

}  // namespace sim
