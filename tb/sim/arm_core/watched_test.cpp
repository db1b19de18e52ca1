// A watchpoint ends run() at the load or store that touches it, of whichever kind: nothing has been
// done and nothing is counted; the next time it is done.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace watched {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t PLACE = 0x4000, LAND = 0x9000;

struct Watch final : sim::ArmWatch {
    bool touched(std::uint32_t address, unsigned bytes, bool) override {
        return on && address < PLACE + 8 && address + bytes > PLACE + 4;
    }
    bool on = true;
};

class Watched : public SystemTest {
protected:
    // The second word of PLACE is touched, where r1 and the stack are.
    // What a load of several registers has loaded before may stay in r2.
    void expect_stop(Both instruction, bool several = false) {
        if (thumb() && !instruction.thumb) return;
        SCOPED_TRACE(instruction.arm);
        bench.put(LAND, {WFI.arm, SPIN.arm});
        become(IRQ);
        bench.core.set_spsr(SYS);
        bench.put(PLACE, {LAND, SYS});
        for (unsigned i = 0; i < 15; ++i) set(i, 0x100 + i);
        set(1, PLACE);
        set(13, PLACE);
        for (unsigned again = 0; again < 2; ++again) {
            watch.on = true;
            become(IRQ);
            const std::uint64_t before = bench.core.instructions();
            const std::uint32_t cpsr = bench.core.cpsr();
            EXPECT_EQ(execute(instruction), ArmStop::LIMIT);
            EXPECT_EQ(bench.core.pc(), AT);
            EXPECT_EQ(bench.core.cpsr(), cpsr);
            EXPECT_EQ(bench.core.instructions(), before);
            for (unsigned i = 0; i < 15; ++i) {
                const bool unknown = several && i == 2;
                EXPECT_TRUE(unknown || reg(i) == (i == 1 || i == 13 ? PLACE : 0x100 + i)) << i;
            }
        }
        watch.on = false;
        EXPECT_EQ(run(), ArmStop::WFI);
    }
    // A run in single steps ends where it does not get on.
    ArmStop run() {
        if (!stepping()) return bench.core.run(1000);
        for (unsigned i = 0; i < 10; ++i) {
            const std::uint64_t before = bench.core.instructions();
            const ArmStop stop = bench.core.run(1);
            if (stop != ArmStop::LIMIT || bench.core.instructions() == before) return stop;
        }
        return ArmStop::LIMIT;
    }
    ArmStop execute(Both instruction) {
        SystemTest::put(instruction);
        set(15, AT);
        return run();
    }
    void SetUp() override { bench.core.watch(&watch); }

    Watch watch;
};

TEST_P(Watched, StopsLoadsAndStores) {
    expect_stop({0xE5912004, 0x684A});            // LDR r2, [r1, #4]
    expect_stop({0xE5812004, 0x604A});            // STR r2, [r1, #4]
    expect_stop({0xE5B12004, 0xF8512F04});        // LDR r2, [r1, #4]!
    expect_stop({0xE5912002, 0xF8D12002});        // LDR r2, [r1, #2]
    expect_stop({0xE1C120D0, 0xE9D12300}, true);  // LDRD r2, r3, [r1]
    expect_stop({0xE8B1000C, 0xE8B1000C}, true);  // LDM r1!, {r2, r3}
    expect_stop({0xE8A1000C, 0xE8A1000C});        // STM r1!, {r2, r3}
    expect_stop({0xECB10B02, 0xECB10B02});        // VLDM r1!, {d0}
}

TEST_P(Watched, StopsWhatIsLeftOutOfTranslatedCode) {
    expect_stop({0xE8910006, 0xC906});      // LDM r1, {r1, r2}
    expect_stop({0xF8B10A00, 0xE9B1C000});  // RFEIA r1!
    expect_stop({0xF8ED0512, 0xE9ADC012});  // SRSIA sp!, #IRQ
    expect_stop({0xE8D16000, 0});           // LDM r1, {sp, lr}^
    expect_stop({0xE8C16000, 0});           // STM r1, {sp, lr}^
}

INSTANTIATE_TEST_SUITE_P(In, Watched, EACH_WAY, name_of_way);

}  // namespace watched
