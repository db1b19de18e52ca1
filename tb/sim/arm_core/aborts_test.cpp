// A load or store without a target has no effect: registers, flags, IT block and pc are those
// before it, whether it is executed for the first time or has been translated long ago.  The
// registers of a load of several are UNKNOWN (B1.9.8), except for its base.
#include <gmock/gmock.h>

#include <array>
#include <string>

#include <fmt/format.h>

#include "tb/sim/arm_core/bench.h"
#include "tb/sim/arm_core/maker.h"

namespace aborts {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t AT = 0x8000;
constexpr std::uint32_t ISLAND = 0x200000;  // 4 KB of RAM, after which there is no target
constexpr std::uint32_t FLAGS = 0x60000000, MODE = 0x1D3, THUMB = 0x20, IN_IT = 0x800;
constexpr std::uint32_t UNALIGNED = 1;  // fault status

struct Registers16 {
    std::array<std::uint32_t, 16> r;
    std::uint32_t cpsr;
    std::array<std::uint64_t, 32> d;
};

struct Case {
    std::string name;
    std::uint32_t word;
    bool thumb, it;
    Registers registers;
    bool loads_pc = false;  // so it may branch anywhere
};

class Aborts : public ::testing::Test {
protected:
    Aborts() {
        bench.core.map_ram(ISLAND, 0x1000, island.data());
        bench.core.map_bus(ISLAND + 0x1000, 0x1000, ISLAND + 0x1000);
    }

    // Every row that may abort, some instructions of each.
    void each(const std::vector<Encoding>& rows, bool thumb, bool shared);
    void try_all_ways(const Case& c);

private:
    void put(const Case& c);
    void set(const Case& c, std::uint32_t place);
    // True: aborted, and as it should.
    bool go(const Case& c, const char* when);
    Registers16 now() const;

    alignas(4096) std::array<std::uint8_t, 4096> island{};
    Bench bench;
    Random random{1};
};

Registers16 Aborts::now() const {
    Registers16 now;
    for (unsigned i = 0; i < 16; ++i) now.r[i] = bench.core.reg(i);
    for (unsigned i = 0; i < 32; ++i) now.d[i] = bench.core.vfp(i);
    now.cpsr = bench.core.cpsr();
    return now;
}

// CMP r0, r0 twice, the access, and CMP, in an IT block of its own.
void Aborts::put(const Case& c) {
    if (!c.thumb) {
        bench.put(AT, {0xE1500000, 0xE1500000, c.word, 0xE1500000, 0xEAFFFFFE});
        return;
    }
    std::vector<std::uint16_t> code{0x4280, 0x4280};
    if (c.it) code.push_back(0xBF08);
    if (c.word > 0xFFFF) code.push_back(static_cast<std::uint16_t>(c.word >> 16));
    code.push_back(static_cast<std::uint16_t>(c.word));
    code.insert(code.end(), {0x4280, 0xE7FE});
    bench.put_halves(AT, code);
}

void Aborts::set(const Case& c, std::uint32_t place) {
    const auto bits = [&] { return static_cast<std::uint32_t>(random()); };
    bench.core.set_cpsr(FLAGS | MODE | (c.thumb ? THUMB : 0));
    for (unsigned i = 0; i < 15; ++i) bench.core.set_reg(i, bits());
    for (unsigned i = 0; i < 32; ++i) bench.core.set_vfp(i, bits() | std::uint64_t{bits()} << 32);
    for (const unsigned base : {c.registers.low_base, 13u}) bench.core.set_reg(base, place & ~3u);
    for (const unsigned base : {c.registers.low_any, c.registers.high_any})
        bench.core.set_reg(base, place);
    bench.core.set_reg(c.registers.low_index, bits() % 8 * 4);
    bench.core.set_reg(c.registers.high_index, (bits() % 8) << 22);
    bench.core.set_reg(15, AT);
}

bool Aborts::go(const Case& c, const char* when) {
    const Registers16 before = now();
    const unsigned length = 2 + c.it;
    const std::uint64_t began = bench.core.instructions();
    const ArmStop stop = bench.core.run(200);  // longer than the block, which is translated
    if (stop == ArmStop::LIMIT || (c.loads_pc && stop != ArmStop::DATA_ABORT)) return false;
    const Registers16 after = now();
    const std::string what =
        fmt::format("{} {:08x}{} {}", c.name, c.word, c.it ? " in IT" : "", when);

    EXPECT_EQ(stop, ArmStop::DATA_ABORT) << what;
    EXPECT_EQ(after.r[15], AT + (c.thumb ? 2 * length : 8)) << what;
    EXPECT_EQ(after.cpsr, before.cpsr | (c.it ? IN_IT : 0)) << what;
    EXPECT_EQ(bench.core.instructions() - began, length + 1) << what;
    const bool multiple = c.name.compare(0, 3, "LDM") == 0 || c.name == "POP";
    for (unsigned i = 0; i < 15; ++i) {
        const bool unknown = multiple && bit(c.word, i) && i != c.registers.low_base;
        EXPECT_TRUE(unknown || after.r[i] == before.r[i])
            << what << ": r" << i << " " << std::hex << before.r[i] << " is " << after.r[i];
    }
    const bool unknown = c.name == "VLDM" || c.name.compare(0, 4, "VLD1") == 0;
    EXPECT_TRUE(unknown || after.d == before.d) << what;

    const sim::ArmFault& fault = bench.core.fault();
    const bool answered = fault.address < REFUSED || fault.address - ISLAND < 0x1000;
    const bool refused =
        fault.address - REFUSED < 0x1000 || fault.address - (ISLAND + 0x1000) < 0x1000;
    if (fault.mmu && fault.status == UNALIGNED) return true;
    EXPECT_FALSE(answered) << what << std::hex << fault.address;
    EXPECT_EQ(fault.mmu, !refused) << what << std::hex << fault.address;
    return true;
}

void Aborts::try_all_ways(const Case& c) {
    const std::uint32_t edges[]{ISLAND, ISLAND + 0x1000, BUS, REFUSED, NOTHING};
    unsigned aborted = 0;
    for (const std::uint32_t edge : edges) {
        const std::uint32_t any = edge - 40 + static_cast<std::uint32_t>(random() % 80);
        const std::uint32_t place = c.loads_pc ? any & ~3u : any;
        put(c);
        set(c, place);
        aborted += go(c, "for the first time");
        put(c);
        set(c, RAM / 2);
        go(c, "in RAM");  // except for RRX, which leaves it
        for (const char* when : {"behind RAM", "again"}) {
            set(c, place);
            aborted += go(c, when);
        }
        set(c, RAM / 2);
        go(c, "in RAM again");
    }
    EXPECT_GT(aborted, 0u) << c.name << std::hex << " " << c.word;
}

void Aborts::each(const std::vector<Encoding>& rows, bool thumb, bool shared) {
    for (const Encoding& row : rows) {
        const std::string name = row.name;
        const bool memory =
            name.compare(0, 2, "VL") == 0 || name.compare(0, 2, "VS") == 0 || !shared;
        if (!memory || name.find("iteral") != std::string::npos || name[0] == 'C' ||
            name.compare(0, 2, "PL") == 0 || name == "VSUB" || name == "VSQRT")
            continue;
        for (unsigned i = 0; i < 12 && !HasFailure(); ++i) {
            Maker maker{random, thumb};
            std::uint32_t word = maker.word(row);
            if (row.bits[0] == 'c') word = (word & 0x0FFFFFFF) | 0xE0000000;
            if (thumb && shared) word = to_thumb(word);
            try_all_ways({name, word, thumb, thumb && i % 3 == 0, maker.registers()});
        }
    }
}

// The base is r4 or sp.
TEST_F(Aborts, KeepTheBaseOfAMultipleThatListsItOrPc) {
    const std::uint32_t arm[]{
        0xE8940078,  // LDM r4, {r3-r6}
        0xE9940038,  // LDMIB r4, {r3-r5}
        0xE8140018,  // LDMDA r4, {r3, r4}
        0xE9140038,  // LDMDB r4, {r3-r5}
        0xE8948010,  // LDM r4, {r4, pc}
        0xE8B48008,  // LDM r4!, {r3, pc}
        0xE9B48008,  // LDMIB r4!, {r3, pc}
        0xE8348008,  // LDMDA r4!, {r3, pc}
        0xE9348008,  // LDMDB r4!, {r3, pc}
        0xE8BD8003,  // POP {r0, r1, pc}
        0xE8A48008,  // STM r4!, {r3, pc}
        0xE9248008,  // STMDB r4!, {r3, pc}
        0xE49DF004,  // POP {pc}
        0xE5BDF004,  // LDR pc, [sp, #4]!
    };
    const std::uint32_t in_thumb[]{
        0xCC78,      // LDM r4, {r3-r6}
        0xE8940078,  // LDM.W r4, {r3-r6}
        0xE9140038,  // LDMDB r4, {r3-r5}
        0xE8B48008,  // LDM.W r4!, {r3, pc}
        0xE9348008,  // LDMDB r4!, {r3, pc}
        0xBD03,      // POP {r0, r1, pc}
        0xF85DFB04,  // LDR pc, [sp], #4
    };
    Registers registers;
    registers.low_base = registers.low_any = registers.high_any = 4;
    registers.low_index = 8;
    registers.high_index = 9;
    for (unsigned i = 0; i < 20; ++i) {
        for (const std::uint32_t word : arm)
            try_all_ways({"LDM", word, false, false, registers, true});
        for (const std::uint32_t word : in_thumb)
            try_all_ways({"LDM", word, true, i % 2 == 0, registers, true});
    }
}

TEST_F(Aborts, LeaveRegistersAloneInArm) { each(arm_memory_encodings(), false, false); }
TEST_F(Aborts, LeaveRegistersAloneInThumb) { each(thumb_memory_encodings(), true, false); }
TEST_F(Aborts, OfVfpLeaveRegistersAloneInArm) { each(vfp_encodings(), false, true); }
TEST_F(Aborts, OfVfpLeaveRegistersAloneInThumb) { each(vfp_encodings(), true, true); }
TEST_F(Aborts, OfNeonLeaveRegistersAloneInArm) { each(neon_memory_encodings(), false, true); }
TEST_F(Aborts, OfNeonLeaveRegistersAloneInThumb) { each(neon_memory_encodings(), true, true); }

}  // namespace aborts
