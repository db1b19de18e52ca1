// arm_core.cpp - ArmCore by dynarmic: what it is asked from outside.
#include "sim/cpu/arm_core.h"

#include <algorithm>
#include <cstring>

#include "sim/cpu/dynarmic/engine.h"

namespace sim {

const bool ArmCore::TELLS_OF_MASKS = true;

ArmCore::ArmCore(ArmBus& bus) : engine_{std::make_unique<Engine>(*this, bus)} {}
ArmCore::~ArmCore() = default;

ArmStop ArmCore::run(std::uint64_t limit) {
    limit_ = count_ + limit;
    while (count_ < limit_)
        if (const auto stop = engine_->next(limit_ - count_)) return *stop;
    return ArmStop::LIMIT;
}

ArmStop ArmCore::run_by_bytes() { return engine_->step_by_bytes().value_or(ArmStop::LIMIT); }

ArmCore::OnBus ArmCore::on_bus() const { return engine_->on_bus(); }

// ---- Registers ----------------------------------------------------------------------------------

void ArmCore::reset(std::uint32_t entry, std::uint32_t stack) {
    Engine& e = *engine_;
    e.cpu.jit->Reset();
    e.cpu.jit->ExtRegs().fill(0);
    e.cpu.jit->SetFpscr(0);
    e.cpu.jit->ClearExclusiveState();
    e.cpu.cp15.reset();
    e.cpu.banked = {};
    e.cpu.fpexc = 0;
    e.cpu.jit->SetCpsr(arm_mode::SVC | arm_cpsr::A | arm_cpsr::I | arm_cpsr::F |
                       (entry & 1 ? arm_cpsr::T : 0));
    e.cpu.r().fill(0);
    set_reg(13, stack);
    set_reg(15, entry);
    e.translated.forget_mappings();
}

std::uint32_t ArmCore::reg(unsigned number) const { return engine_->cpu.jit->Regs()[number & 15]; }

void ArmCore::set_reg(unsigned number, std::uint32_t value) {
    if ((number & 15) == 15)
        engine_->cpu.go_to(value);
    else
        engine_->cpu.r()[number & 15] = value;
}

std::uint32_t ArmCore::cpsr() const { return engine_->cpu.cpsr(); }
void ArmCore::set_cpsr(std::uint32_t value) { engine_->registers.set_cpsr(value); }

std::uint32_t ArmCore::spsr() const { return engine_->cpu.spsr(); }
void ArmCore::set_spsr(std::uint32_t value) { engine_->cpu.spsr() = value; }

std::uint64_t ArmCore::vfp(unsigned number) const {
    const auto& words = engine_->cpu.jit->ExtRegs();
    const unsigned low = 2 * (number & 31);
    return words[low] | std::uint64_t{words[low + 1]} << 32;
}

void ArmCore::set_vfp(unsigned number, std::uint64_t value) {
    auto& words = engine_->cpu.jit->ExtRegs();
    const unsigned low = 2 * (number & 31);
    words[low] = static_cast<std::uint32_t>(value);
    words[low + 1] = static_cast<std::uint32_t>(value >> 32);
}

void ArmCore::clear_exclusive() { engine_->cpu.jit->ClearExclusiveState(); }

void ArmCore::set_floating_point(bool on) { engine_->registers.set_floating_point(on); }
bool ArmCore::floating_point() const { return engine_->cpu.floating_point(); }

std::uint32_t ArmCore::fpscr() const { return engine_->cpu.jit->Fpscr(); }
void ArmCore::set_fpscr(std::uint32_t value) { engine_->cpu.jit->SetFpscr(value); }

std::uint32_t ArmCore::cp15(const Cp15& name) const { return engine_->cpu.cp15.value(name); }
void ArmCore::set_cp15(const Cp15& name, std::uint32_t value) {
    engine_->cpu.cp15.set(name, value);
}

// ---- Inspectors ---------------------------------------------------------------------------------

void ArmCore::attach(ArmProbe* probe, const std::vector<std::uint32_t>& at) {
    Inspectors& all = engine_->inspectors;
    TranslatedCode& translated = engine_->translated;
    for (const std::uint32_t pc : all.probed) translated.invalidate(pc & ~1u);
    all.probe = probe;
    all.probed.clear();
    if (!probe) return;
    all.probed.insert(at.begin(), at.end());
    for (const std::uint32_t pc : at) translated.invalidate(pc & ~1u);
}

void ArmCore::attach(ArmTally* tally) {
    engine_->inspectors.tally = tally;
    engine_->translated.forget_mappings();
}

// With an empty page table every access is a callback; literals must not be constants either.
void ArmCore::watch(ArmWatch* watch) {
    if ((watch == nullptr) != (engine_->inspectors.watch == nullptr))
        engine_->translated.forget_mappings();
    engine_->inspectors.watch = watch;
}

// ---- For those who know what the program will do ------------------------------------------------

std::optional<std::uint32_t> ArmCore::code_at(std::uint32_t pc, bool thumb) {
    const Engine& e = *engine_;
    if (e.inspectors.has_any()) return std::nullopt;
    return e.translated.code.instruction(pc, thumb);
}

std::optional<ArmCore::Cycles> ArmCore::cycles() const {
    constexpr Cp15 PMCCNTR{9, 0, 13, 0};
    const auto read_after = [&](std::uint64_t more) {
        return engine_->registers.read(PMCCNTR, count_ + more);
    };
    const auto next = read_after(1);
    if (!next) return std::nullopt;
    return Cycles{*next, *read_after(2) != *next};
}

ArmCore::Place ArmCore::place(std::uint32_t address, bool write) {
    const Mmu::Page& page = engine_->mmu.page(address);
    const unsigned right = write ? arm_access::WRITE : arm_access::READ;
    if (!(page.access & right)) return {};
    if (page.bytes) return {page.bytes + (address & 0xFFF), {}};
    if (page.normal) return {};
    return {nullptr, page.physical | (address & 0xFFF)};
}

void ArmCore::store_word(std::uint32_t address, std::uint32_t value) {
    Engine& e = *engine_;
    const Mmu::Page& page = e.mmu.page(address);
    e.translated.written(page.physical | (address & 0xFFF), sizeof value);
    std::memcpy(page.bytes + (address & 0xFFF), &value, sizeof value);
}

// ---- Memory -------------------------------------------------------------------------------------

void ArmCore::map_ram(std::uint32_t base, std::uint64_t size, void* bytes, unsigned access,
                      bool data_by_bus) {
    engine_->mmu.map({base, size, static_cast<std::uint8_t*>(bytes), 0, access, data_by_bus});
}

void ArmCore::map_bus(std::uint32_t base, std::uint64_t size, std::uint32_t bus_base,
                      unsigned access) {
    engine_->mmu.map({base, size, nullptr, bus_base, access});
}

void ArmCore::unmap(std::uint32_t base, std::uint64_t size) {
    engine_->mmu.unmap(base);
    engine_->translated.written(
        base, static_cast<std::uint32_t>(std::min<std::uint64_t>(size, 0x100000000 - base - 1)));
}

void ArmCore::forbid_code(std::uint32_t base, std::uint32_t size) {
    engine_->mmu.forbid_code(base, size);
    engine_->translated.written(base, size);
}

void ArmCore::permit_code(std::uint32_t base, std::uint32_t size) {
    engine_->mmu.permit_code(base, size);
}

std::optional<std::uint32_t> ArmCore::bus_address(std::uint32_t address) const {
    const MemoryMap::Area* const area = engine_->mmu.memory().find(address);
    if (!area || area->bytes) return std::nullopt;
    return area->bus_base + (address - area->base);
}

bool ArmCore::read_ram(std::uint32_t address, void* data, std::size_t bytes) const {
    const std::uint8_t* const from = engine_->mmu.memory().ram(address, bytes);
    if (from) std::copy_n(from, bytes, static_cast<std::uint8_t*>(data));
    return from != nullptr;
}

bool ArmCore::write_ram(std::uint32_t address, const void* data, std::size_t bytes) {
    std::uint8_t* const to = engine_->mmu.memory().ram(address, bytes);
    if (!to) return false;
    std::copy_n(static_cast<const std::uint8_t*>(data), bytes, to);
    forget_translations(address, bytes);
    return true;
}

void ArmCore::forget_translations(std::uint32_t address, std::size_t bytes) {
    engine_->translated.written(address, static_cast<std::uint32_t>(bytes));
}

}  // namespace sim
