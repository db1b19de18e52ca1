// Registers of coprocessor 15 that Unicorn does not have so, and what is accepted there (ARM ARM,
// B3.17, B4.1, C12; Cortex-A9 TRM, chapters 4 and 11).  All others are compared with Unicorn's.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace system_registers {

using namespace tb::core;
using sim::Cp15;

class SystemRegisters : public SystemTest {
protected:
    void write(const Cp15& name, std::uint32_t value) {
        set(1, value);
        done(mcr(name));
    }
    std::uint32_t read(const Cp15& name) {
        done(mrc(name));
        return reg(2);
    }
};

TEST_P(SystemRegisters, IdentifyTheProcessor) {
    EXPECT_EQ(read({0, 0, 0, 0}), 0x413FC090u) << "MIDR: Cortex-A9 r3p0";
    EXPECT_EQ(read({0, 0, 0, 5}), 0x80000000u) << "MPIDR: the first core";
    EXPECT_EQ(read(sim::cp15::CBAR), 0xFFFEC000u);
    EXPECT_EQ(read(sim::cp15::SCTLR), 0x00C50078u) << "after reset";
    write(sim::cp15::SCTLR, 0x1804);
    EXPECT_EQ(read(sim::cp15::SCTLR), 0x00C5187Cu) << "caches and branch prediction on";
    become(USR);
    refused(mrc(sim::cp15::SCTLR));
}

// Bytes of a cache by CCSIDR: lines of so many words, ways, sets.
TEST_P(SystemRegisters, ShowThatTheCachesHave32Kilobytes) {
    for (const std::uint32_t instructions : {0u, 1u}) {
        write({0, 2, 0, 0}, instructions);
        const std::uint32_t ccsidr = read({0, 1, 0, 0});
        const std::uint32_t line = 16u << (ccsidr & 7), ways = (ccsidr >> 3 & 0x3FF) + 1,
                            sets = (ccsidr >> 13 & 0x7FFF) + 1;
        EXPECT_EQ(line, 32u);
        EXPECT_EQ(ways, 4u);
        EXPECT_EQ(line * ways * sets, 32u << 10);
    }
}

// ---- Operations ---------------------------------------------------------------------------------

constexpr Cp15 OPERATIONS[] = {
    {7, 0, 1, 0},  {7, 0, 1, 6},                                // ICIALLUIS, BPIALLIS
    {7, 0, 5, 0},  {7, 0, 5, 1},  {7, 0, 5, 6},  {7, 0, 5, 7},  // ICIALLU, ICIMVAU, BPIALL, BPIMVA
    {7, 0, 6, 1},  {7, 0, 6, 2},                                // DCIMVAC, DCISW
    {7, 0, 10, 1}, {7, 0, 10, 2}, {7, 0, 11, 1},                // DCCMVAC, DCCSW, DCCMVAU
    {7, 0, 14, 1}, {7, 0, 14, 2},                               // DCCIMVAC, DCCISW
    {8, 0, 3, 0},  {8, 0, 3, 1},  {8, 0, 3, 2},  {8, 0, 3, 3},  // TLBs of all cores
    {8, 0, 5, 0},  {8, 0, 5, 1},  {8, 0, 5, 2},                 // of instructions
    {8, 0, 6, 0},  {8, 0, 6, 1},  {8, 0, 6, 2},                 // of data
    {8, 0, 7, 0},  {8, 0, 7, 1},  {8, 0, 7, 2},  {8, 0, 7, 3},  // of both
};

TEST_P(SystemRegisters, AcceptMaintenanceByPrivilegedModes) {
    set(1, 0x4000);
    bench.put(0x4000, {0x12345678});
    for (const Cp15& operation : OPERATIONS) done(mcr(operation));
    become(USR);
    for (const Cp15& operation : OPERATIONS) refused(mcr(operation));
    EXPECT_EQ(bench.word(0x4000), 0x12345678u) << "invalidated, but there is no cache";
}

TEST_P(SystemRegisters, RefuseWhatDoesNotExist) {
    for (const std::uint32_t word : {
             0xEE102710u,  // MRC p7, 0, r2, c0, c0, 0
             0xEE001710u,  // MCR p7, 0, r1, c0, c0, 0
             0xEE142F10u,  // MRC p15, 0, r2, c4, c0, 0
             0xEE041F10u,  // MCR p15, 0, r1, c4, c0, 0
             0xEC421F02u,  // MCRR p15, 0, r1, r2, c2
             0xEC521F02u,  // MRRC p15, 0, r1, r2, c2
             0xEE000F00u,  // CDP p15, 0, c0, c0, c0, 0
             0xED910F00u,  // LDC p15, c0, [r1]
         })
        refused({word, word});
}

// A8.8.229; not in Thumb.
TEST_P(SystemRegisters, SwitchSwpOn) {
    if (thumb()) return;
    constexpr Both SWP{0xE1012093, 0}, SWPB{0xE1412093, 0};  // r2, r3, [r1]
    bench.put(0x4000, {0x8182F3F4});
    set(1, 0x4000);
    refused(SWP);
    write(sim::cp15::SCTLR, 1u << 10);
    set(1, 0x4000);
    set(3, 0x01020304);
    done(SWP);
    EXPECT_EQ(reg(2), 0x8182F3F4u);
    EXPECT_EQ(bench.word(0x4000), 0x01020304u);
    set(3, 0x99);
    done(SWPB);
    EXPECT_EQ(reg(2), 4u);
    EXPECT_EQ(bench.word(0x4000), 0x01020399u);
}

// ---- The cycle counter, which counts instructions -----------------------------------------------

constexpr Cp15 PMCR{9, 0, 12, 0}, PMCNTENSET{9, 0, 12, 1}, PMCNTENCLR{9, 0, 12, 2},
    PMCCNTR{9, 0, 13, 0}, PMUSERENR{9, 0, 14, 0}, PMINTENSET{9, 0, 14, 1};
constexpr std::uint32_t CYCLES = 1u << 31, ENABLE = 1, CLEAR = 4;

class CycleCounter : public SystemRegisters {
protected:
    // From one reading to the next, with a WFI between them.
    std::uint32_t counted() {
        const std::uint32_t before = read(PMCCNTR);
        return read(PMCCNTR) - before;
    }
    void start() {
        write(PMCNTENSET, CYCLES);
        write(PMCR, ENABLE | CLEAR);
    }
};

TEST_P(CycleCounter, CountsEachInstructionBetweenTwoReadings) {
    start();
    constexpr unsigned NOPS = 50;
    std::vector<Both> code(NOPS + 4, NOP);
    code.front() = mrc(PMCCNTR, 2);
    code[NOPS + 1] = mrc(PMCCNTR, 3);
    code[NOPS + 2] = WFI;
    code.back() = SPIN;
    put(AT, code);
    set(15, AT);
    ASSERT_EQ(run(), sim::ArmStop::WFI);
    EXPECT_EQ(reg(3) - reg(2), NOPS + 1);
}

TEST_P(CycleCounter, StandsUnlessBothOfItsSwitchesAreOn) {
    EXPECT_EQ(counted(), 0u) << "after reset";
    write(PMCR, ENABLE);
    EXPECT_EQ(counted(), 0u) << "not in PMCNTENSET";
    start();
    EXPECT_EQ(counted(), 2u) << "runs";
    write(PMCNTENCLR, 1);
    EXPECT_EQ(counted(), 2u) << "another counter is stopped";
    write(PMCNTENCLR, CYCLES);
    EXPECT_EQ(read(PMCNTENSET) & CYCLES, 0u);
    const std::uint32_t stopped = read(PMCCNTR);
    EXPECT_EQ(read(PMCCNTR), stopped) << "PMCNTENCLR";
    write(PMCNTENSET, CYCLES);
    EXPECT_EQ(read(PMCNTENCLR) & CYCLES, CYCLES);
    EXPECT_EQ(read(PMCCNTR), stopped + 4) << "goes on where it was";
    write(PMCR, 0);
    EXPECT_EQ(counted(), 0u) << "PMCR.E clear";
    EXPECT_EQ(read(PMCR), 0x41093000u);
}

TEST_P(CycleCounter, IsSetAndCleared) {
    start();
    write(PMCCNTR, 0xFFFFFFFE);
    EXPECT_EQ(read(PMCCNTR), 0u) << "two instructions later";
    write(PMCR, ENABLE | CLEAR);
    EXPECT_EQ(read(PMCCNTR), 2u);
    EXPECT_EQ(read(PMCR), 0x41093000 | ENABLE) << "C reads as zero";
}

// C12.8: PMUSERENR itself can always be read.
TEST_P(CycleCounter, IsTheUsersWhenPmuserenrSaysSo) {
    start();
    become(USR);
    for (const Cp15& name : {PMCCNTR, PMCR, PMCNTENSET, PMCNTENCLR}) {
        refused(mrc(name));
        refused(mcr(name));
    }
    EXPECT_EQ(read(PMUSERENR), 0u);
    become(SVC);
    write(PMUSERENR, 1);
    become(USR);
    EXPECT_EQ(read(PMUSERENR), 1u);
    EXPECT_EQ(counted(), 2u);
    write(PMCR, ENABLE | CLEAR);
    EXPECT_EQ(read(PMCCNTR), 2u);
    write(PMCNTENCLR, CYCLES);
    EXPECT_EQ(counted(), 0u);
    EXPECT_EQ(read(PMCNTENSET), 0u);
    refused(mcr(PMUSERENR));
    refused(mrc(PMINTENSET));
    refused(mcr(PMINTENSET));
}

INSTANTIATE_TEST_SUITE_P(In, SystemRegisters, EACH_WAY, name_of_way);
INSTANTIATE_TEST_SUITE_P(In, CycleCounter, EACH_WAY, name_of_way);

}  // namespace system_registers
