#include "sim/cpu/dynarmic/engine.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#ifdef __aarch64__
#include <sys/auxv.h>
#endif

#include "sim/cpu/dynarmic/direct.h"
#include "sim/cpu/dynarmic/instructions.h"
#include "sim/cpu/dynarmic/thread_registers.h"
#include "sim/cpu/transferred_words.h"

namespace sim {

namespace {

using Dynarmic::HaltReason;
constexpr HaltReason EVENT = HaltReason::UserDefined1;
constexpr std::size_t CODE_CACHE = 32 << 20;  // bytes; blocks that do not fit are translated again

// dynarmic 6.7's code for Arm reads a flag of 32 bits by an LDAR of 64, at an address that is a
// multiple of 4 alone: SIGBUS but where the processor has LSE2.
void check_host() {
#ifdef __aarch64__
    constexpr unsigned long USCAT = 1ul << 25;  // HWCAP_USCAT of the kernel: LSE2
    if (!(getauxval(AT_HWCAP) & USCAT))
        throw std::runtime_error{
            "this machine's processor is older than Armv8.4 (it has not LSE2), which dynarmic "
            "needs; build de1sim with -DDE1SIM_ARM_ENGINE=unicorn, or run --cpu native"};
#endif
}

}  // namespace

ArmCore::Engine::Engine(ArmCore& core, ArmBus& bus)
    : registers{cpu, mmu, translated, bus},
      core_{core},
      bus_{bus},
      data_{cpu, mmu, translated, inspectors, bus},
      system_{cpu, registers, mmu, data_, core} {
    check_host();
    using Dynarmic::OptimizationFlag;
    Dynarmic::A32::UserConfig config;
    config.callbacks = this;
    config.global_monitor = &monitor_;
    config.arch_version = Dynarmic::A32::ArchVersion::v7;
    // Returns and indirect branches must use the dispatcher, which checks the count.  Predicted
    // ones would not check it, and a loop of them would never end.
    config.optimizations = Dynarmic::all_safe_optimizations &
                           ~(OptimizationFlag::ReturnStackBuffer | OptimizationFlag::FastDispatch);
    config.page_table = mmu.direct();
    config.detect_misaligned_access_via_page_table = 16 | 32 | 64;
    config.coprocessors[15] = std::make_shared<ThreadRegisters>(cpu.cp15);
    config.hook_hint_instructions = true;
    config.check_halt_on_memory_access = true;
    config.code_cache_size = CODE_CACHE;
    cpu.jit = std::make_unique<Dynarmic::A32::Jit>(config);
}

// ---- What translated code calls -----------------------------------------------------------------

void ArmCore::Engine::AddTicks(std::uint64_t ticks) {
    if (stepping_) return;
    if (inspectors.tally) {
        called_ |= ticks & CodeReader::CALL;
        ticks &= CodeReader::TALLIED;
    }
    core_.count_ += ticks;
}

// Called by run_translated(), and again after each callback, when the instructions of the present
// block have not been subtracted yet.
std::uint64_t ArmCore::Engine::GetTicksRemaining() {
    const std::uint64_t done = core_.count_ + unaccounted_;
    const std::uint64_t left = core_.limit_ > done ? core_.limit_ - done : 0;
    std::uint64_t most = left > after_ ? left - after_ : 0;
    if (inspectors.tally) most = std::min(most, CodeReader::TALLIED / 2);
    return std::max<std::uint64_t>(std::exchange(unaccounted_, 0) + most, 1);
}

void ArmCore::Engine::CallSVC(std::uint32_t number) {
    const std::uint32_t pc = cpu.r()[15] - (cpu.thumb() ? 2 : 4);
    if (!stepping_ && code_.is_marked(pc) && done_directly(pc, number)) return;
    if (event_ == Event::NONE) event_ = Event::SVC;
    cpu.jit->HaltExecution(EVENT);
}

// Does the load or store at `pc`, which has been read as a supervisor call (code_reader.h).
// Registers are those before it, and `before` of its block's instructions are done.  False: it has
// aborted.
bool ArmCore::Engine::done_directly(std::uint32_t pc, std::uint32_t before) {
    const bool in_thumb = cpu.thumb();
    const auto word = code_.instruction(pc, in_thumb);
    const auto access = single_access(word.value_or(0), in_thumb, pc, cpu.r().data(), cpu.carry());
    unaccounted_ = before + 1;
    core_.count_ += unaccounted_;
    core_.last_pc_ = pc;
    words_ = 1;
    exclusive_ = false;
    data_.begin_step({access->bytes, false, false});
    const bool done = data_.transfer(*access);
    data_.end_step();
    core_.count_ -= unaccounted_;
    if (!done) {
        event_ = Event::ABORT;
        event_pc_ = pc;
        return false;
    }
    cpu.r()[15] = pc + (in_thumb && *word <= 0xFFFF ? 2 : 4);
    if (code_.settle(pc, data_.has_reached())) translated.invalidate(pc);
    return true;
}

void ArmCore::Engine::InterpreterFallback(std::uint32_t pc, std::size_t) {
    ExceptionRaised(pc, Dynarmic::A32::Exception::UndefinedInstruction);
}

void ArmCore::Engine::ExceptionRaised(std::uint32_t pc, Dynarmic::A32::Exception exception) {
    using Dynarmic::A32::Exception;
    switch (exception) {
        case Exception::SendEvent:
        case Exception::SendEventLocal:
        case Exception::Yield:
        case Exception::PreloadData:
        case Exception::PreloadDataWithIntentToWrite:
        case Exception::PreloadInstruction: return;
        case Exception::WaitForInterrupt:
            if (bus_.passes_wfi()) return;
            event_ = Event::HINT_WFI;
            break;
        case Exception::WaitForEvent: event_ = Event::HINT_WFE; break;
        case Exception::Breakpoint: event_ = Event::BREAKPOINT; break;
        case Exception::NoExecuteFault: event_ = Event::NO_CODE; break;
        default: event_ = Event::UNDEFINED; break;
    }
    event_pc_ = pc;
    cpu.jit->HaltExecution(EVENT);
}

// ---- Running ------------------------------------------------------------------------------------

std::optional<ArmStop> ArmCore::Engine::next(std::uint64_t left) {
    translated.forget_if_overfull();
    const std::uint32_t pc = cpu.r()[15];
    if (inspectors.is_probed(pc)) {
        if (inspectors.probe->before(pc)) return ArmStop::LIMIT;
        return step();
    }
    if (code_.is_marked(pc) && (inspectors.watch || !code_.is_direct(pc))) return step();
    const unsigned longest = reader_.longest();
    if (left > longest) return run_translated(longest, longest);
    const unsigned straight = code_.to_next_branch(pc, cpu.thumb());
    if (straight == Code::FAR && code_.is_blank(pc, cpu.thumb())) return ArmStop::RAN_OFF;
    if (straight > left || straight == Code::FAR) return step();
    // Nothing but this branch is executed until run() ends.
    const bool spins = straight == 1 && code_.is_spin(pc, cpu.thumb()) && it_state(cpu.cpsr()) == 0;
    return run_translated(static_cast<unsigned>(std::min<std::uint64_t>(left, Code::FAR - 1)),
                          spins ? 0 : longest);
}

std::optional<ArmStop> ArmCore::Engine::run_translated(unsigned without_branch, unsigned overrun) {
    const std::uint64_t before = core_.count_;
    const std::uint32_t begin = cpu.r()[15];
    const std::uint32_t link = cpu.r()[14];
    unaccounted_ = 0;
    after_ = overrun;
    event_ = Event::NONE;
    called_ = false;
    reader_.begin_run(without_branch);
    data_.begin_run();
    cpu.jit->Run();

    std::optional<ArmStop> stop;
    if (data_.is_missed()) {
        undo_miss();
    } else if (event_ == Event::NO_CODE) {
        --core_.count_;  // of the exception
        back_to_event(cpu.thumb());
        if (reader_.has_no_room()) {
            translated.invalidate(event_pc_);
        } else if (!code_.is_marked(event_pc_) && !inspectors.is_probed(event_pc_)) {
            stop = ended();
        }
    } else {
        stop = ended();
    }
    const std::uint64_t done = core_.count_ - before;
    if (inspectors.tally && done > 0) {
        const std::uint32_t now = cpu.r()[14];
        inspectors.tally->ran({begin, done, link, called_ ? now & ~1u : now + 1});
    }
    if (event_ == Event::NO_CODE && reader_.has_no_room() &&
        code_.to_next_branch(event_pc_, cpu.thumb()) == Code::FAR)
        return next(1);
    return stop;
}

// Translated code has reached an access that a step must do: restores the state before its
// instruction.
void ArmCore::Engine::undo_miss() {
    const std::uint32_t pc = cpu.r()[15], cpsr = cpu.cpsr();
    const bool in_thumb = cpu.thumb(), carry = cpsr >> 29 & 1;
    const std::uint32_t word = code_.instruction(pc, in_thumb).value_or(0);
    if (const auto change =
            early_write_back(word, in_thumb, cpu.r().data(), carry, data_.missed_address()))
        cpu.r()[change->base] -= change->added;
    core_.count_ += code_.done_before(pc, in_thumb);
    const bool direct =
        !(cpsr & arm_cpsr::IT) && single_access(word, in_thumb, pc, cpu.r().data(), carry);
    code_.mark(pc, direct);
    translated.invalidate(pc);
}

std::optional<ArmStop> ArmCore::Engine::step() {
    const std::uint32_t pc = cpu.r()[15], cpsr = cpu.cpsr();
    const auto saved = cpu.r();
    const auto saved_vfp = cpu.jit->ExtRegs();
    event_ = Event::NONE;
    reader_.begin_step();
    core_.last_pc_ = pc;
    ++core_.count_;
    const std::uint32_t word = code_.instruction(pc, cpu.thumb()).value_or(0);
    const Alignment required = alignment(word, cpu.thumb());
    words_ = transferred_words(word, cpu.thumb());
    exclusive_ = is_exclusive(word, cpu.thumb());
    data_.begin_step(required);
    if (data_.refuses_structure(word)) {
        data_.end_step();
        return data_abort();
    }
    stepping_ = true;
    cpu.jit->Step();
    std::optional<ArmStop> stop;
    if (data_.is_done()) stop = ended();
    const bool reached = required.beyond_pieces || data_.has_reached();
    data_.end_step();
    stepping_ = false;
    if (!data_.is_done()) {  // in translated code, or by a system instruction
        cpu.r() = saved;
        cpu.jit->ExtRegs() = saved_vfp;
        cpu.jit->SetCpsr(cpsr);
        if (data_.is_aborted()) return data_abort();
        --core_.count_;
        return ArmStop::LIMIT;
    }
    if (code_.settle(pc, reached)) translated.invalidate(pc);
    if (inspectors.tally)
        inspectors.tally->ran({pc, 1, saved[14], code_.after(pc, 1, cpsr & arm_cpsr::T)});
    return stop;
}

std::optional<ArmStop> ArmCore::Engine::step_by_bytes() {
    data_.set_by_bytes(true);
    const auto stop = step();
    data_.set_by_bytes(false);
    return stop;
}

ArmStop ArmCore::Engine::data_abort() {
    core_.fault_ = data_.fault();
    return ArmStop::DATA_ABORT;
}

// Dynarmic raises an exception with pc and the IT state after the instruction; this restores those
// of the instruction.
void ArmCore::Engine::back_to_event(bool in_thumb) {
    if (in_thumb) cpu.jit->SetCpsr(with_it_state(cpu.cpsr(), code_.it(event_pc_)));
    cpu.r()[15] = event_pc_;
}

// An instruction that is undefined to dynarmic.
std::optional<ArmStop> ArmCore::Engine::undefined() {
    const bool in_thumb = cpu.thumb();
    back_to_event(in_thumb);
    const auto word = code_.instruction(event_pc_, in_thumb);
    if (word && system_.execute(event_pc_, *word, in_thumb)) return std::nullopt;
    if (data_.is_aborted()) return data_abort();
    if (!data_.is_watched()) return ArmStop::UNDEFINED;
    if (!stepping_) --core_.count_;
    return ArmStop::LIMIT;
}

ArmStop ArmCore::Engine::no_code() {
    if (stepping_) --core_.count_;
    const bool in_thumb = cpu.thumb();
    back_to_event(in_thumb);
    const bool second = in_thumb && mmu.half_of_code(event_pc_);
    const std::uint32_t missing = second ? event_pc_ + 2 : event_pc_;
    const Mmu::Page& page = mmu.page(missing);
    core_.fault_ = {missing, false, page.no_code, page.status};
    translated.invalidate(event_pc_);
    return ArmStop::PREFETCH_ABORT;
}

// How the last instructions have ended, with pc as ArmStop says.
std::optional<ArmStop> ArmCore::Engine::ended() {
    switch (event_) {
        case Event::NONE: return std::nullopt;
        case Event::HINT_WFI: return ArmStop::WFI;
        case Event::HINT_WFE: return ArmStop::WFE;
        case Event::SVC: return ArmStop::SVC;
        case Event::ABORT: cpu.r()[15] = event_pc_; return data_abort();
        case Event::BREAKPOINT: back_to_event(cpu.thumb()); return ArmStop::BREAKPOINT;
        case Event::UNDEFINED: return undefined();
        case Event::NO_CODE: break;
    }
    return no_code();
}

}  // namespace sim
