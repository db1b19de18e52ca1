#include "sim/cpu/arm_cpu.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "sim/cpu/arm_messages.h"
#include "sim/text/seconds.h"

namespace sim {

using sc_core::sc_time;
using sc_core::SC_ZERO_TIME;

namespace {

const sc_time reset_time{6, sc_core::SC_US};  // longer than that of the FPGA
constexpr std::uint64_t MASKED_QUANTUM = 64;  // while an interrupt is pending but masked
constexpr std::uint32_t PUSHED = 128;         // bytes, by one instruction

}  // namespace

ArmCpu::ArmCpu(const sc_core::sc_module_name& name, ArmProgram program, Log log)
    : ProgramCpu{name},
      program_{std::move(program)},
      log_{std::move(log)},
      core_{*this},
      time_{core_, program_.cpi},
      shortcuts_{core_, time_},
      handlers_{core_, time_, log_},
      runaway_{core_, program_.elf} {
    SC_HAS_PROCESS(ArmCpu);
    SC_THREAD(run);
    set_stack_size(STACK_BYTES);
}

// ---- Time ---------------------------------------------------------------------------------------

void ArmCpu::sync() {
    if (!time_.is_at_horizon()) return;
    wait(time_.ahead());
    time_.ahead() = SC_ZERO_TIME;
    shortcuts_.changed();
}

// Instructions until SystemC's next event.
std::uint64_t ArmCpu::budget() const {
    const std::uint64_t left = time_.budget();
    const bool looks_itself = !ArmCore::TELLS_OF_MASKS && (irq_ || fiq_);
    return looks_itself ? std::min(left, MASKED_QUANTUM) : left;
}

// After an access, which has advanced the time and may have changed the interrupt lines.
void ArmCpu::run_on() {
    const bool stop = pending_interrupt() || reset_ || waited_;
    core_.stop_after(stop ? 0 : std::min(budget(), inspected_end_ - core_.instructions()));
}

void ArmCpu::sleep(const sc_time& at_most) {
    shortcuts_.changed();
    wait(time_.ahead());
    time_.ahead() = SC_ZERO_TIME;
    asleep_since_ = sc_core::sc_time_stamp();
    asleep_ = true;
    if (!irq_ && !fiq_ && !abort_ && !reset_) {
        if (at_most == SC_ZERO_TIME)
            wait(wake_);
        else
            wait(at_most, wake_);
    }
    asleep_ = false;
    counts_.asleep += sc_core::sc_time_stamp() - asleep_since_;
}

template <class... Until>
void ArmCpu::pause_until(const Until&... until) {
    shortcuts_.changed();
    wait(time_.ahead());
    time_.ahead() = SC_ZERO_TIME;
    asleep_since_ = sc_core::sc_time_stamp();
    asleep_ = true;
    wait(until...);
    asleep_ = false;
    counts_.asleep += sc_core::sc_time_stamp() - asleep_since_;
}

void ArmCpu::pause(const sc_time& time) { pause_until(time); }
void ArmCpu::pause(const sc_core::sc_event& until, const sc_time& at_most) {
    if (!kernel_ || !inspector_) return pause_until(at_most, until);
    pause_until(at_most, until | inspect_);
    inspector_->on_idle(core_);
}

void ArmCpu::work(const sc_time& time) {
    time_.ahead() += time;
    sync();
}

void ArmCpu::end(const std::string& why) {
    ended_ = true;
    if (!why.empty()) fail(why);
}

void ArmCpu::interrupt(bool irq, bool fiq) {
    if (irq == irq_ && fiq == fiq_) return;
    irq_ = irq;
    fiq_ = fiq;
    if (!irq && !fiq) return;
    wake_.notify(SC_ZERO_TIME);
    if (kernel_ && irq) kernel_->interrupt_raised();
    if (running_) core_.stop_soon();
}

void ArmCpu::asynchronous_abort(const std::string& what, bool slave_error) {
    if (core_.cpsr() & arm_cpsr::A)
        log_(what + "; the processor masks asynchronous aborts (CPSR.A), and goes on");
    abort_ = {what, fault_status::ASYNCHRONOUS | fault_status::WRITE |
                        (slave_error ? fault_status::SLAVE_ERROR : 0)};
    wake_.notify(SC_ZERO_TIME);
    if (running_) core_.stop_soon();
}

void ArmCpu::warm_reset() {
    reset_ = true;
    wake_.notify(SC_ZERO_TIME);
    if (running_) core_.stop_soon();
}

void ArmCpu::hold_in_reset(bool held) {
    held_ = held;
    if (!held) released_.notify(SC_ZERO_TIME);
}

// ---- The program --------------------------------------------------------------------------------

void ArmCpu::start() {
    reset_ = false;
    abort_.reset();
    stores_.forget_page();
    runaway_.reset();
    handlers_.reset();
    core_.reset(program_.elf.entry, STACK);
    if (kernel_) kernel_->boot(core_);
}

void ArmCpu::run() {
    process_ = sc_core::sc_get_current_process_handle();
    while (held_) pause_until(released_);  // not for an inspector: there is nothing to see yet
    if (!kernel_) {
        map(0, 0xFFFFFFFF);
        load();
    }
    start();
    if (inspector_) inspector_->on_start(core_);
    while (!fault() && !ended_) {
        if (reset_) {
            log_(fmt::format("warm reset {}", where()));
            work(reset_time);
            while (held_) pause(released_, sc_core::sc_max_time() - sc_core::sc_time_stamp());
            start();
        }
        if (remap_) {
            map(remap_->first, remap_->last);
            remap_.reset();
        }
        time_.account();
        sync();
        if (kernel_ && now() >= alarm()) {
            set_alarm(sc_core::sc_max_time());
            kernel_->alarm(core_);
            continue;
        }
        if (!inspector_ || !inspector_->holds_interrupts()) take_interrupt();
        const bool closely = handlers_.is_watched_closely();
        const std::uint64_t part = closely ? 1 : shortened(std::max<std::uint64_t>(budget(), 1));
        const std::uint64_t most = std::max<std::uint64_t>(closely ? 1 : budget(), 1);
        const std::uint64_t limit = inspector_ ? inspector_->on_quantum(core_, most) : part;
        inspected_end_ = limit < most ? core_.instructions() + limit : UINT64_MAX;
        running_ = true;
        waited_ = false;
        const ArmStop stop = core_.run(std::min(limit, most));
        running_ = false;
        time_.account();
        if (stop != ArmStop::LIMIT || quantum_ends()) drain();
        time_.account();
        handlers_.log_handled();  // before it may sleep
        handle(stop);
        check();
    }
    drain();
}

// How many instructions to execute before the next look at the loop that the program may be in.
std::uint64_t ArmCpu::shortened(std::uint64_t most) {
    if (inspector_ || reset_ || pending_interrupt()) return most;
    return shortcuts_.pass(most, !stores_.is_empty());
}

// It does not where ArmShortcuts only looks again.
bool ArmCpu::quantum_ends() const {
    return time_.is_at_horizon() || reset_ ||
           (inspector_ && core_.instructions() >= inspected_end_);
}

std::optional<ArmException> ArmCpu::pending_interrupt() const {
    if (abort_ && !(core_.cpsr() & arm_cpsr::A)) return ArmException::ASYNCHRONOUS_ABORT;
    if (fiq_ && !(core_.cpsr() & arm_cpsr::F)) return ArmException::FIQ;
    if (irq_ && !(core_.cpsr() & arm_cpsr::I)) return ArmException::IRQ;
    return std::nullopt;
}

void ArmCpu::unmasked() {
    if (irq_ || fiq_ || abort_) core_.stop_soon();
}

void ArmCpu::take_interrupt() {
    const auto exception = pending_interrupt();
    if (!exception) return;
    if (*exception != ArmException::ASYNCHRONOUS_ABORT)
        return raise(*exception, 0, *exception == ArmException::FIQ ? "FIQ" : "IRQ");
    const Abort abort = *std::exchange(abort_, std::nullopt);
    raise(*exception, abort.status, "asynchronous data abort: " + abort.what);
}

void ArmCpu::handle(ArmStop stop) {
    switch (stop) {
        case ArmStop::LIMIT: break;
        case ArmStop::WFI: sleep(kernel_ ? wait_timeout() : SC_ZERO_TIME); break;
        case ArmStop::WFE: sleep(wait_timeout()); break;
        case ArmStop::SVC:
            if (inspector_ && inspector_->on_svc(core_)) break;
            if (kernel_)
                kernel_->call(core_);
            else if (semihosting_ && is_semihosting(core_))
                semihosting_(core_);
            else
                raise(ArmException::SVC, 0, "supervisor call");
            break;
        case ArmStop::UNDEFINED:
            raise(ArmException::UNDEFINED, 0, undefined_instruction(core_));
            break;
        case ArmStop::PREFETCH_ABORT:
            if (runaway_.enters_data(where(), callers())) break;
            raise(ArmException::PREFETCH_ABORT,
                  core_.fault().mmu ? core_.fault().status & 0x40F : fault_status::EXTERNAL,
                  "prefetch abort: no instruction to be read" + missing_code());
            break;
        case ArmStop::BREAKPOINT:
            raise(ArmException::PREFETCH_ABORT, fault_status::DEBUG, "breakpoint instruction");
            break;
        case ArmStop::RAN_OFF: fail_runaway("the program ran off its code into zeros"); break;
        case ArmStop::DATA_ABORT: {
            const ArmFault& f = core_.fault();
            const std::uint32_t direction = f.write ? fault_status::WRITE : 0;
            if (f.mmu && f.status == fault_status::ALIGNMENT)
                raise(ArmException::DATA_ABORT, f.status | direction,
                      unaligned_access(core_, kernel_ != nullptr));
            else if (f.mmu)
                raise(ArmException::DATA_ABORT, f.status | direction,
                      "data abort: refused by the translation tables");
            else
                raise(ArmException::DATA_ABORT, fault_status::EXTERNAL | direction,
                      fmt::format("data abort: {} of {} bytes at 0x{:08X} ({})",
                                  f.write ? "write" : "read", refused_bytes_, refused_address_,
                                  bus_answer_));
        }
    }
}

// Why there is no code at pc, and where it came from: " (LEDR holds no instructions; LR 0x...)".
std::string ArmCpu::missing_code() const {
    const std::optional<std::uint32_t> on_bus = core_.bus_address(core_.fault().address);
    if (kernel_ || core_.fault().mmu || !on_bus) return "";
    return fmt::format(" ({}; LR 0x{:08X}{})", why_refused(*on_bus), core_.reg(14), callers());
}

std::string ArmCpu::callers() const { return sim::callers(core_, program_.elf); }

std::string ArmCpu::where() const {
    const std::string function = program_.elf.function(core_.pc());
    return fmt::format("at {:.6f} ms, PC 0x{:08X}{}{}", seconds(now()) * 1e3, core_.pc(),
                       function.empty() ? "" : " in ", function);
}

void ArmCpu::raise(ArmException exception, std::uint32_t status, const std::string& what) {
    const bool asynchronous = is_asynchronous(exception);
    if (!asynchronous && inspector_ && exception != ArmException::SVC &&
        inspector_->on_exception(core_, exception, core_.fault()))
        return;
    if (kernel_ && !asynchronous) return kernel_->exception(core_, exception, core_.fault(), what);
    const bool abort = exception == ArmException::DATA_ABORT ||
                       exception == ArmException::PREFETCH_ABORT ||
                       exception == ArmException::ASYNCHRONOUS_ABORT;
    const bool abnormal = abort || exception == ArmException::UNDEFINED;
    if (abnormal)
        if (const auto astray = runaway_.in_data(what)) return fail_runaway(*astray);
    counts_.interrupts += asynchronous && !abort;
    counts_.aborts += abort;
    const std::uint32_t sp = core_.reg(13);
    const bool push = exception == ArmException::DATA_ABORT && sp - core_.fault().address <= PUSHED;
    const auto text = [&] {  // before the exception is entered
        const std::string stack =
            abnormal ? runaway_.stack_overflow(push ? core_.fault().address : sp, true) : "";
        return what + " " + where() + (stack.empty() ? "" : "; ") + stack;
    };
    const std::uint32_t vector = vector_of(core_, exception);
    handlers_.begin();
    const auto give_up = [&](const std::string& why) {
        if (inspector_ && inspector_->on_failure(core_, exception)) return;
        handlers_.failed_by(text());
        fail(text() + why + callers());
    };
    std::uint32_t word = 0;
    if (core_.pc() == vector && !asynchronous) return give_up(", in its own vector");
    if (!core_.read_ram(vector, &word, sizeof word) || word == 0)
        return give_up(fmt::format("; no vector at 0x{:08X}", vector));
    if (handlers_.happens_again(exception))
        return give_up(", for the second time within its handler");
    if (abnormal) handlers_.enter(exception, text());
    const bool debug = status == fault_status::DEBUG;  // there, IFAR is UNKNOWN
    enter(core_, exception, status, abort && !debug ? core_.fault().address : core_.pc());
}

void ArmCpu::fail_runaway(const std::string& what) {
    const std::string stack = runaway_.stack_overflow(core_.reg(13), true);
    const std::string why =
        fmt::format("{} {}; {}LR 0x{:08X}{}", what, where(), stack.empty() ? "" : stack + "; ",
                    core_.reg(14), callers());
    if (inspector_ && inspector_->on_failure(core_, ArmException::UNDEFINED)) return;
    handlers_.failed();
    fail(why);
}

// After each quantum: whether the program has failed, or has ended.
void ArmCpu::check() {
    const bool stands_still = handlers_.stands_still() && !(kernel_ && kernel_->may_interrupt());
    if (!kernel_ && !fault())
        if (const auto astray = runaway_.check(stands_still)) fail_runaway(*astray);
    if (const auto failure = handlers_.has_open() ? handlers_.failure(where()) : std::nullopt) {
        const bool goes_on = inspector_ && inspector_->on_failure(core_, handlers_.exception());
        handlers_.conclude_failure(goes_on);
        if (!goes_on) fail(*failure);
    }
    if (!ended_ && (inspector_ || handlers_.has_open() || !stands_still))
        over_since_.reset();
    else if (!over_since_)
        over_since_ = now();
}

sc_time ArmCpu::ended_for() const {
    return over_since_ ? sc_core::sc_time_stamp() - std::min(*over_since_, sc_core::sc_time_stamp())
                       : SC_ZERO_TIME;
}

std::optional<std::string> ArmCpu::unfinished() const { return handlers_.unfinished(where()); }

void ArmCpu::conclude() {
    handlers_.end(fault() || unfinished());
    final_ = position();
}

ArmCpu::Position ArmCpu::position() {
    if (final_) return *final_;
    const std::uint32_t pc = present_pc();
    return {pc, program_.elf.function(pc), asleep_, ended_,
            asleep_ ? std::nullopt : shortcuts_.polled(pc)};
}

ArmCpu::Counts ArmCpu::counts() const {
    Counts counts = counts_;
    counts.instructions = core_.instructions();
    counts.on_bus += shortcuts_.on_bus();
    if (asleep_) counts.asleep += sc_core::sc_time_stamp() - asleep_since_;
    return counts;
}

}  // namespace sim
