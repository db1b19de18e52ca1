#include "sim/cpu/transferred_words.h"
#include "sim/cpu/unicorn/engine.h"

namespace sim {

namespace {

// QEMU's numbers of exceptions, which UC_HOOK_INTR gives.
constexpr int EXCP_SWI = 2, EXCP_PREFETCH_ABORT = 3, EXCP_DATA_ABORT = 4, EXCP_BKPT = 7;

constexpr std::uint64_t NEVER = 1;  // an `until` that the program counter never equals

// The number of the hint that the last instruction was: 1 YIELD, 2 WFE, 3 WFI; else 0.
unsigned hint(const ArmCore& core) {
    std::uint16_t half[2];
    if (!core.read_ram(core.instruction(), half, sizeof half)) return 0;
    if (core.cpsr() & arm_cpsr::T) {
        if ((half[0] & 0xff0f) == 0xbf00) return half[0] >> 4 & 0xf;
        return half[0] == 0xf3af && (half[1] & 0xff00) == 0x8000 ? half[1] & 0xff : 0;
    }
    const std::uint32_t word = half[0] | static_cast<std::uint32_t>(half[1]) << 16;
    return (word & 0x0fffff00) == 0x0320f000 ? word & 0xff : 0;
}

}  // namespace

ArmStop ArmCore::run_by_bytes() { return run(1); }

ArmCore::OnBus ArmCore::on_bus() const {
    const std::uint32_t flags = cpsr();
    const bool thumb = flags & arm_cpsr::T, privileged = (flags & arm_cpsr::MODE) != arm_mode::USR;
    std::uint16_t half[2] = {};
    if (!read_ram(last_pc_, half, sizeof half)) return {1, 0, privileged, false};
    const std::uint32_t first = half[0], second = half[1];
    const std::uint32_t word = !thumb           ? first | second << 16
                               : first < 0xE800 ? first
                                                : first << 16 | second;
    return {transferred_words(word, thumb), 0, privileged, is_exclusive(word, thumb)};
}

const bool ArmCore::TELLS_OF_MASKS = false;

struct ArmCore::Engine::Hooks {
    // Called before every instruction.  It takes most of the simulation's time, but it makes
    // Unicorn keep the program counter exact, in bus accesses too.
    static void instruction(uc_engine* uc, std::uint64_t address, std::uint32_t bytes, void* self) {
        ArmCore& core = *static_cast<ArmCore*>(self);
        if (core.count_ >= core.limit_) {
            uc_emu_stop(uc);
            return;
        }
        Engine& e = *core.engine_;
        const auto pc = static_cast<std::uint32_t>(address);
        for (const auto& [base, size] : e.forbidden)
            if (pc - base < size) {
                e.exception = EXCP_PREFETCH_ABORT;
                uc_emu_stop(uc);
                return;
            }
        if (!e.probed.empty() && e.probed.count(pc) && e.probe->before(pc)) {
            core.limit_ = core.count_;
            uc_emu_stop(uc);
            return;
        }
        ++core.count_;
        core.last_pc_ = pc;
        if (e.tally) e.tally->ran({pc, 1, core.reg(14), pc + bytes});
    }

    static void interrupt(uc_engine* uc, std::uint32_t number, void* self) {
        static_cast<ArmCore*>(self)->engine_->exception = static_cast<int>(number);
        uc_emu_stop(uc);
    }

    // uc_emu_stop here leaves pc at the load and its register unchanged, so the next uc_emu_start
    // would repeat the load.  That is right only for an abort.
    static std::uint64_t read(uc_engine* uc, std::uint64_t offset, unsigned bytes, void* window) {
        const auto& [core, bus_base, base, size] = *static_cast<Engine::Window*>(window);
        const std::uint32_t address = bus_base + static_cast<std::uint32_t>(offset);
        std::uint32_t value = 0;
        if (!core->engine_->aborted && !core->engine_->watched &&
            !core->engine_->bus.read(address, bytes, value))
            abort(*core, uc, address, false);
        return value;
    }
    static void write(uc_engine* uc, std::uint64_t offset, unsigned bytes, std::uint64_t value,
                      void* window) {
        const auto& [core, bus_base, base, size] = *static_cast<Engine::Window*>(window);
        const std::uint32_t address = bus_base + static_cast<std::uint32_t>(offset);
        if (!core->engine_->aborted && !core->engine_->watched &&
            !core->engine_->bus.write(address, bytes, static_cast<std::uint32_t>(value)))
            abort(*core, uc, address, true);
    }

    static void abort(ArmCore& core, uc_engine* uc, std::uint32_t address, bool write) {
        core.engine_->aborted = true;
        core.fault_ = {address, write, false};
        uc_emu_stop(uc);
    }

    // A load or store where nothing is mapped, or that the mapping does not allow.
    static bool unmapped(uc_engine*, uc_mem_type type, std::uint64_t address, int, std::int64_t,
                         void* self) {
        ArmCore& core = *static_cast<ArmCore*>(self);
        core.engine_->aborted = true;
        core.fault_ = {static_cast<std::uint32_t>(address),
                       type == UC_MEM_WRITE_UNMAPPED || type == UC_MEM_WRITE_PROT, true};
        return false;
    }

    // Before each access, of which an instruction can have several.
    static void access(uc_engine* uc, uc_mem_type type, std::uint64_t address, int bytes,
                       std::int64_t, void* self) {
        ArmCore& core = *static_cast<ArmCore*>(self);
        if (core.engine_->watched ||
            !core.engine_->watch->touched(static_cast<std::uint32_t>(address),
                                          static_cast<unsigned>(bytes), type == UC_MEM_WRITE))
            return;
        core.engine_->watched = true;
        uc_emu_stop(uc);
    }
};

ArmCore::ArmCore(ArmBus& bus) : engine_{std::make_unique<Engine>(bus)} {
    uc_hook hook;
    check_uc(uc_hook_add(engine_->uc, &hook, UC_HOOK_CODE,
                         reinterpret_cast<void*>(&Engine::Hooks::instruction), this, 1, 0),
             "hook of instructions");
    check_uc(uc_hook_add(engine_->uc, &hook, UC_HOOK_INTR,
                         reinterpret_cast<void*>(&Engine::Hooks::interrupt), this, 1, 0),
             "hook of exceptions");
    check_uc(uc_hook_add(engine_->uc, &hook,
                         UC_HOOK_MEM_READ_UNMAPPED | UC_HOOK_MEM_WRITE_UNMAPPED |
                             UC_HOOK_MEM_READ_PROT | UC_HOOK_MEM_WRITE_PROT,
                         reinterpret_cast<void*>(&Engine::Hooks::unmapped), this, 1, 0),
             "hook of wrong accesses");
}

ArmCore::~ArmCore() = default;

void ArmCore::attach(ArmProbe* probe, const std::vector<std::uint32_t>& at) {
    engine_->probe = probe;
    engine_->probed.clear();
    if (probe) engine_->probed.insert(at.begin(), at.end());
}

void ArmCore::attach(ArmTally* tally) { engine_->tally = tally; }

void ArmCore::watch(ArmWatch* watch) {
    if (watch && !engine_->watch) {
        check_uc(
            uc_hook_add(engine_->uc, &engine_->watch_hook, UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE,
                        reinterpret_cast<void*>(&Engine::Hooks::access), this, 1, 0),
            "hook of accesses");
        // Translated code does not have the hook.  UC_CTL_TB_FLUSH takes 2 s, this some
        // milliseconds.
        for (const Engine::Ram& area : engine_->ram)
            uc_ctl_remove_cache(engine_->uc, area.base, area.base + area.size);
    }
    if (!watch && engine_->watch)
        check_uc(uc_hook_del(engine_->uc, engine_->watch_hook), "end of a hook");
    engine_->watch = watch;
}

void ArmCore::map_bus(std::uint32_t base, std::uint64_t size, std::uint32_t bus_base,
                      unsigned access) {
    engine_->windows.push_back(
        std::make_unique<Engine::Window>(Engine::Window{this, bus_base, base, size}));
    void* window = engine_->windows.back().get();
    check_uc(uc_mmio_map(engine_->uc, base, size,
                         access & arm_access::READ ? &Engine::Hooks::read : nullptr, window,
                         access & arm_access::WRITE ? &Engine::Hooks::write : nullptr, window),
             "map of the bus");
}

ArmStop ArmCore::run(std::uint64_t limit) {
    limit_ = count_ + limit;
    const std::uint64_t begin = count_;
    int& exception = engine_->exception;
    exception = 0;
    engine_->aborted = engine_->watched = false;
    const std::uint32_t thumb = cpsr() & arm_cpsr::T ? 1 : 0;
    const uc_err error = uc_emu_start(engine_->uc, pc() | thumb, NEVER, 0, 0);

    if (engine_->watched) return ArmStop::LIMIT;
    if (engine_->aborted) return ArmStop::DATA_ABORT;
    if (exception == EXCP_SWI) return ArmStop::SVC;
    fault_ = {0, false, exception == EXCP_DATA_ABORT || exception == EXCP_PREFETCH_ABORT};
    if (exception == EXCP_DATA_ABORT) return ArmStop::DATA_ABORT;
    if (exception == EXCP_BKPT) return ArmStop::BREAKPOINT;
    if (exception == EXCP_PREFETCH_ABORT || error == UC_ERR_FETCH_PROT ||
        error == UC_ERR_FETCH_UNMAPPED) {
        fault_.address = pc();
        return ArmStop::PREFETCH_ABORT;
    }
    // WFI ends uc_emu_start without an exception, WFE and YIELD as if they were undefined.
    const bool executed = count_ != begin && pc() != last_pc_;
    if (executed && (error == UC_ERR_OK || error == UC_ERR_INSN_INVALID)) {
        switch (hint(*this)) {
            case 1: return ArmStop::LIMIT;
            case 2: return ArmStop::WFE;
            case 3: return ArmStop::WFI;
            default: break;
        }
    }
    if (exception != 0 || error == UC_ERR_INSN_INVALID || error == UC_ERR_EXCEPTION) {
        set_reg(15, last_pc_);  // after SMC and HVC pc is past them
        return ArmStop::UNDEFINED;
    }
    check_uc(error, "uc_emu_start");
    return ArmStop::LIMIT;
}

}  // namespace sim
