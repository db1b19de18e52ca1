// Words of NEON, VFP and ARM's unconditional space are instructions where Unicorn's Cortex-A9 has
// one, and else undefined.
#include <gmock/gmock.h>

#include <cstring>
#include <map>

#include <fmt/format.h>

#include "tb/sim/arm_core/machine.h"
#include "tb/sim/arm_core/states.h"

namespace undefined {

using namespace tb::core;

class UndefinedWords : public ::testing::Test {
protected:
    bool is_undefined(Machine& machine, std::uint32_t word, bool thumb);
    // Random words; `compared` leaves out the UNPREDICTABLE ones and those that must differ.
    void compare(const char* bits, bool thumb, bool (*compared)(std::uint32_t));

private:
    Random random_{1};
    std::unique_ptr<Machine> expected_ = unicorn(), whole_ = processor(false),
                             stepped_ = processor(true);
};

bool UndefinedWords::is_undefined(Machine& machine, std::uint32_t word, bool thumb) {
    const Stream stream{thumb, {{"", {word}}}, {}};
    const auto code = stream.code(1);
    const auto bytes = static_cast<std::uint32_t>(2 * code.size());
    std::memcpy(machine.memory->code.data(), code.data(), bytes);
    machine.code_changed(CODE, bytes);
    State state;
    state.r.fill(DATA + PARTS / 2 * PART);
    state.cpsr = 0x1D3 | (thumb ? 0x20 : 0);
    machine.set(state);
    return machine.run(CODE, CODE + 4, 1) == CODE + Machine::UNDEFINED;
}

void UndefinedWords::compare(const char* bits, bool thumb, bool (*compared)(std::uint32_t)) {
    constexpr unsigned WORDS = 5000;
    std::map<std::uint32_t, std::uint32_t> wrong;  // one of each kind
    for (unsigned i = 0; i < WORDS; ++i) {
        std::uint32_t word = 0;
        for (unsigned at = 0; at < 32; ++at)
            word = word << 1 | (bits[at] == 'x' ? random_() & 1 : bits[at] == '1');
        if (compared && !compared(word)) continue;
        const std::uint32_t given = thumb ? to_thumb(word) : word;
        const bool expected = is_undefined(*expected_, given, thumb);
        if (is_undefined(*whole_, given, thumb) != expected ||
            is_undefined(*stepped_, given, thumb) != expected)
            wrong[given & 0xFFB00FD0] = given;
    }
    std::string text;
    for (const auto& [kind, word] : wrong) text += fmt::format("{:08x} ", word);
    EXPECT_EQ(text, "");
}

// ---- What is compared ----

// VRINT and VCVT with a rounding of their own, which ARMv8 has where ARMv7 has nothing; so has the
// Cortex-A9 of a newer Unicorn.
bool is_of_armv8(std::uint32_t w) {
    if ((w & 0xFFB00810) != 0xF3B00000) return false;
    const std::uint32_t a = field(w, 17, 16), op = field(w, 9, 7);
    return bit(w, 10) ? a == 2 && op != 4 && op != 6 : a == 3;
}

bool in_neon(std::uint32_t w) {
    if (is_of_armv8(w)) return false;
    const bool sign = !bit(w, 24), b = bit(w, 4);
    const std::uint32_t a = field(w, 11, 8);
    if (a != 13 || sign) return true;
    // Undefined by A7.4.1 and A7.4.2; Unicorn takes them for VMUL and VQDMULL.
    return bit(w, 23) ? b || bit(w, 6) : !b || !bit(w, 21);
}

// pc as a register, two equal ones, more fraction bits than bits are UNPREDICTABLE.
bool in_vfp(std::uint32_t w) {
    if (bit(w, 4)) return field(w, 15, 12) < 13;
    const bool fixed = (w & 0x0FBA0E50) == 0x0EBA0A40;
    return !fixed || bit(w, 7) || (field(w, 3, 0) << 1 | bit(w, 5)) <= 16;
}
bool in_vfp_memory(std::uint32_t w) {
    const std::uint32_t t = field(w, 15, 12), t2 = field(w, 19, 16);
    return field(w, 27, 21) != 0x62 || (t < 13 && t2 < 13 && t != t2);
}

bool in_hints(std::uint32_t w) {
    const bool neon = w >> 24 == 0xF4 && !bit(w, 20);
    return !neon && field(w, 15, 12) == 15;
}

TEST_F(UndefinedWords, AreThoseOfNeonThatUnicornRefuses) {
    compare("1111001xxxxxxxxxxxxxxxxxxxxxxxxx", false, in_neon);
}
TEST_F(UndefinedWords, AreThoseOfNeonThatUnicornRefusesInThumb) {
    compare("1111001xxxxxxxxxxxxxxxxxxxxxxxxx", true, in_neon);
}
TEST_F(UndefinedWords, AreThoseOfNeonsLoadsAndStoresThatUnicornRefuses) {
    compare("11110100x0x00xxx0xxxxxxxxxxxxxxx", false, nullptr);
}
TEST_F(UndefinedWords, IncludeNeonLoadsAndStoresInThumb) {
    compare("11110100x0x00xxx0xxxxxxxxxxxxxxx", true, nullptr);
}
TEST_F(UndefinedWords, AreThoseOfVfpThatUnicornRefuses) {
    compare("11101110xxxxxxxxxxxx101xxxxxxxxx", false, in_vfp);
}
TEST_F(UndefinedWords, AreThoseOfVfpThatUnicornRefusesInThumb) {
    compare("11101110xxxxxxxxxxxx101xxxxxxxxx", true, in_vfp);
}
TEST_F(UndefinedWords, AreThoseOfVfpsLoadsAndStoresThatUnicornRefuses) {
    compare("1110110xxxxxxxxxxxxx101xxxxxxxxx", false, in_vfp_memory);
}
TEST_F(UndefinedWords, AreThoseOfCoprocessorsWithoutACondition) {
    compare("111111xxxxxxxxxxxxxxxxxxxxxxxxxx", false,
            [](std::uint32_t w) { return w >> 24 != 0xFF; });
}
TEST_F(UndefinedWords, AreThoseOfDataProcessingWithoutACondition) {
    compare("1111000xxxxxxxxxxxxxxxxxxxxxxxxx", false,
            [](std::uint32_t w) { return w >> 20 != 0xF10; });  // CPS, SETEND
}
TEST_F(UndefinedWords, AreThoseAroundMemoryHints) {
    compare("111101xxxxxxxxxxxxxxxxxxxxxxxxxx", false, in_hints);
}

}  // namespace undefined
