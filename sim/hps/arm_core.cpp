#include "sim/hps/arm_core.h"

#include <unicorn/unicorn.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace sim {

namespace {

// QEMU's numbers of exceptions, which UC_HOOK_INTR gives.
constexpr int EXCP_SWI = 2, EXCP_PREFETCH_ABORT = 3, EXCP_DATA_ABORT = 4, EXCP_BKPT = 7;

constexpr int REGISTERS[] = {UC_ARM_REG_R0,  UC_ARM_REG_R1, UC_ARM_REG_R2,  UC_ARM_REG_R3,
                             UC_ARM_REG_R4,  UC_ARM_REG_R5, UC_ARM_REG_R6,  UC_ARM_REG_R7,
                             UC_ARM_REG_R8,  UC_ARM_REG_R9, UC_ARM_REG_R10, UC_ARM_REG_R11,
                             UC_ARM_REG_R12, UC_ARM_REG_SP, UC_ARM_REG_LR,  UC_ARM_REG_PC};

constexpr std::uint32_t BANK = 0;  // of CP15's two, the one that programs see

constexpr std::uint32_t SCR_NS = 1, SCR_FW = 1u << 4, SCR_AW = 1u << 5;

constexpr std::uint64_t NEVER = 1;  // an `until` that no program counter equals

void check(uc_err error, const char* what) {
    if (error != UC_ERR_OK)
        throw std::runtime_error{std::string{"unicorn: "} + what + ": " + uc_strerror(error)};
}

}  // namespace

struct ArmCore::Engine {
    struct Ram {
        std::uint32_t base;
        std::uint64_t size;
        std::uint8_t* bytes;
    };
    struct Window {
        ArmCore* core;
        std::uint32_t bus_base;
        std::uint32_t base;
        std::uint64_t size;
    };

    uc_engine* uc = nullptr;
    uc_hook watch = 0;
    std::vector<Ram> ram;
    std::vector<std::unique_ptr<Window>> windows;

    Engine() {
        check(uc_open(UC_ARCH_ARM, UC_MODE_ARM, &uc), "uc_open");
        check(uc_ctl_set_cpu_model(uc, UC_CPU_ARM_CORTEX_A9), "cpu model");
    }
    ~Engine() { uc_close(uc); }

    const Ram* find(std::uint32_t address, std::size_t bytes) const {
        for (const Ram& area : ram) {
            const std::uint32_t offset = address - area.base;
            if (offset < area.size && bytes <= area.size - offset) return &area;
        }
        return nullptr;
    }
};

struct ArmCore::Hooks {
    // Before every instruction.  Costs most of what this simulator takes, and buys exactness: it
    // makes Unicorn keep the program counter right, in bus accesses too.
    static void instruction(uc_engine* uc, std::uint64_t address, std::uint32_t, void* self) {
        ArmCore& core = *static_cast<ArmCore*>(self);
        if (core.count_ >= core.limit_) {
            uc_emu_stop(uc);
            return;
        }
        if (core.probe_ && core.probe_->before(static_cast<std::uint32_t>(address))) {
            core.limit_ = core.count_;
            uc_emu_stop(uc);
            return;
        }
        ++core.count_;
        core.last_pc_ = static_cast<std::uint32_t>(address);
    }

    static void interrupt(uc_engine* uc, std::uint32_t number, void* self) {
        static_cast<ArmCore*>(self)->exception_ = static_cast<int>(number);
        uc_emu_stop(uc);
    }

    // uc_emu_stop here leaves pc at the load, its register as it was: it would be repeated by the
    // next uc_emu_start, which is right for an abort and for nothing else.
    static std::uint64_t read(uc_engine* uc, std::uint64_t offset, unsigned bytes, void* window) {
        const auto& [core, bus_base, base, size] = *static_cast<Engine::Window*>(window);
        const std::uint32_t address = bus_base + static_cast<std::uint32_t>(offset);
        std::uint32_t value = 0;
        if (!core->aborted_ && !core->watched_ && !core->bus_.read(address, bytes, value))
            core->abort(uc, address, false);
        return value;
    }
    static void write(uc_engine* uc, std::uint64_t offset, unsigned bytes, std::uint64_t value,
                      void* window) {
        const auto& [core, bus_base, base, size] = *static_cast<Engine::Window*>(window);
        const std::uint32_t address = bus_base + static_cast<std::uint32_t>(offset);
        if (!core->aborted_ && !core->watched_ &&
            !core->bus_.write(address, bytes, static_cast<std::uint32_t>(value)))
            core->abort(uc, address, true);
    }

    // A load or store where nothing is mapped, or that the mapping does not allow.
    static bool unmapped(uc_engine*, uc_mem_type type, std::uint64_t address, int, std::int64_t,
                         void* self) {
        ArmCore& core = *static_cast<ArmCore*>(self);
        core.aborted_ = true;
        core.fault_ = {static_cast<std::uint32_t>(address),
                       type == UC_MEM_WRITE_UNMAPPED || type == UC_MEM_WRITE_PROT, true};
        return false;
    }

    // Before each access, of which an instruction can have several.
    static void access(uc_engine* uc, uc_mem_type type, std::uint64_t address, int bytes,
                       std::int64_t, void* self) {
        ArmCore& core = *static_cast<ArmCore*>(self);
        if (core.watched_ ||
            !core.watch_->touched(static_cast<std::uint32_t>(address), static_cast<unsigned>(bytes),
                                  type == UC_MEM_WRITE))
            return;
        core.watched_ = true;
        uc_emu_stop(uc);
    }
};

ArmCore::ArmCore(ArmBus& bus) : engine_{std::make_unique<Engine>()}, bus_{bus} {
    uc_hook hook;
    check(uc_hook_add(engine_->uc, &hook, UC_HOOK_CODE,
                      reinterpret_cast<void*>(&Hooks::instruction), this, 1, 0),
          "hook of instructions");
    check(uc_hook_add(engine_->uc, &hook, UC_HOOK_INTR, reinterpret_cast<void*>(&Hooks::interrupt),
                      this, 1, 0),
          "hook of exceptions");
    check(uc_hook_add(engine_->uc, &hook,
                      UC_HOOK_MEM_READ_UNMAPPED | UC_HOOK_MEM_WRITE_UNMAPPED |
                          UC_HOOK_MEM_READ_PROT | UC_HOOK_MEM_WRITE_PROT,
                      reinterpret_cast<void*>(&Hooks::unmapped), this, 1, 0),
          "hook of wrong accesses");
}

ArmCore::~ArmCore() = default;

void ArmCore::watch(ArmWatch* watch) {
    if (watch && !watch_) {
        check(uc_hook_add(engine_->uc, &engine_->watch, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE,
                          reinterpret_cast<void*>(&Hooks::access), this, 1, 0),
              "hook of accesses");
        // What is translated looks away.  UC_CTL_TB_FLUSH takes 2 s, this some milliseconds.
        for (const Engine::Ram& area : engine_->ram)
            uc_ctl_remove_cache(engine_->uc, area.base, area.base + area.size);
    }
    if (!watch && watch_) check(uc_hook_del(engine_->uc, engine_->watch), "end of a hook");
    watch_ = watch;
}

void ArmCore::map_ram(std::uint32_t base, std::uint64_t size, void* bytes, unsigned access) {
    check(uc_mem_map_ptr(engine_->uc, base, size, access, bytes), "map of RAM");
    engine_->ram.push_back({base, size, static_cast<std::uint8_t*>(bytes)});
}

void ArmCore::map_bus(std::uint32_t base, std::uint64_t size, std::uint32_t bus_base,
                      unsigned access) {
    engine_->windows.push_back(
        std::make_unique<Engine::Window>(Engine::Window{this, bus_base, base, size}));
    void* window = engine_->windows.back().get();
    check(uc_mmio_map(engine_->uc, base, size, access & arm_access::READ ? &Hooks::read : nullptr,
                      window, access & arm_access::WRITE ? &Hooks::write : nullptr, window),
          "map of the bus");
}

void ArmCore::unmap(std::uint32_t base, std::uint64_t size) {
    check(uc_mem_unmap(engine_->uc, base, size), "unmapping");
    auto& ram = engine_->ram;
    ram.erase(std::remove_if(ram.begin(), ram.end(),
                             [base](const Engine::Ram& area) { return area.base == base; }),
              ram.end());
    auto& windows = engine_->windows;
    windows.erase(std::remove_if(windows.begin(), windows.end(),
                                 [base](const auto& window) { return window->base == base; }),
                  windows.end());
}

std::optional<std::uint32_t> ArmCore::bus_address(std::uint32_t address) const {
    for (const auto& window : engine_->windows)
        if (address - window->base < window->size)
            return window->bus_base + (address - window->base);
    return std::nullopt;
}

void ArmCore::abort(void* uc, std::uint32_t address, bool write) {
    aborted_ = true;
    fault_ = {address, write, false};
    uc_emu_stop(static_cast<uc_engine*>(uc));
}

void ArmCore::reset(std::uint32_t entry, std::uint32_t stack) {
    // Unicorn's core is in the Non-secure state, where it ignores changes of A and F but for these.
    set_cp15(cp15::SCR, SCR_NS | SCR_FW | SCR_AW);
    set_cpsr(arm_mode::SVC | arm_cpsr::A | arm_cpsr::I | arm_cpsr::F |
             (entry & 1 ? arm_cpsr::T : 0));
    set_cp15(cp15::SCTLR, 0x00C50078);
    set_cp15(cp15::VBAR, 0);
    set_cp15(cp15::CPACR, 0x00F00000);
    set_cp15(cp15::CBAR, 0xFFFEC000);
    const std::uint32_t enable = 1u << 30;
    check(uc_reg_write(engine_->uc, UC_ARM_REG_FPEXC, &enable), "FPEXC");
    for (unsigned number = 0; number < 15; ++number) set_reg(number, 0);
    set_reg(13, stack);
    set_reg(15, entry);
}

ArmStop ArmCore::run(std::uint64_t limit) {
    limit_ = count_ + limit;
    const std::uint64_t begin = count_;
    exception_ = 0;
    aborted_ = watched_ = false;
    const std::uint32_t thumb = cpsr() & arm_cpsr::T ? 1 : 0;
    const uc_err error = uc_emu_start(engine_->uc, pc() | thumb, NEVER, 0, 0);

    if (watched_) return ArmStop::LIMIT;
    if (aborted_) return ArmStop::DATA_ABORT;
    if (exception_ == EXCP_SWI) return ArmStop::SVC;
    fault_ = {0, false, exception_ == EXCP_DATA_ABORT || exception_ == EXCP_PREFETCH_ABORT};
    if (exception_ == EXCP_DATA_ABORT) return ArmStop::DATA_ABORT;
    if (exception_ == EXCP_BKPT) return ArmStop::BREAKPOINT;
    if (exception_ == EXCP_PREFETCH_ABORT || error == UC_ERR_FETCH_PROT ||
        error == UC_ERR_FETCH_UNMAPPED)
        return ArmStop::PREFETCH_ABORT;
    // WFI ends uc_emu_start without a word, WFE and YIELD as if they were undefined.
    const bool executed = count_ != begin && pc() != last_pc_;
    if (executed && (error == UC_ERR_OK || error == UC_ERR_INSN_INVALID)) {
        switch (hint()) {
            case 1: return ArmStop::LIMIT;
            case 2: return ArmStop::WFE;
            case 3: return ArmStop::WFI;
            default: break;
        }
    }
    if (exception_ != 0 || error == UC_ERR_INSN_INVALID || error == UC_ERR_EXCEPTION) {
        set_reg(15, last_pc_);  // SMC and HVC have gone past themselves
        return ArmStop::UNDEFINED;
    }
    check(error, "uc_emu_start");
    return ArmStop::LIMIT;
}

// The number of the hint that the last instruction was: 1 YIELD, 2 WFE, 3 WFI; else 0.
unsigned ArmCore::hint() const {
    std::uint16_t half[2];
    if (!read_ram(last_pc_, half, sizeof half)) return 0;
    if (cpsr() & arm_cpsr::T) {
        if ((half[0] & 0xff0f) == 0xbf00) return half[0] >> 4 & 0xf;
        return half[0] == 0xf3af && (half[1] & 0xff00) == 0x8000 ? half[1] & 0xff : 0;
    }
    const std::uint32_t word = half[0] | static_cast<std::uint32_t>(half[1]) << 16;
    return (word & 0x0fffff00) == 0x0320f000 ? word & 0xff : 0;
}

std::uint32_t ArmCore::reg(unsigned number) const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, REGISTERS[number & 15], &value);
    return value;
}

// Unicorn takes T from bit 0 of a written pc.
void ArmCore::set_reg(unsigned number, std::uint32_t value) {
    if (number == 15) value = (value & ~1u) | (cpsr() & arm_cpsr::T ? 1 : 0);
    uc_reg_write(engine_->uc, REGISTERS[number & 15], &value);
}

std::uint32_t ArmCore::cpsr() const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_CPSR, &value);
    return value;
}

void ArmCore::set_cpsr(std::uint32_t value) { uc_reg_write(engine_->uc, UC_ARM_REG_CPSR, &value); }

std::uint32_t ArmCore::spsr() const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_SPSR, &value);
    return value;
}

void ArmCore::set_spsr(std::uint32_t value) { uc_reg_write(engine_->uc, UC_ARM_REG_SPSR, &value); }

std::uint64_t ArmCore::vfp(unsigned number) const {
    std::uint64_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_D0 + static_cast<int>(number & 31), &value);
    return value;
}

void ArmCore::set_vfp(unsigned number, std::uint64_t value) {
    uc_reg_write(engine_->uc, UC_ARM_REG_D0 + static_cast<int>(number & 31), &value);
}

std::uint32_t ArmCore::fpscr() const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_FPSCR, &value);
    return value;
}

void ArmCore::set_fpscr(std::uint32_t value) {
    uc_reg_write(engine_->uc, UC_ARM_REG_FPSCR, &value);
}

std::uint32_t ArmCore::cp15(const Cp15& name) const {
    uc_arm_cp_reg reg{15, 0, BANK, name.crn, name.crm, name.op1, name.op2, 0};
    check(uc_reg_read(engine_->uc, UC_ARM_REG_CP_REG, &reg), "CP15");
    return static_cast<std::uint32_t>(reg.val);
}

void ArmCore::set_cp15(const Cp15& name, std::uint32_t value) {
    uc_arm_cp_reg reg{15, 0, BANK, name.crn, name.crm, name.op1, name.op2, value};
    check(uc_reg_write(engine_->uc, UC_ARM_REG_CP_REG, &reg), "CP15");
}

bool ArmCore::read_ram(std::uint32_t address, void* data, std::size_t bytes) const {
    const Engine::Ram* area = engine_->find(address, bytes);
    if (area) std::memcpy(data, area->bytes + (address - area->base), bytes);
    return area != nullptr;
}

bool ArmCore::write_ram(std::uint32_t address, const void* data, std::size_t bytes) {
    const Engine::Ram* area = engine_->find(address, bytes);
    if (!area) return false;
    std::memcpy(area->bytes + (address - area->base), data, bytes);
    forget_translations(address, bytes);
    return true;
}

void ArmCore::forget_translations(std::uint32_t address, std::size_t bytes) {
    uc_ctl_remove_cache(engine_->uc, address, address + bytes);
}

}  // namespace sim
