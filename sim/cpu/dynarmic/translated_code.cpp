#include "sim/cpu/dynarmic/translated_code.h"

namespace sim {

void TranslatedCode::written(std::uint32_t address, std::uint32_t bytes) {
    if (bytes == 0) return;
    code.written(address, bytes,
                 [this](std::uint32_t begin, std::uint32_t size) { invalidate(begin, size); });
}

void TranslatedCode::forget_privileged() {
    for (const std::uint32_t page : privileged_) invalidate(page << 12, 0x1000);
    privileged_.clear();
}

void TranslatedCode::forget_mappings() {
    mmu_.forget();
    code.forget();
    privileged_.clear();
    forget_blocks();
}

void TranslatedCode::forget_blocks() {
    translations_.clear();
    overfull_ = false;
    cpu_.jit->ClearCache();
}

// Dynarmic keeps a list of every branch ever translated to a place, and walks through it when the
// place is translated again.  Also, its table of blocks hashes by address alone: for many modes of
// FPSCR there are many blocks at one address, and then the table grows without bound.  So
// everything is dropped when a page has been translated often.  It is not dropped at once, because
// the first memory access would then end the translation that is in progress.
void TranslatedCode::add_block(std::uint32_t pc) {
    constexpr unsigned OFTEN = 1024;
    if (++translations_[pc >> 12] == OFTEN) overfull_ = true;
}

void TranslatedCode::add_word(std::uint32_t address, const Mmu::Page& page) {
    const std::uint32_t physical = page.physical >> 12;
    if (!mmu_.user_may(address, arm_access::EXECUTE)) privileged_.insert(address >> 12);
    if (page.bytes && !code.has_code(physical)) mmu_.close(page);
    code.translated_word(address >> 12, physical, (address & 0xFFF) / 4);
}

// A store to it is detected like a store to an instruction.
void TranslatedCode::add_literal(std::uint32_t address) {
    literal_ = address;
    reads_literal_ = true;
    note_literal(address);
}

void TranslatedCode::note_literal(std::uint32_t address) {
    const Mmu::Page& page = mmu_.page(address);
    code.translated_word(address >> 12, page.physical >> 12, (address & 0xFFF) / 4);
}

}  // namespace sim
