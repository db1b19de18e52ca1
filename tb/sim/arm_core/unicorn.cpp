// Unicorn, which is QEMU's processor, as a Machine.
#include <unicorn/unicorn.h>

#include <stdexcept>

#include "tb/sim/arm_core/machine.h"

namespace tb::core {

namespace {

constexpr int REGISTERS[] = {UC_ARM_REG_R0,  UC_ARM_REG_R1, UC_ARM_REG_R2,  UC_ARM_REG_R3,
                             UC_ARM_REG_R4,  UC_ARM_REG_R5, UC_ARM_REG_R6,  UC_ARM_REG_R7,
                             UC_ARM_REG_R8,  UC_ARM_REG_R9, UC_ARM_REG_R10, UC_ARM_REG_R11,
                             UC_ARM_REG_R12, UC_ARM_REG_SP, UC_ARM_REG_LR};

void check(uc_err error, const char* what) {
    if (error != UC_ERR_OK)
        throw std::runtime_error{std::string{"unicorn: "} + what + ": " + uc_strerror(error)};
}

class Unicorn final : public Machine {
public:
    Unicorn() {
        check(uc_open(UC_ARCH_ARM, UC_MODE_ARM, &uc_), "open");
        check(uc_ctl_set_cpu_model(uc_, UC_CPU_ARM_CORTEX_A9), "model");
        check(uc_mem_map_ptr(uc_, CODE, PART, UC_PROT_ALL, memory->code.data()), "code");
        for (std::uint32_t i = 0; i < PARTS; ++i)
            for (const std::uint32_t base : {DATA, FAR_DATA})
                check(uc_mem_map_ptr(uc_, base + i * PART, PART, UC_PROT_ALL, memory->data.data()),
                      "data");
        uc_hook hook;
        check(
            uc_hook_add(uc_, &hook, UC_HOOK_INTR, reinterpret_cast<void*>(&interrupt), this, 1, 0),
            "hook");
        set_cp15(1, 0, 0, 2, 0x00F00000);  // CPACR
        set_cp15(1, 0, 1, 0, 0x30);        // SCR: CPSR.A and F can be changed
        const std::uint32_t enable = 1u << 30;
        check(uc_reg_write(uc_, UC_ARM_REG_FPEXC, &enable), "FPEXC");
    }
    ~Unicorn() override { uc_close(uc_); }

    void set(const State& state) override {
        uc_reg_write(uc_, UC_ARM_REG_CPSR, &state.cpsr);
        for (unsigned i = 0; i < 15; ++i) uc_reg_write(uc_, REGISTERS[i], &state.r[i]);
        for (unsigned i = 0; i < 32; ++i)
            uc_reg_write(uc_, UC_ARM_REG_D0 + static_cast<int>(i), &state.d[i]);
        uc_reg_write(uc_, UC_ARM_REG_FPSCR, &state.fpscr);
    }
    State state() const override {
        State state;
        for (unsigned i = 0; i < 15; ++i) uc_reg_read(uc_, REGISTERS[i], &state.r[i]);
        for (unsigned i = 0; i < 32; ++i)
            uc_reg_read(uc_, UC_ARM_REG_D0 + static_cast<int>(i), &state.d[i]);
        uc_reg_read(uc_, UC_ARM_REG_CPSR, &state.cpsr);
        uc_reg_read(uc_, UC_ARM_REG_FPSCR, &state.fpscr);
        return state;
    }

    std::uint32_t run(std::uint32_t begin, std::uint32_t end, unsigned) override {
        return emulate(begin, end, 0);
    }
    std::uint32_t run_on(std::uint32_t begin, unsigned instructions) override {
        return emulate(begin, NEVER, instructions);
    }

    void code_changed(std::uint32_t begin, std::uint32_t bytes) override {
        check(uc_ctl_remove_cache(uc_, begin, begin + bytes), "removal of translations");
    }

private:
    static constexpr std::uint32_t NEVER = 1;

    std::uint32_t emulate(std::uint32_t begin, std::uint32_t end, unsigned instructions) {
        exception_ = 0;
        std::uint32_t cpsr = 0, pc = 0;
        uc_reg_read(uc_, UC_ARM_REG_CPSR, &cpsr);
        const uc_err error = uc_emu_start(uc_, begin | (cpsr >> 5 & 1), end, 0, instructions);
        uc_reg_read(uc_, UC_ARM_REG_PC, &pc);
        if (error == UC_ERR_INSN_INVALID || exception_ == EXCEPTION_UNDEFINED)
            return pc + UNDEFINED;
        return error == UC_ERR_OK && exception_ == 0 ? pc : OTHER;
    }
    static constexpr std::uint32_t EXCEPTION_UNDEFINED = 1;

    static void interrupt(uc_engine* uc, std::uint32_t number, void* self) {
        static_cast<Unicorn*>(self)->exception_ = number;
        uc_emu_stop(uc);
    }
    void set_cp15(std::uint32_t crn, std::uint32_t op1, std::uint32_t crm, std::uint32_t op2,
                  std::uint32_t value) {
        const uc_arm_cp_reg reg{15, 0, 0, crn, crm, op1, op2, value};
        check(uc_reg_write(uc_, UC_ARM_REG_CP_REG, &reg), "CP15");
    }

    uc_engine* uc_ = nullptr;
    std::uint32_t exception_ = 0;
};

}  // namespace

std::unique_ptr<Machine> unicorn() { return std::make_unique<Unicorn>(); }

}  // namespace tb::core
