// engine.h - runs the program on dynarmic, with exact counts and stops: in translated code where
// that is possible, in single steps where it is not.
//
// It is made of
//   CpuState            the registers
//   Mmu                 what an address is for the program
//   TranslatedCode      what dynarmic has translated, with what is known of it (code.h)
//   Inspectors          who looks at the program
//   SystemRegisters     an operating system's registers, written with all that it means
//   CodeReader          the code as dynarmic reads it
//   DataAccess          loads and stores that the page table does not serve
//   SystemInstructions  instructions that dynarmic does not have
// of which each knows some above it, and none knows the engine.
//
// Dynarmic calls CodeReader and DataAccess through the engine.  What else it calls is noted as an
// Event, and understood when it has returned.  How the count stays exact: code.h.
#pragma once

#include <dynarmic/interface/A32/a32.h>
#include <dynarmic/interface/exclusive_monitor.h>

#include <cstdint>
#include <optional>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/dynarmic/code_reader.h"
#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/data_access.h"
#include "sim/cpu/dynarmic/inspectors.h"
#include "sim/cpu/dynarmic/mmu.h"
#include "sim/cpu/dynarmic/system_instructions.h"
#include "sim/cpu/dynarmic/system_registers.h"
#include "sim/cpu/dynarmic/translated_code.h"

namespace sim {

struct ArmCore::Engine final : private Dynarmic::A32::UserCallbacks {
    Engine(ArmCore& core, ArmBus& bus);

    CpuState cpu;
    Mmu mmu{cpu};
    TranslatedCode translated{cpu, mmu};
    Inspectors inspectors;
    SystemRegisters registers;

    // Runs translated code or one instruction, of `left` that may be done at most.  Returns how it
    // ended, if run() has to end, too.
    std::optional<ArmStop> next(std::uint64_t left);
    // Executes one; its accesses as ArmCore::run_by_bytes() says.
    std::optional<ArmStop> step_by_bytes();

    // In an access to the bus.
    OnBus on_bus() const { return {words_, data_.cache(), cpu.privileged(), exclusive_}; }

private:
    // What happened in a callback.
    enum class Event { NONE, HINT_WFI, HINT_WFE, SVC, BREAKPOINT, UNDEFINED, NO_CODE, ABORT };

    // `overrun`: instructions that it may do after the end of its count.
    std::optional<ArmStop> run_translated(unsigned without_branch, unsigned overrun);
    std::optional<ArmStop> step();
    std::optional<ArmStop> ended();
    std::optional<ArmStop> undefined();
    ArmStop no_code();
    ArmStop data_abort();
    void back_to_event(bool in_thumb);
    void undo_miss();
    bool done_directly(std::uint32_t pc, std::uint32_t before);

    // ---- What dynarmic calls: to translate ----

    std::optional<std::uint32_t> MemoryReadCode(std::uint32_t address) override {
        return reader_.word(address);
    }
    bool IsReadOnlyMemory(std::uint32_t address) override { return reader_.is_constant(address); }
    std::uint64_t GetTicksForCode(bool thumb, std::uint32_t pc, std::uint32_t word) override {
        return reader_.ticks(thumb, pc, word);
    }

    // ---- ... to load and store ----

    std::uint8_t MemoryRead8(std::uint32_t address) override {
        return data_.load<std::uint8_t>(address);
    }
    std::uint16_t MemoryRead16(std::uint32_t address) override {
        return data_.load<std::uint16_t>(address);
    }
    std::uint32_t MemoryRead32(std::uint32_t address) override {
        return data_.load<std::uint32_t>(address);
    }
    std::uint64_t MemoryRead64(std::uint32_t address) override {
        translated.read_64(address);
        return data_.load<std::uint64_t>(address);
    }
    void MemoryWrite8(std::uint32_t address, std::uint8_t value) override {
        data_.store(address, value);
    }
    void MemoryWrite16(std::uint32_t address, std::uint16_t value) override {
        data_.store(address, value);
    }
    void MemoryWrite32(std::uint32_t address, std::uint32_t value) override {
        data_.store(address, value);
    }
    void MemoryWrite64(std::uint32_t address, std::uint64_t value) override {
        data_.store(address, value);
    }
    bool MemoryWriteExclusive8(std::uint32_t a, std::uint8_t v, std::uint8_t e) override {
        return data_.store_exclusive(a, v, e);
    }
    bool MemoryWriteExclusive16(std::uint32_t a, std::uint16_t v, std::uint16_t e) override {
        return data_.store_exclusive(a, v, e);
    }
    bool MemoryWriteExclusive32(std::uint32_t a, std::uint32_t v, std::uint32_t e) override {
        return data_.store_exclusive(a, v, e);
    }
    bool MemoryWriteExclusive64(std::uint32_t a, std::uint64_t v, std::uint64_t e) override {
        return data_.store_exclusive(a, v, e);
    }

    // ---- ... and else ----

    void AddTicks(std::uint64_t ticks) override;
    std::uint64_t GetTicksRemaining() override;
    void CallSVC(std::uint32_t number) override;
    void InterpreterFallback(std::uint32_t pc, std::size_t instructions) override;
    void ExceptionRaised(std::uint32_t pc, Dynarmic::A32::Exception exception) override;

    ArmCore& core_;
    ArmBus& bus_;
    Code& code_{translated.code};
    CodeReader reader_{cpu, mmu, translated, inspectors};
    DataAccess data_;
    SystemInstructions system_;
    Dynarmic::ExclusiveMonitor monitor_{1};

    bool stepping_ = false;          // one instruction is being done, whose count is added already
    unsigned words_ = 1;             // that the one being done transfers
    bool exclusive_ = false;         // it is LDREX, STREX or their like
    unsigned after_ = 0;             // instructions, by which the present run may do too many
    std::uint64_t unaccounted_ = 0;  // instructions of the present block, in a callback
    bool called_ = false;            // the run has ended with a call, for the tally
    Event event_ = Event::NONE;
    std::uint32_t event_pc_ = 0;
};

}  // namespace sim
