// The interrupt controller, at its registers, its lines and its two wires to the processor.
#include "tb/sim/hps_bench.h"

namespace {

constexpr unsigned KEY = 73, AUDIO = 78, SPURIOUS = 1023;

class Gic : public tb::HpsBench {
protected:
    void line(unsigned id, bool up) { board.hps.gic.set_level(id, up); }
    void make_edge(unsigned id) { write(GIC + 0xC00 + id / 16 * 4, 2u << id % 16 * 2); }
    bool irq() const { return board.irq; }
};

TEST_F(Gic, FollowsALevelWithIrq) {
    take(KEY);
    EXPECT_FALSE(irq());
    line(KEY, true);
    EXPECT_TRUE(irq());
    line(KEY, false);
    EXPECT_FALSE(irq());
}

TEST_F(Gic, GivesTheIdOnceAndThenNothing) {
    take(KEY);
    line(KEY, true);
    EXPECT_EQ(acknowledge(), KEY);
    EXPECT_EQ(acknowledge(), SPURIOUS);
    EXPECT_FALSE(irq());
}

TEST_F(Gic, RaisesAnActiveLevelAgainAfterItsEnd) {
    take(KEY);
    line(KEY, true);
    end(acknowledge());
    EXPECT_TRUE(irq());
    end(acknowledge());
    line(KEY, false);
    EXPECT_FALSE(irq());
}

TEST_F(Gic, RemembersAnEdgeOnce) {
    take(KEY);
    make_edge(KEY);
    line(KEY, true);
    line(KEY, false);
    EXPECT_TRUE(irq());
    end(acknowledge());
    EXPECT_FALSE(irq());
}

TEST_F(Gic, DoesNotRepeatAnEdgeWhoseLineStaysUp) {
    take(KEY);
    make_edge(KEY);
    line(KEY, true);
    end(acknowledge());
    EXPECT_FALSE(irq());
}

TEST_F(Gic, IsSilentUntilEachOfItsSwitchesIsOn) {
    take(KEY);
    line(KEY, true);
    const struct {
        std::uint32_t address, off, on;
    } switches[] = {{GIC, 0, 1},
                    {GIC_CPU, 0, 1},
                    {GIC_CPU + 4, 0x80, 0xF0},
                    {GIC + 0x188, 1u << (KEY - 64), 0}};
    for (const auto& s : switches) {
        write(s.address, s.off);
        EXPECT_FALSE(irq()) << std::hex << s.address;
        EXPECT_EQ(acknowledge(), SPURIOUS);
        write(s.address, s.on);
        EXPECT_EQ(irq(), s.on != 0) << std::hex << s.address;
    }
}

TEST_F(Gic, DoesNotSendToAProcessorThatIsNoTarget) {
    take(KEY);
    line(KEY, true);
    write(GIC + 0x800 + KEY, 2, 1);
    EXPECT_FALSE(irq());
}

TEST_F(Gic, TargetsNobodyAfterReset) { EXPECT_EQ(read(GIC + 0x800 + 72), 0u); }

TEST_F(Gic, GivesTheMostUrgentFirst) {
    take(KEY, 0xA0);
    take(AUDIO, 0x20);
    line(KEY, true);
    line(AUDIO, true);
    EXPECT_EQ(acknowledge(), AUDIO);
}

TEST_F(Gic, GivesTheLowestIdOfTwoThatAreEquallyUrgent) {
    take(KEY, 0x40);
    take(AUDIO, 0x40);
    line(AUDIO, true);
    line(KEY, true);
    EXPECT_EQ(acknowledge(), KEY);
}

TEST_F(Gic, InterruptsAHandlerForTheMoreUrgentOnly) {
    take(KEY, 0x80);
    take(AUDIO, 0x80);
    line(KEY, true);
    EXPECT_EQ(acknowledge(), KEY);
    line(AUDIO, true);
    EXPECT_FALSE(irq()) << "as urgent";
    write(GIC + 0x400 + AUDIO, 0x40, 1);
    EXPECT_TRUE(irq()) << "more urgent";
    EXPECT_EQ(acknowledge(), AUDIO);
    EXPECT_EQ(read(GIC_CPU + 0x14), 0x40u) << "running priority";
    end(AUDIO);
    EXPECT_EQ(read(GIC_CPU + 0x14), 0x80u);
}

TEST_F(Gic, InterruptsAHandlerByTheBitsAboveTheBinaryPoint) {
    take(KEY, 0x90);
    take(AUDIO, 0x80);
    write(GIC_CPU + 0x08, 5);  // bits 7:6 decide
    line(KEY, true);
    EXPECT_EQ(acknowledge(), KEY);
    line(AUDIO, true);
    EXPECT_FALSE(irq());
    write(GIC_CPU + 0x08, 3);  // bits 7:4
    EXPECT_TRUE(irq());
}

TEST_F(Gic, KeepsFiveBitsOfAPriority) {
    write(GIC + 0x400 + KEY, 0xFF, 1);
    EXPECT_EQ(read(GIC + 0x400 + KEY, 1), 0xF8u);
}

TEST_F(Gic, ChangesOneByteWithoutItsNeighbours) {
    write(GIC + 0x800 + 72, 0x01010101);
    write(GIC + 0x800 + 73, 0x02, 1);
    EXPECT_EQ(read(GIC + 0x800 + 72), 0x01010201u);
}

TEST_F(Gic, SetsAndClearsPendingByHand) {
    take(KEY);
    write(GIC + 0x208, 1u << (KEY - 64));
    EXPECT_TRUE(irq());
    EXPECT_EQ(read(GIC + 0x208), 1u << (KEY - 64));
    write(GIC + 0x288, 1u << (KEY - 64));
    EXPECT_FALSE(irq());
}

TEST_F(Gic, ShowsWhatIsActiveUntilItsEnd) {
    take(KEY);
    line(KEY, true);
    acknowledge();
    EXPECT_EQ(read(GIC + 0x308), 1u << (KEY - 64));
    end(KEY);
    EXPECT_EQ(read(GIC + 0x308), 0u);
}

TEST_F(Gic, SendsSoftwareInterruptsToItself) {
    take(5);
    write(GIC + 0xF00, 0x02000005);
    EXPECT_EQ(acknowledge(), 5u);
    end(5);
    write(GIC + 0xF00, 0x00010005);
    EXPECT_EQ(acknowledge(), 5u);
    end(5);
    write(GIC + 0xF00, 0x00020005);  // to the second processor
    write(GIC + 0xF00, 0x01000005);  // to all others
    EXPECT_EQ(acknowledge(), SPURIOUS);
}

TEST_F(Gic, SignalsSecureInterruptsAsFiqIfEnabled) {
    take(KEY);
    write(GIC_CPU, 9);
    line(KEY, true);
    EXPECT_TRUE(board.fiq);
    EXPECT_FALSE(irq());
}

TEST_F(Gic, IgnoresAnEndOfWhatIsNotActive) {
    take(KEY);
    line(KEY, true);
    end(SPURIOUS);
    end(AUDIO);
    EXPECT_EQ(acknowledge(), KEY);
}

TEST_F(Gic, NumbersTheFpgasInterruptsFrom72) {
    take(KEY);
    board.hps.fpga_interrupts(1u << 1);
    EXPECT_EQ(acknowledge(), KEY);
    take(103);
    board.hps.fpga_interrupts(1u << 31);
    end(KEY);
    EXPECT_EQ(acknowledge(), 103u);
}

TEST_F(Gic, HasTheConfigurationOfTheA9sPrivateInterrupts) {
    EXPECT_EQ(read(GIC + 0xC00), 0xAAAAAAAAu);
    EXPECT_EQ(read(GIC + 0xC04), 0x7DC00000u);  // ARM DDI 0407G, 3.3.9
    EXPECT_EQ(read(GIC + 0x004) & 0x1F, 7u) << "256 IDs";
}

}  // namespace
