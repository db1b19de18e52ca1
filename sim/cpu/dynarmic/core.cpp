// core.cpp - ArmCore's run(): translated code where possible, single steps where necessary.
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

ArmCore::Engine::Engine(ArmCore& core_, ArmBus& bus_) : core{core_}, bus{bus_} {
    check_host();
    using Dynarmic::OptimizationFlag;
    Dynarmic::A32::UserConfig config;
    config.callbacks = this;
    config.global_monitor = &monitor;
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

const bool ArmCore::TELLS_OF_MASKS = true;

ArmCore::ArmCore(ArmBus& bus) : engine_{std::make_unique<Engine>(*this, bus)} {}
ArmCore::~ArmCore() = default;

// ---- What translated code calls -----------------------------------------------------------------

void ArmCore::Engine::AddTicks(std::uint64_t ticks) {
    if (stepping) return;
    if (inspectors.tally) {
        called |= ticks & CodeReader::CALL;
        ticks &= CodeReader::TALLIED;
    }
    core.count_ += ticks;
}

// Called by run_translated(), and again after each callback, when the instructions of the present
// block have not been subtracted yet.
std::uint64_t ArmCore::Engine::GetTicksRemaining() {
    const std::uint64_t done = core.count_ + unaccounted;
    const std::uint64_t left = core.limit_ > done ? core.limit_ - done : 0;
    std::uint64_t most = left > after ? left - after : 0;
    if (inspectors.tally) most = std::min(most, CodeReader::TALLIED / 2);
    return std::max<std::uint64_t>(std::exchange(unaccounted, 0) + most, 1);
}

void ArmCore::Engine::CallSVC(std::uint32_t number) {
    const std::uint32_t pc = cpu.r()[15] - (cpu.thumb() ? 2 : 4);
    if (!stepping && code.is_marked(pc) && done_directly(pc, number)) return;
    if (event == Event::NONE) event = Event::SVC;
    cpu.jit->HaltExecution(EVENT);
}

// Does the load or store at `pc`, which has been read as a supervisor call (code_reader.h).
// Registers are those before it, and `before` of its block's instructions are done.  False: it has
// aborted.
bool ArmCore::Engine::done_directly(std::uint32_t pc, std::uint32_t before) {
    const bool in_thumb = cpu.thumb();
    const auto word = code.instruction(pc, in_thumb);
    const auto access = single_access(word.value_or(0), in_thumb, pc, cpu.r().data(), cpu.carry());
    unaccounted = before + 1;
    core.count_ += unaccounted;
    core.last_pc_ = pc;
    data.begin_step({access->bytes, false, false});
    const bool done = data.transfer(*access);
    data.end_step();
    core.count_ -= unaccounted;
    if (!done) {
        event = Event::ABORT;
        event_pc = pc;
        return false;
    }
    cpu.r()[15] = pc + (in_thumb && *word <= 0xFFFF ? 2 : 4);
    if (code.settle(pc, data.has_reached())) translated.invalidate(pc);
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
            if (bus.passes_wfi()) return;
            event = Event::HINT_WFI;
            break;
        case Exception::WaitForEvent: event = Event::HINT_WFE; break;
        case Exception::Breakpoint: event = Event::BREAKPOINT; break;
        case Exception::NoExecuteFault: event = Event::NO_CODE; break;
        default: event = Event::UNDEFINED; break;
    }
    event_pc = pc;
    cpu.jit->HaltExecution(EVENT);
}

// ---- Running ------------------------------------------------------------------------------------

ArmStop ArmCore::run(std::uint64_t limit) {
    limit_ = count_ + limit;
    while (count_ < limit_)
        if (const auto stop = engine_->next(limit_ - count_)) return *stop;
    return ArmStop::LIMIT;
}

ArmStop ArmCore::run_by_bytes() {
    engine_->data.set_by_bytes(true);
    const auto stop = engine_->step();
    engine_->data.set_by_bytes(false);
    return stop.value_or(ArmStop::LIMIT);
}

std::optional<ArmStop> ArmCore::Engine::next(std::uint64_t left) {
    translated.forget_if_overfull();
    const std::uint32_t pc = cpu.r()[15];
    if (inspectors.is_probed(pc)) {
        if (inspectors.probe->before(pc)) return ArmStop::LIMIT;
        return step();
    }
    if (code.is_marked(pc) && (inspectors.watch || !code.is_direct(pc))) return step();
    const unsigned longest = reader.longest();
    if (left > longest) return run_translated(longest, longest);
    const unsigned straight = code.to_next_branch(pc, cpu.thumb());
    if (straight == Code::FAR && code.is_blank(pc, cpu.thumb())) return ArmStop::RAN_OFF;
    if (straight > left || straight == Code::FAR) return step();
    // Nothing but this branch is executed until run() ends.
    const bool spins = code.is_spin(pc, cpu.thumb()) && it_state(cpu.cpsr()) == 0;
    return run_translated(static_cast<unsigned>(std::min<std::uint64_t>(left, Code::FAR - 1)),
                          spins ? 0 : longest);
}

std::optional<ArmStop> ArmCore::Engine::run_translated(unsigned without_branch, unsigned overrun) {
    const std::uint64_t before = core.count_;
    const std::uint32_t begin = cpu.r()[15];
    const std::uint32_t link = cpu.r()[14];
    unaccounted = 0;
    after = overrun;
    event = Event::NONE;
    called = false;
    reader.begin_run(without_branch);
    data.begin_run();
    cpu.jit->Run();

    std::optional<ArmStop> stop;
    if (data.is_missed()) {
        undo_miss();
    } else if (event == Event::NO_CODE) {
        --core.count_;  // of the exception
        back_to_event();
        if (reader.has_no_room()) {
            translated.invalidate(event_pc);
        } else if (!code.is_marked(event_pc) && !inspectors.is_probed(event_pc)) {
            stop = ended();
        }
    } else {
        stop = ended();
    }
    const std::uint64_t done = core.count_ - before;
    if (inspectors.tally && done > 0) {
        const std::uint32_t now = cpu.r()[14];
        inspectors.tally->ran({begin, done, link, called ? now & ~1u : now + 1});
    }
    if (event == Event::NO_CODE && reader.has_no_room() &&
        code.to_next_branch(event_pc, cpu.thumb()) == Code::FAR)
        return next(1);
    return stop;
}

// Translated code has reached an access that a step must do: restores the state before its
// instruction.
void ArmCore::Engine::undo_miss() {
    const std::uint32_t pc = cpu.r()[15], cpsr = cpu.cpsr();
    const bool in_thumb = cpu.thumb(), carry = cpsr >> 29 & 1;
    const std::uint32_t word = code.instruction(pc, in_thumb).value_or(0);
    if (const auto change =
            early_write_back(word, in_thumb, cpu.r().data(), carry, data.missed_address()))
        cpu.r()[change->base] -= change->added;
    core.count_ += code.done_before(pc, in_thumb);
    const bool direct =
        !(cpsr & arm_cpsr::IT) && single_access(word, in_thumb, pc, cpu.r().data(), carry);
    code.mark(pc, direct);
    translated.invalidate(pc);
}

std::optional<ArmStop> ArmCore::Engine::step() {
    const std::uint32_t pc = cpu.r()[15], cpsr = cpu.cpsr();
    const auto saved = cpu.r();
    const auto saved_vfp = cpu.jit->ExtRegs();
    event = Event::NONE;
    reader.begin_step();
    core.last_pc_ = pc;
    ++core.count_;
    const std::uint32_t word = code.instruction(pc, cpu.thumb()).value_or(0);
    const Alignment required = alignment(word, cpu.thumb());
    data.begin_step(required);
    if (data.refuses_structure(word)) {
        data.end_step();
        return data_abort();
    }
    stepping = true;
    cpu.jit->Step();
    std::optional<ArmStop> stop;
    if (data.is_done()) stop = ended();
    const bool reached = required.beyond_pieces || data.has_reached();
    data.end_step();
    stepping = false;
    if (!data.is_done()) {  // in translated code, or by a system instruction
        cpu.r() = saved;
        cpu.jit->ExtRegs() = saved_vfp;
        cpu.jit->SetCpsr(cpsr);
        if (data.is_aborted()) return data_abort();
        --core.count_;
        return ArmStop::LIMIT;
    }
    if (code.settle(pc, reached)) translated.invalidate(pc);
    if (inspectors.tally)
        inspectors.tally->ran({pc, 1, saved[14], code.after(pc, 1, cpsr & arm_cpsr::T)});
    return stop;
}

ArmStop ArmCore::Engine::data_abort() {
    core.fault_ = data.fault();
    return ArmStop::DATA_ABORT;
}

// Dynarmic raises an exception with pc and the IT state after the instruction; this restores those
// of the instruction.
void ArmCore::Engine::back_to_event() {
    if (cpu.thumb()) cpu.jit->SetCpsr(with_it_state(cpu.cpsr(), code.it(event_pc)));
    cpu.r()[15] = event_pc;
}

// An instruction that is undefined to dynarmic.
std::optional<ArmStop> ArmCore::Engine::undefined() {
    back_to_event();
    const bool in_thumb = cpu.thumb();
    const auto word = code.instruction(event_pc, in_thumb);
    if (word && system.execute(event_pc, *word, in_thumb)) return std::nullopt;
    if (data.is_aborted()) return data_abort();
    if (!data.is_watched()) return ArmStop::UNDEFINED;
    if (!stepping) --core.count_;
    return ArmStop::LIMIT;
}

ArmStop ArmCore::Engine::no_code() {
    if (stepping) --core.count_;
    back_to_event();
    const bool second = cpu.thumb() && mmu.half_of_code(event_pc);
    const std::uint32_t missing = second ? event_pc + 2 : event_pc;
    const Mmu::Page& page = mmu.page(missing);
    core.fault_ = {missing, false, page.no_code, page.status};
    translated.invalidate(event_pc);
    return ArmStop::PREFETCH_ABORT;
}

// How the last instructions have ended, with pc as ArmStop says.
std::optional<ArmStop> ArmCore::Engine::ended() {
    switch (event) {
        case Event::NONE: return std::nullopt;
        case Event::HINT_WFI: return ArmStop::WFI;
        case Event::HINT_WFE: return ArmStop::WFE;
        case Event::SVC: return ArmStop::SVC;
        case Event::ABORT: cpu.r()[15] = event_pc; return data_abort();
        case Event::BREAKPOINT: back_to_event(); return ArmStop::BREAKPOINT;
        case Event::UNDEFINED: return undefined();
        case Event::NO_CODE: break;
    }
    return no_code();
}

}  // namespace sim
