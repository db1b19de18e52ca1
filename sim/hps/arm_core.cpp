#include "sim/hps/arm_engine.h"

namespace sim {

namespace {

// QEMU's numbers of exceptions, which UC_HOOK_INTR gives.
constexpr int EXCP_SWI = 2, EXCP_PREFETCH_ABORT = 3, EXCP_DATA_ABORT = 4, EXCP_BKPT = 7;

constexpr std::uint64_t NEVER = 1;  // an `until` that no program counter equals

}  // namespace

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
    check_uc(uc_hook_add(engine_->uc, &hook, UC_HOOK_CODE,
                         reinterpret_cast<void*>(&Hooks::instruction), this, 1, 0),
             "hook of instructions");
    check_uc(uc_hook_add(engine_->uc, &hook, UC_HOOK_INTR,
                         reinterpret_cast<void*>(&Hooks::interrupt), this, 1, 0),
             "hook of exceptions");
    check_uc(uc_hook_add(engine_->uc, &hook,
                         UC_HOOK_MEM_READ_UNMAPPED | UC_HOOK_MEM_WRITE_UNMAPPED |
                             UC_HOOK_MEM_READ_PROT | UC_HOOK_MEM_WRITE_PROT,
                         reinterpret_cast<void*>(&Hooks::unmapped), this, 1, 0),
             "hook of wrong accesses");
}

ArmCore::~ArmCore() = default;

void ArmCore::watch(ArmWatch* watch) {
    if (watch && !watch_) {
        check_uc(uc_hook_add(engine_->uc, &engine_->watch, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE,
                             reinterpret_cast<void*>(&Hooks::access), this, 1, 0),
                 "hook of accesses");
        // What is translated looks away.  UC_CTL_TB_FLUSH takes 2 s, this some milliseconds.
        for (const Engine::Ram& area : engine_->ram)
            uc_ctl_remove_cache(engine_->uc, area.base, area.base + area.size);
    }
    if (!watch && watch_) check_uc(uc_hook_del(engine_->uc, engine_->watch), "end of a hook");
    watch_ = watch;
}

void ArmCore::map_bus(std::uint32_t base, std::uint64_t size, std::uint32_t bus_base,
                      unsigned access) {
    engine_->windows.push_back(
        std::make_unique<Engine::Window>(Engine::Window{this, bus_base, base, size}));
    void* window = engine_->windows.back().get();
    check_uc(
        uc_mmio_map(engine_->uc, base, size, access & arm_access::READ ? &Hooks::read : nullptr,
                    window, access & arm_access::WRITE ? &Hooks::write : nullptr, window),
        "map of the bus");
}

void ArmCore::abort(void* uc, std::uint32_t address, bool write) {
    aborted_ = true;
    fault_ = {address, write, false};
    uc_emu_stop(static_cast<uc_engine*>(uc));
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
    check_uc(error, "uc_emu_start");
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

}  // namespace sim
