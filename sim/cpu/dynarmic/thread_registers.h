// thread_registers.h - the coprocessor registers that translated code accesses by itself: TPIDRURW,
// TPIDRURO.
#pragma once

#include <dynarmic/interface/A32/coprocessor.h>

#include "sim/cpu/dynarmic/cp15.h"

namespace sim {

// Thread registers of CP15, which translated code reads and writes by itself.  All other
// instructions of coprocessors are undefined to dynarmic (code_reader.h).
class ThreadRegisters final : public Dynarmic::A32::Coprocessor {
public:
    explicit ThreadRegisters(Cp15Registers& cp15) : cp15_{cp15} {}

private:
    using Register = Dynarmic::A32::CoprocReg;
    CallbackOrAccessOneWord word(unsigned op2) {
        return op2 == 2 ? &cp15_.tpidrurw : &cp15_.tpidruro;
    }
    CallbackOrAccessOneWord CompileSendOneWord(bool, unsigned, Register, Register,
                                               unsigned op2) override {
        return word(op2);
    }
    CallbackOrAccessOneWord CompileGetOneWord(bool, unsigned, Register, Register,
                                              unsigned op2) override {
        return word(op2);
    }
    std::optional<Callback> CompileInternalOperation(bool, unsigned, Register, Register, Register,
                                                     unsigned) override {
        return std::nullopt;
    }
    CallbackOrAccessTwoWords CompileSendTwoWords(bool, unsigned, Register) override { return {}; }
    CallbackOrAccessTwoWords CompileGetTwoWords(bool, unsigned, Register) override { return {}; }
    std::optional<Callback> CompileLoadWords(bool, bool, Register,
                                             std::optional<std::uint8_t>) override {
        return std::nullopt;
    }
    std::optional<Callback> CompileStoreWords(bool, bool, Register,
                                              std::optional<std::uint8_t>) override {
        return std::nullopt;
    }

    Cp15Registers& cp15_;
};

}  // namespace sim
