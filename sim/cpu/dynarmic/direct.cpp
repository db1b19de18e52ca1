#include "sim/cpu/dynarmic/direct.h"

#include "sim/cpu/dynarmic/instructions.h"

namespace sim {

namespace {

struct Registers {
    const std::uint32_t* r;
    std::uint32_t pc;  // as an instruction reads it, aligned
    std::uint32_t operator[](unsigned n) const { return n == 15 ? pc : r[n]; }
};

// Fills in the addresses; nothing if the instruction turns out to be none of those in direct.h.
std::optional<SingleAccess> addressed(SingleAccess a, const Registers& r, std::uint32_t offset,
                                      bool up, bool pre, bool write) {
    const std::uint32_t to = up ? r[a.base] + offset : r[a.base] - offset;
    a.address = pre ? to : r[a.base];
    a.write_back = write || !pre;
    a.new_base = to;
    const bool odd = a.target == 15 || (a.write_back && (a.base == 15 || a.base == a.target));
    return odd ? std::nullopt : std::optional{a};
}

std::optional<SingleAccess> arm(std::uint32_t w, const Registers& r, bool carry) {
    if (w >> 28 == 15) return std::nullopt;
    const bool pre = w >> 24 & 1, up = w >> 23 & 1, write = w >> 21 & 1, load = w >> 20 & 1;
    if (!pre && write) return std::nullopt;  // LDRT and its kind
    SingleAccess a{load, 4, false, w >> 12 & 0xF, w >> 16 & 0xF, 0, false, 0};
    if (is(w, 0x0C000000, 0x04000000)) {
        const bool by_register = w >> 25 & 1;
        if (by_register && ((w >> 4 & 1) || (w & 0xF) == 15)) return std::nullopt;
        a.bytes = w >> 22 & 1 ? 1 : 4;
        const std::uint32_t offset =
            by_register ? shifted(r[w & 0xF], w >> 5 & 3, w >> 7 & 0x1F, false, carry) : w & 0xFFF;
        return addressed(a, r, offset, up, pre, write);
    }
    const unsigned kind = w >> 5 & 3;
    if (!is(w, 0x0E000090, 0x00000090) || kind == 0 || (!load && kind != 1)) return std::nullopt;
    const bool immediate = w >> 22 & 1;
    if (!immediate && (w & 0xF) == 15) return std::nullopt;
    a.bytes = kind == 2 ? 1 : 2;
    a.is_signed = kind != 1;
    return addressed(a, r, immediate ? (w >> 4 & 0xF0) | (w & 0xF) : r[w & 0xF], up, pre, write);
}

std::optional<SingleAccess> thumb16(std::uint32_t w, const Registers& r) {
    SingleAccess a{false, 4, false, w & 7, w >> 3 & 7, 0, false, 0};
    const auto at = [&](std::uint32_t offset) {
        return addressed(a, r, offset, true, true, false);
    };
    if (is(w, 0xF000, 0x5000)) {
        static constexpr struct {
            bool load;
            unsigned bytes;
            bool is_signed;
        } KINDS[] = {{false, 4, false}, {false, 2, false}, {false, 1, false}, {true, 1, true},
                     {true, 4, false},  {true, 2, false},  {true, 1, false},  {true, 2, true}};
        const auto& kind = KINDS[w >> 9 & 7];
        a.load = kind.load;
        a.bytes = kind.bytes;
        a.is_signed = kind.is_signed;
        return at(r[w >> 6 & 7]);
    }
    a.load = w >> 11 & 1;
    const std::uint32_t offset = w >> 6 & 0x1F;
    if (is(w, 0xF000, 0x6000)) return at(4 * offset);
    if (is(w, 0xF000, 0x7000)) {
        a.bytes = 1;
        return at(offset);
    }
    if (is(w, 0xF000, 0x8000)) {
        a.bytes = 2;
        return at(2 * offset);
    }
    if (is(w, 0xF000, 0x9000)) {
        a.target = w >> 8 & 7;
        a.base = 13;
        return at(4 * (w & 0xFF));
    }
    return std::nullopt;
}

std::optional<SingleAccess> thumb32(std::uint32_t w, const Registers& r) {
    if (!is(w, 0xFE000000, 0xF8000000)) return std::nullopt;
    const unsigned size = w >> 21 & 3;
    const bool load = w >> 20 & 1, is_signed = w >> 24 & 1, long_offset = w >> 23 & 1;
    if (size == 3 || (is_signed && (!load || size == 2))) return std::nullopt;
    SingleAccess a{load, 1u << size, is_signed, w >> 12 & 0xF, w >> 16 & 0xF, 0, false, 0};
    if (a.base == 15)
        return load ? addressed(a, r, w & 0xFFF, long_offset, true, false) : std::nullopt;
    if (long_offset) return addressed(a, r, w & 0xFFF, true, true, false);
    if (is(w, 0x00000FC0, 0)) {
        const unsigned index = w & 0xF;
        if (index == 13 || index == 15) return std::nullopt;
        return addressed(a, r, r[index] << (w >> 4 & 3), true, true, false);
    }
    if (!(w >> 11 & 1)) return std::nullopt;
    const bool pre = w >> 10 & 1, up = w >> 9 & 1, write = w >> 8 & 1;
    if ((!pre && !write) || (pre && up && !write)) return std::nullopt;  // undefined, LDRT
    return addressed(a, r, w & 0xFF, up, pre, write);
}

}  // namespace

std::optional<SingleAccess> single_access(std::uint32_t word, bool thumb, std::uint32_t pc,
                                          const std::uint32_t* r, bool carry) {
    const Registers registers{r, (pc + (thumb ? 4 : 8)) & ~3u};
    if (!thumb) return arm(word, registers, carry);
    return word <= 0xFFFF ? thumb16(word, registers) : thumb32(word, registers);
}

}  // namespace sim
