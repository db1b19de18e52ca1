// engine.h - what ArmCore's files share: dynarmic, its callbacks, and the state around it.
//
//   core.cpp      run(): translated code, single steps, what they end with
//   registers.cpp ArmCore's registers and memory, seen from outside
#pragma once

#include <dynarmic/interface/A32/a32.h>
#include <dynarmic/interface/exclusive_monitor.h>

#include <optional>
#include <utility>

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

struct ArmCore::Engine final : Dynarmic::A32::UserCallbacks {
    Engine(ArmCore& core, ArmBus& bus);

    ArmCore& core;
    ArmBus& bus;
    CpuState cpu;
    Mmu mmu{cpu};
    TranslatedCode translated{cpu, mmu};
    Code& code{translated.code};
    Dynarmic::ExclusiveMonitor monitor{1};

    SystemRegisters registers{cpu, mmu, translated, bus};
    Inspectors inspectors;
    CodeReader reader{cpu, mmu, translated, inspectors};
    DataAccess data{cpu, mmu, translated, inspectors, bus};
    SystemInstructions system{cpu, registers, mmu, data, core};
    bool called = false;

    // ---- core.cpp ----

    // Runs translated code or one instruction.  Returns how it ended, if run() has to end, too.
    std::optional<ArmStop> next(std::uint64_t left);
    // `overrun`: instructions that it may do after the end of its count.
    std::optional<ArmStop> run_translated(unsigned without_branch, unsigned overrun);
    std::optional<ArmStop> step();
    std::optional<ArmStop> ended();
    std::optional<ArmStop> undefined();
    ArmStop no_code();
    void back_to_event();
    void undo_miss();
    ArmStop data_abort();

    // What happened in a callback.
    enum class Event { NONE, HINT_WFI, HINT_WFE, SVC, BREAKPOINT, UNDEFINED, NO_CODE, ABORT };
    Event event = Event::NONE;
    std::uint32_t event_pc = 0;
    bool stepping = false;          // one instruction is being done, and may do anything
    std::uint64_t unaccounted = 0;  // instructions of the present block, in a callback
    bool done_directly(std::uint32_t pc, std::uint32_t before);

    unsigned after = 0;  // instructions, by which the present run may do too many

    // ---- Reading code ----

    std::optional<std::uint32_t> MemoryReadCode(std::uint32_t address) override {
        return reader.word(address);
    }
    bool IsReadOnlyMemory(std::uint32_t address) override { return reader.is_constant(address); }
    std::uint64_t GetTicksForCode(bool thumb, std::uint32_t pc, std::uint32_t word) override {
        return reader.ticks(thumb, pc, word);
    }

    // ---- Loads and stores ----

    std::uint8_t MemoryRead8(std::uint32_t address) override {
        return data.load<std::uint8_t>(address);
    }
    std::uint16_t MemoryRead16(std::uint32_t address) override {
        return data.load<std::uint16_t>(address);
    }
    std::uint32_t MemoryRead32(std::uint32_t address) override {
        return data.load<std::uint32_t>(address);
    }
    std::uint64_t MemoryRead64(std::uint32_t address) override {
        translated.read_64(address);
        return data.load<std::uint64_t>(address);
    }
    void MemoryWrite8(std::uint32_t address, std::uint8_t value) override {
        data.store(address, value);
    }
    void MemoryWrite16(std::uint32_t address, std::uint16_t value) override {
        data.store(address, value);
    }
    void MemoryWrite32(std::uint32_t address, std::uint32_t value) override {
        data.store(address, value);
    }
    void MemoryWrite64(std::uint32_t address, std::uint64_t value) override {
        data.store(address, value);
    }
    bool MemoryWriteExclusive8(std::uint32_t a, std::uint8_t v, std::uint8_t e) override {
        return data.store_exclusive(a, v, e);
    }
    bool MemoryWriteExclusive16(std::uint32_t a, std::uint16_t v, std::uint16_t e) override {
        return data.store_exclusive(a, v, e);
    }
    bool MemoryWriteExclusive32(std::uint32_t a, std::uint32_t v, std::uint32_t e) override {
        return data.store_exclusive(a, v, e);
    }
    bool MemoryWriteExclusive64(std::uint32_t a, std::uint64_t v, std::uint64_t e) override {
        return data.store_exclusive(a, v, e);
    }

    // ---- core.cpp ----

    void InterpreterFallback(std::uint32_t pc, std::size_t) override;
    void CallSVC(std::uint32_t) override;
    void ExceptionRaised(std::uint32_t pc, Dynarmic::A32::Exception exception) override;
    void AddTicks(std::uint64_t ticks) override;
    std::uint64_t GetTicksRemaining() override;
};

}  // namespace sim
