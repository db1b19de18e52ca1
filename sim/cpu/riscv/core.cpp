#include "sim/cpu/riscv/core.h"

#include <cstring>

namespace sim {

namespace {

constexpr std::size_t PAGES = std::size_t{1} << 20;
constexpr std::uint32_t VECTORED = 1;

}  // namespace

RiscvCore::RiscvCore(RiscvBus& bus, RiscvFpu::Style style, const RiscvClocks& clocks)
    : bus_{bus},
      clocks_{clocks},
      nearest_alone_{style == RiscvFpu::Style::NIOS_V},
      pages_(PAGES),
      fpu_{style} {}

void RiscvCore::map_ram(std::uint32_t base, std::uint32_t size, std::uint8_t* bytes,
                        bool data_by_bus) {
    ram_.push_back({base, size, bytes, data_by_bus});
}

const RiscvCore::Ram* RiscvCore::ram_at(std::uint32_t address, std::size_t bytes) const {
    for (const Ram& ram : ram_) {
        const std::uint32_t offset = address - ram.base;
        if (offset < ram.size && bytes <= ram.size - offset) return &ram;
    }
    return nullptr;
}

bool RiscvCore::read_ram(std::uint32_t address, void* data, std::size_t bytes) const {
    const Ram* ram = ram_at(address, bytes);
    if (ram) std::memcpy(data, ram->bytes + (address - ram->base), bytes);
    return ram;
}

bool RiscvCore::write_ram(std::uint32_t address, const void* data, std::size_t bytes) {
    const Ram* ram = ram_at(address, bytes);
    if (ram && bytes) std::memcpy(ram->bytes + (address - ram->base), data, bytes);
    ++generation_;
    return ram;
}

// The page of instructions at pc, as memory has it now; nullptr: there is no memory.
RiscvPage* RiscvCore::fetch(std::uint32_t pc) {
    const std::uint32_t base = pc & ~(RiscvPage::BYTES - 1);
    const Ram* ram = ram_at(base, RiscvPage::BYTES);
    if (!ram) return nullptr;
    std::unique_ptr<RiscvPage>& page = pages_[base / RiscvPage::BYTES];
    const std::uint8_t* const bytes = ram->bytes + (base - ram->base);
    if (!page || std::memcmp(page->words.data(), bytes, RiscvPage::BYTES) != 0) {
        if (!page) page = std::make_unique<RiscvPage>();
        page->base = base;
        std::memcpy(page->words.data(), bytes, RiscvPage::BYTES);
        decode(*page, clocks_);
    }
    page->checked = generation_;
    return page.get();
}

void RiscvCore::reset(std::uint32_t entry) {
    x_ = {};
    f_ = {};
    pc_ = entry;
    fpu_.flags = frm_ = 0;
    mstatus_ = mie_ = mtvec_ = mscratch_ = mepc_ = mcause_ = mtval_ = 0;
    mtvec_set_ = false;
    reserved_.reset();
}

RiscvStop RiscvCore::run(std::uint64_t clocks) {
    end_ = at_ + clocks;
    ended_ = false;
    const bool is_seen = probe_ || tally_;
    while (at_ < end_ && !ended_) {
        RiscvStop stop = is_seen ? RiscvStop::LIMIT : execute<false>(UINT64_MAX);
        // What is left is less than a run.
        if (stop == RiscvStop::LIMIT && at_ < end_)
            stop = execute<true>(is_seen ? UINT64_MAX : RiscvPage::WORDS);
        if (stop != RiscvStop::LIMIT) return stop;
    }
    return RiscvStop::LIMIT;
}

RiscvStop RiscvCore::step() {
    end_ = INT64_MAX;
    ended_ = false;
    past_probe_ = true;
    const RiscvStop stop = execute<true>(1);
    past_probe_ = false;
    return stop;
}

void RiscvCore::enter(const RiscvTrap& trap) {
    ++traps_;
    mepc_ = pc_;
    mcause_ = trap.cause;
    mtval_ = trap.value;
    using namespace riscv_mstatus;
    mstatus_ = (mstatus_ & ~(MIE | MPIE)) | (mstatus_ & MIE ? MPIE : 0);
    reserved_.reset();
    pc_ = handler(trap);
}

std::uint32_t RiscvCore::handler(const RiscvTrap& trap) const {
    const std::uint32_t base = mtvec_ & ~3u;
    const bool vectored = (mtvec_ & VECTORED) && (trap.cause & riscv_cause::INTERRUPT);
    return vectored ? base + 4 * (trap.cause & ~riscv_cause::INTERRUPT) : base;
}

void RiscvCore::set_pending(std::uint32_t lines) { mip_ = lines; }

// The platform's come before the timer's and the software's, and of them the lowest first, as the
// Nios V Processor Software Developer Handbook has it ("Interrupt Dispatcher").
std::optional<RiscvTrap> RiscvCore::pending_interrupt() const {
    const std::uint32_t ready = mip_ & mie_;
    if (!(mstatus_ & riscv_mstatus::MIE) || ready == 0) return std::nullopt;
    for (unsigned number = 16; number < 32; ++number)
        if (ready >> number & 1) return RiscvTrap{riscv_cause::INTERRUPT | number, 0};
    return RiscvTrap{riscv_cause::INTERRUPT | (ready >> 3 & 1 ? 3u : 7u), 0};
}

}  // namespace sim
