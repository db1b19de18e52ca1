// steady_transfers.cpp - SteadyLoop's loads and stores, and the multiplications among them
#include <cstring>

#include "sim/cpu/steady_arithmetic.h"
#include "sim/cpu/steady_loop.h"

namespace sim {

using namespace steady;

bool SteadyLoop::single_transfer(std::uint32_t word, World& world) {
    const bool by_register = word >> 25 & 1, pre = word >> 24 & 1, up = word >> 23 & 1;
    const bool write_back = word >> 21 & 1, load = word >> 20 & 1;
    const unsigned base = bits(word, 19, 16), target = bits(word, 15, 12);
    if (!pre && write_back) return false;  // LDRT and its kind
    int carry = UNCHANGED;
    const std::optional<Linear> offset =
        by_register ? shifted(word & ~0x10u, carry) : fixed(word & 0xFFF);
    if (!offset) return false;
    const Linear to = up ? read(base) + *offset : read(base) - *offset;
    const Linear address = pre ? to : read(base);
    if ((!pre || write_back) && base == target) return false;
    if (!transfer(load, word >> 22 & 1 ? 1 : 4, false, target, address, world)) return false;
    return (pre && !write_back) || write(base, to);
}

// Halfwords, signed ones, doublewords; and multiplications.
bool SteadyLoop::extra_transfer(std::uint32_t word, World& world) {
    const unsigned kind = bits(word, 6, 5);
    if (kind == 0) {
        if (!matches(word, 0x0FC000F0, 0x00000090)) return false;  // MUL, MLA
        const Linear a = read(word & 0xF), b = read(bits(word, 11, 8));
        if (!a.fixed() || !b.fixed()) return false;
        Linear result = fixed(a.base * b.base);
        if (word >> 21 & 1) result = result + read(bits(word, 15, 12));
        if (word >> 20 & 1) set_logical(result, UNCHANGED);
        return write(bits(word, 19, 16), result);
    }
    const bool pre = word >> 24 & 1, up = word >> 23 & 1, immediate = word >> 22 & 1;
    const bool write_back = word >> 21 & 1, l = word >> 20 & 1;
    const unsigned base = bits(word, 19, 16), target = bits(word, 15, 12);
    if (!pre && write_back) return false;
    const Linear offset =
        immediate ? fixed(bits(word, 11, 8) << 4 | (word & 0xF)) : read(word & 0xF);
    const Linear to = up ? read(base) + offset : read(base) - offset;
    const Linear address = pre ? to : read(base);
    if ((!pre || write_back) && (base == target || base == target + 1)) return false;
    const bool doubleword = !l && kind != 1;
    if (doubleword) {
        const bool load = kind == 2;
        if (target % 2 != 0 || target == LINK || base == target) return false;
        if (!transfer(load, 4, false, target, address, world) ||
            !transfer(load, 4, false, target + 1, address + fixed(4), world))
            return false;
    } else if (!transfer(l, kind == 2 ? 1 : 2, kind != 1, target, address, world)) {
        return false;
    }
    return (pre && !write_back) || write(base, to);
}

bool SteadyLoop::block_transfer(std::uint32_t word, World& world) {
    const bool before = word >> 24 & 1, up = word >> 23 & 1, other_mode = word >> 22 & 1;
    const bool write_back = word >> 21 & 1, load = word >> 20 & 1;
    const unsigned base = bits(word, 19, 16);
    if (other_mode || base == PC || word & 1u << base) return false;
    unsigned count = 0;
    for (unsigned i = 0; i < 16; ++i) count += word >> i & 1;
    const Linear first = read(base), size = fixed(4 * count);
    const Linear end = up ? first + size : first - size;
    Linear address = up ? first : end;
    if (before == up) address = address + fixed(4);
    const unsigned uses = use_count_;
    for (unsigned i = 0; i < 16; ++i) {
        if (!(word >> i & 1)) continue;
        if (!transfer(load, 4, false, i, address, world)) return false;
        address = address + fixed(4);
    }
    if (use_count_ != uses) return false;
    return !write_back || write(base, end);
}

bool SteadyLoop::transfer(bool loads, unsigned bytes, bool is_signed, unsigned target,
                          const Linear& address, World& world) {
    if (!address.fixed() || address.base % bytes != 0) return false;
    if (!loads) return target != PC && store(address, bytes, read(target), world);
    std::optional<Linear> value = load(address, bytes, world);
    if (!value) return false;
    if (is_signed) value = fixed(extended(value->base, 8 * bytes));
    return write(target, *value);
}

// The word of memory at an aligned address, if this round has written it, or is about to.
SteadyLoop::Word* SteadyLoop::word_at(std::uint32_t address, World& world) {
    for (unsigned i = 0; i < word_count_; ++i)
        if (words_[i].address == address) return &words_[i];
    const World::Place place = world.place(address, true);
    if (!place.ram || word_count_ == WORDS) return nullptr;
    std::uint32_t value;
    std::memcpy(&value, place.ram, sizeof value);
    now_[word_count_] = fixed(value);
    words_[word_count_] = {address, fixed(value)};
    return &words_[word_count_++];
}

std::optional<Linear> SteadyLoop::load(const Linear& address, unsigned bytes, World& world) {
    if (address.base % bytes != 0) return std::nullopt;
    const std::uint32_t aligned = address.base & ~3u, lane = 8 * (address.base & 3);
    const auto part = [&](std::uint32_t word) {
        return bytes == 4 ? word : word >> lane & ((1u << 8 * bytes) - 1);
    };
    for (unsigned i = 0; i < word_count_; ++i) {
        if (words_[i].address != aligned) continue;
        if (!(words_written_ >> i & 1)) words_read_ |= 1u << i;
        if (bytes == 4) return now_[i];
        if (!now_[i].fixed()) return std::nullopt;
        return fixed(part(now_[i].base));
    }
    const World::Place place = world.place(address.base, false);
    if (place.ram) {
        std::uint32_t value = 0;
        std::memcpy(&value, place.ram, bytes);
        return fixed(value);
    }
    if (!place.on_bus || use_count_ == USES) return std::nullopt;
    Use& use = uses_[use_count_++];
    use = {pc_, place.address, bytes, false, 0, instructions_};
    if (const auto counter = world.counter(uses_.data(), use_count_)) {
        use.value = counter->value;
        Linear value = fixed(counter->value);
        counts_ = true;
        if (round_ps_ == 0) return value;
        if (counter->left_ps != RunningCount::FOR_EVER)
            limit((counter->left_ps - 1) / round_ps_ + 1);
        value.stair = {counter->sign, counter->tick_ps, counter->phase_ps, round_ps_};
        return value;
    }
    const std::optional<std::uint32_t> value = world.answer(use);
    if (!value) return std::nullopt;
    use.value = *value;
    return fixed(*value);
}

bool SteadyLoop::store(const Linear& address, unsigned bytes, const Linear& value, World& world) {
    if (address.base % bytes != 0) return false;
    const World::Place place = world.place(address.base, true);
    if (place.on_bus) {
        if (!value.fixed() || use_count_ == USES) return false;
        Use& use = uses_[use_count_++];
        const std::uint32_t mask = bytes == 4 ? ~0u : (1u << 8 * bytes) - 1;
        use = {pc_, place.address, bytes, true, value.base & mask, instructions_};
        return world.answer(use).has_value();
    }
    const Word* const word = word_at(address.base & ~3u, world);
    if (!word) return false;
    const auto index = static_cast<unsigned>(word - words_.data());
    Linear& now = now_[index];
    if (bytes != 4 && !(words_written_ >> index & 1)) words_read_ |= 1u << index;
    words_written_ |= 1u << index;
    if (bytes == 4) {
        now = value;
        return true;
    }
    if (!value.fixed() || !now.fixed()) return false;
    const std::uint32_t lane = 8 * (address.base & 3), mask = ((1u << 8 * bytes) - 1) << lane;
    now.base = (now.base & ~mask) | (value.base << lane & mask);
    return true;
}

}  // namespace sim
