// Random instructions do the same on the processor, on Unicorn and on qemu-arm.
//
//   ARM_CORE_INSTRUCTIONS=1000000000 build/bin/arm_core_unicorn_test    make instructions
//   ARM_CORE_SEED=7 other instructions than with seed 1
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "tb/sim/arm_core/differences.h"
#include "tb/sim/arm_core/machine.h"
#include "tb/sim/arm_core/states.h"

namespace against_emulators {

using namespace tb::core;

constexpr std::uint32_t USER = 0x10;
constexpr unsigned STATES = 4;  // initial states for each stream

std::uint64_t number_of(const char* variable, std::uint64_t otherwise) {
    const char* const text = std::getenv(variable);
    return text ? std::strtoull(text, nullptr, 0) : otherwise;
}

class Against : public ::testing::Test {
protected:
    // `mode`: bits 8:0 of the CPSR except T.
    Against(std::unique_ptr<Machine> expected, std::uint32_t mode)
        : expected_{std::move(expected)}, mode_{mode} {}
    void execute(bool thumb, Kind kind, unsigned percent);

private:
    // Empty, or what differs after the first `count` items.
    std::string compare(Machine& actual, const Stream& stream, std::size_t count,
                        std::uint32_t begin, const State& state);
    std::string report(Machine& actual, const Stream& stream, std::uint32_t begin,
                       const State& state, const Memory& memory);

    std::unique_ptr<Machine> expected_;
    std::uint32_t mode_;
    std::unique_ptr<Machine> whole_ = processor(false), stepped_ = processor(true);
    std::uint64_t executed_ = 0;
};

std::string Against::compare(Machine& actual, const Stream& stream, std::size_t count,
                             std::uint32_t begin, const State& state) {
    const auto code = stream.code(count);
    const auto bytes = static_cast<std::uint32_t>(2 * code.size());
    const std::uint32_t end = begin + bytes - (stream.thumb ? 2 : 4);
    unsigned instructions = 0;
    for (std::size_t i = 0; i < count; ++i)
        instructions += static_cast<unsigned>(stream.items[i].words.size());
    executed_ += instructions;

    std::uint32_t ended[2];
    State after[2];
    Machine* const machines[]{expected_.get(), &actual};
    for (unsigned i = 0; i < 2; ++i) {
        Machine& machine = *machines[i];
        std::uint8_t* const place = &machine.memory->code[begin - CODE];
        if (std::memcmp(place, code.data(), bytes) != 0) {
            std::memcpy(place, code.data(), bytes);
            machine.code_changed(begin, bytes);
        }
        machine.set(state);
        ended[i] = machine.run(begin, end, instructions);
        if (ended[i] == end + Machine::UNDEFINED) ended[i] = end;  // by the UDF there
        after[i] = machine.state();
    }
    // What an aborted load should have loaded is UNKNOWN; dynarmic sets D registers to 0.
    if (ended[0] != Machine::OTHER && ended[0] >= Machine::UNALIGNED) after[1].d = after[0].d;
    std::string text;
    if (ended[0] == Machine::OTHER) text += "  the other has met something else than the end\n";
    if (ended[0] != ended[1])
        text += fmt::format("  pc     expected {:08x}, is {:08x} (+1: undefined)\n", ended[0],
                            ended[1]);
    text += difference(after[0], after[1], FPSCR_COMPARED);
    const auto &e = expected_->memory->data, &a = actual.memory->data;
    if (std::memcmp(e.data(), a.data(), e.size()) != 0) {
        const auto at = std::mismatch(e.begin(), e.end(), a.begin());
        text += fmt::format("  data   +{:05x} expected {:02x}, is {:02x}\n", at.first - e.begin(),
                            *at.first, *at.second);
    }
    return text;
}

// The shortest beginning of the stream that differs.
std::string Against::report(Machine& actual, const Stream& stream, std::uint32_t begin,
                            const State& state, const Memory& memory) {
    std::string text;
    std::size_t count = 0;
    while (text.empty() && ++count <= stream.items.size()) {
        expected_->memory->data = actual.memory->data = memory.data;
        text = compare(actual, stream, count, begin, state);
    }
    if (text.empty()) return "differs only where another stream has been there before\n";
    const Item& item = stream.items[count - 1];
    std::string words;
    for (const std::uint32_t word : item.words)
        words += fmt::format(" {:0{}x}", word, word >> 16 ? 8 : 4);
    expected_->memory->data = memory.data;
    compare(*expected_, stream, count - 1, begin, state);
    const State before = expected_->state();
    text = fmt::format("{} {}:{}\n{}before: cpsr {:08x} fpscr {:08x}\n",
                       stream.thumb ? "Thumb" : "ARM", item.name, words, text, before.cpsr,
                       before.fpscr);
    for (unsigned i = 0; i < 15; ++i) text += fmt::format(" r{}={:08x}", i, before.r[i]);
    for (unsigned i = 0; i < 32; ++i)
        text += fmt::format("{}d{}={:016x}", i % 8 ? " " : "\n ", i, before.d[i]);
    return text + "\n";
}

void Against::execute(bool thumb, Kind kind, unsigned percent) {
    const std::uint64_t wanted = number_of("ARM_CORE_INSTRUCTIONS", 1'000'000) * percent / 100;
    const std::uint64_t seed = number_of("ARM_CORE_SEED", 1);
    Random random{seed};
    for (auto& byte : expected_->memory->code) byte = static_cast<std::uint8_t>(random());
    for (std::size_t i = 0; i < PART; i += 8) {
        const std::uint64_t value = any_doubleword(random);
        std::memcpy(&expected_->memory->data[i], &value, 8);
    }
    *whole_->memory = *stepped_->memory = *expected_->memory;

    Memory before;
    for (unsigned number = 0; executed_ < wanted; ++number) {
        random.seed(seed << 32 | number);
        const unsigned length = 20 + static_cast<unsigned>(random() % 41);
        const Stream stream = make_stream(random, thumb, kind, length, mode_ == USER);
        const std::uint32_t begin =
            CODE + 0x2000 + static_cast<std::uint32_t>(random() % 0xC000 & ~3u);
        const std::uint32_t fpscr =
            any_fpscr(random) & (kind == Kind::NEAREST ? ~FPSCR_ROUNDING : ~0u);
        Machine& actual = number % 8 == 0 ? *stepped_ : *whole_;
        actual.memory->data = expected_->memory->data;
        for (unsigned i = 0; i < STATES; ++i) {
            State state = any_state(random, stream, fpscr, mode_ == USER);
            state.cpsr = (state.cpsr & ~0x1DFu) | mode_;
            before.data = expected_->memory->data;
            const std::string differs = compare(actual, stream, stream.items.size(), begin, state);
            if (!differs.empty()) {
                ADD_FAILURE() << "seed " << seed << ", stream " << number << ", state " << i
                              << (&actual == stepped_.get() ? ", in steps" : "") << "\n"
                              << differs << report(actual, stream, begin, state, before);
                if (!std::getenv("ARM_CORE_ALL")) return;
                actual.memory->data = expected_->memory->data;
                break;
            }
        }
        // Literals are read from the code's page: it is the same everywhere.
        const std::size_t bytes = 2 * stream.code(stream.items.size()).size();
        for (Machine* machine : {whole_.get(), stepped_.get()}) {
            if (machine == &actual) continue;
            std::memcpy(&machine->memory->code[begin - CODE],
                        &expected_->memory->code[begin - CODE], bytes);
            machine->code_changed(begin, static_cast<std::uint32_t>(bytes));
        }
    }
}

class AgainstUnicorn : public Against {
protected:
    AgainstUnicorn() : Against{unicorn(), 0x1D3} {}
};

TEST_F(AgainstUnicorn, ArmDataProcessingComputesTheSame) { execute(false, Kind::COMPUTING, 15); }
TEST_F(AgainstUnicorn, ThumbDataProcessingComputesTheSame) { execute(true, Kind::COMPUTING, 15); }
TEST_F(AgainstUnicorn, ArmLoadsAndStoresReachTheSame) { execute(false, Kind::MEMORY, 10); }
TEST_F(AgainstUnicorn, ThumbLoadsAndStoresReachTheSame) { execute(true, Kind::MEMORY, 10); }
TEST_F(AgainstUnicorn, VfpInArmComputesTheSame) { execute(false, Kind::VFP, 5); }
TEST_F(AgainstUnicorn, VfpThatRoundsToTheNearestComputesTheSame) {
    execute(false, Kind::NEAREST, 5);
}
TEST_F(AgainstUnicorn, VfpInThumbComputesTheSame) { execute(true, Kind::VFP, 5); }
TEST_F(AgainstUnicorn, NeonInArmComputesTheSame) { execute(false, Kind::NEON, 10); }
TEST_F(AgainstUnicorn, NeonInThumbComputesTheSame) { execute(true, Kind::NEON, 5); }
TEST_F(AgainstUnicorn, ArmInstructionsOfAllKindsDoTheSame) { execute(false, Kind::MIXED, 10); }
TEST_F(AgainstUnicorn, ThumbInstructionsOfAllKindsDoTheSame) { execute(true, Kind::MIXED, 10); }
TEST_F(AgainstUnicorn, ArmOperatingSystemsDoTheSame) { execute(false, Kind::SYSTEM, 10); }
TEST_F(AgainstUnicorn, ThumbOperatingSystemsDoTheSame) { execute(true, Kind::SYSTEM, 10); }

// As a program of the user mode, on a QEMU that is some years younger and knows alignment faults.
class AgainstQemu : public Against {
protected:
    AgainstQemu() : Against{qemu(), USER} {}
};

TEST_F(AgainstQemu, ArmDataProcessingComputesTheSame) { execute(false, Kind::COMPUTING, 5); }
TEST_F(AgainstQemu, ThumbDataProcessingComputesTheSame) { execute(true, Kind::COMPUTING, 5); }
TEST_F(AgainstQemu, VfpInArmComputesTheSame) { execute(false, Kind::VFP, 5); }
TEST_F(AgainstQemu, VfpInThumbComputesTheSame) { execute(true, Kind::VFP, 5); }
TEST_F(AgainstQemu, NeonInArmComputesTheSame) { execute(false, Kind::NEON_COMPUTING, 5); }
TEST_F(AgainstQemu, NeonInThumbComputesTheSame) { execute(true, Kind::NEON_COMPUTING, 5); }
TEST_F(AgainstQemu, ArmLoadsAndStoresReachTheSameOrAbort) { execute(false, Kind::MEMORY, 5); }
TEST_F(AgainstQemu, ThumbLoadsAndStoresReachTheSameOrAbort) { execute(true, Kind::MEMORY, 5); }
TEST_F(AgainstQemu, NeonLoadsAndStoresInArmAgree) { execute(false, Kind::NEON, 5); }
TEST_F(AgainstQemu, NeonLoadsAndStoresInThumbAgree) { execute(true, Kind::NEON, 5); }

}  // namespace against_emulators
