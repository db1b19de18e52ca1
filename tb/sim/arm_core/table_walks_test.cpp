// Random translation tables give the same addresses and faults on the processor and on Unicorn, by
// PAR, which Unicorn fills without the memory's type.
#include <gmock/gmock.h>

#include <cstring>

#include "sim/cpu/arm_core.h"
#include "tb/sim/arm_core/machine.h"
#include "tb/sim/arm_core/stream.h"

namespace table_walks {

using namespace tb::core;
using Word = std::uint32_t;

// Of the data: two tables of the first level, 16 KB each; then 32 of the second.
constexpr Word HALF = PART / 2;
constexpr Word SHORT = 0x1000;  // bytes of a first table, if TTBCR.N is 2
constexpr Word CODES_SECTION = 0xC02, OFF = 0x00C50078, ON = OFF | 1, AFE = 1u << 29, PD1 = 1u << 5;
constexpr Word DOMAIN_FAULT = 9 << 1 | 1;  // in PAR; of a page + 4

// Descriptors; where a table may begin, the one of the code's megabyte: itself and of domain 0.
std::vector<Word> any_tables(Random& random) {
    std::vector<Word> words(PART / 4);
    for (Word i = 0; i < words.size(); ++i) {
        const Word bits = static_cast<Word>(random());
        const bool to_second = i < HALF / 4 && bits % 4 == 1;
        words[i] = to_second ? DATA | HALF | (bits & (HALF - 0x400)) | (bits & 0x1E0) | 1 : bits;
    }
    for (Word i = 0; i < HALF / 8; i += SHORT / 4) words[i] = CODES_SECTION;
    return words;
}

Word mcr(const sim::Cp15& name, Word from) {
    return 0xEE000F10 | name.op1 << 21 | name.crn << 16 | from << 12 | name.op2 << 5 | name.crm;
}

class TableWalks : public ::testing::Test {
protected:
    TableWalks() {
        for (Word i = 0; i < 4; ++i)  // for reading, writing, by the user mode
            walk.insert(walk.end(), {mcr({7, 0, 8, i}, 0), mcr(sim::cp15::PAR, 8 + i) | 1u << 20});
    }
    // On both machines.
    void run(const std::vector<Word>& code, Word at) {
        for (unsigned i = 0; i < 2; ++i) {
            Machine& machine = *machines[i];
            const auto bytes = static_cast<Word>(4 * code.size());
            std::uint8_t* const place = &machine.memory->code[at - CODE];
            if (std::memcmp(place, code.data(), bytes) != 0) {
                std::memcpy(place, code.data(), bytes);
                std::memcpy(place + bytes, &UDF, 4);
                machine.code_changed(at, bytes + 4);
            }
            machine.set(state);
            const Word end = at + bytes, ended = machine.run(at, end, bytes / 4);
            ASSERT_TRUE(ended == end || ended == end + Machine::UNDEFINED) << std::hex << ended;
            after[i] = machine.state();
        }
    }

    static constexpr Word UDF = 0xE7F000F0;
    std::vector<Word> walk;
    std::unique_ptr<Machine> machines[2]{unicorn(), processor(false)};
    State state, after[2];
};

TEST_F(TableWalks, LeadToTheSameAddressesAndFaults) {
    using namespace sim::cp15;
    Random random{1};
    state.cpsr = 0x1D3;
    for (unsigned i = 0; i < 60; ++i) {
        const auto tables = any_tables(random);
        for (const auto& machine : machines)
            std::memcpy(machine->memory->data.data(), tables.data(), PART);
        const Word flag = random() % 2 ? AFE : 0;
        state.r[2] = static_cast<Word>(random()) & (PD1 | 7);
        const bool is_short = (state.r[2] & 7) >= 2;
        state.r[0] = DATA + (is_short ? SHORT * static_cast<Word>(random() % 4) : 0);
        state.r[1] = DATA + HALF / 2;
        state.r[3] = (static_cast<Word>(random()) & ~2u) | 1;
        if (flag) state.r[3] &= 0x55555555;  // Unicorn does not ask it of a manager
        state.r[4] = ON | flag;
        run({mcr(TTBR0, 0), mcr(TTBR1, 1), mcr(TTBCR, 2), mcr(DACR, 3), mcr(SCTLR, 4)}, CODE);
        for (unsigned j = 0; j < 100; ++j) {
            state.r[0] = static_cast<Word>(random());
            run(walk, CODE + 0x100);
            for (Word n = 8; n < 12; ++n) {
                Word &e = after[0].r[n], &a = after[1].r[n];
                for (Word* const par : {&e, &a}) *par &= *par & 1 ? 0x7F : 0xFFFFF003;
                // Unicorn asks the domain before the second table and the access flag, against
                // B3.13.3.
                if ((e & ~4u) == DOMAIN_FAULT && (a & 1)) a = e;
            }
            ASSERT_EQ(difference(after[0], after[1], 0), "") << std::hex << state.r[0];
        }
        state.r[4] = OFF;
        run({mcr(SCTLR, 4)}, CODE + 0x200);
        if (HasFatalFailure()) return;
    }
}

}  // namespace table_walks
