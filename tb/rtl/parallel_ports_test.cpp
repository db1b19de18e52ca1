// parallel_ports_test.cpp - LEDR, HEX, SW, KEY, JP1 and JP2 together: byte strobes, and what the
// offsets read at which a port has no register.
#include <gtest/gtest.h>

#include "Vparallel_ports.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

using namespace regmap;

// The select line of the block at this base: they are numbered in the map's order.
constexpr unsigned line_of(std::uint32_t base) {
    unsigned line = 0;
    for (const Block& block : BLOCKS) {
        if (block.base == base) return line;
        if (block.base >= LEDR_BASE) ++line;
    }
    return 31;
}

class ParallelPorts : public tb::RegisterBus<Vparallel_ports> {
protected:
    void SetUp() override {
        dut.sw_i = 0;
        dut.key_ni = 0xf;
        dut.jp1_i = dut.jp2_i = 0xffffffff;
        reset();
        clock(4);
    }
    void write(std::uint32_t address, std::uint32_t value, std::uint8_t strobes = 0xf) {
        dut.we_i = 1u << line_of(address & ~0xfu);
        dut.waddr_i = address & 0xfff;
        dut.wdata_i = value;
        dut.wstrb_i = strobes;
        clock();
        dut.we_i = 0;
        clock();
    }
    std::uint32_t read(std::uint32_t address) {
        dut.re_i = 1u << line_of(address & ~0xfu);
        dut.raddr_i = address & 0xfff;
        clock();
        dut.re_i = 0;
        return dut.rdata_o;
    }
    std::uint64_t lit() const { return ~dut.hex_no & 0x3ffffffffff; }

    // Writes ones to one byte after the other, then zeros; the register has no other bits.
    void change_by_bytes(std::uint32_t address, std::uint32_t bits) {
        write(address, 0);
        std::uint32_t expected = 0;
        for (const std::uint32_t value : {0xffffffffu, 0u})
            for (unsigned byte = 0; byte < 4; ++byte) {
                write(address, value, static_cast<std::uint8_t>(1u << byte));
                const std::uint32_t lane = 0xffu << 8 * byte & bits;
                expected = value ? expected | lane : expected & ~lane;
                EXPECT_EQ(read(address), expected) << std::hex << address << " byte " << byte;
            }
        write(address, 0xffffffff, 0);
        EXPECT_EQ(read(address), 0u) << std::hex << address << " without a byte";
    }
    // There is no register at the offset.
    void is_nowhere(std::uint32_t address) {
        write(address, 0xffffffff);
        EXPECT_EQ(read(address), 0u) << std::hex << address;
    }
};

TEST_F(ParallelPorts, ChangeByTheBytesThatAreWritten) {
    change_by_bytes(LEDR_DATA, 0x3ff);
    change_by_bytes(HEX3_0_DATA, 0x7f7f7f7f);
    change_by_bytes(HEX5_4_DATA, 0x00007f7f);
    change_by_bytes(KEY_MASK, 0xf);
    for (const std::uint32_t header : {JP1_BASE, JP2_BASE}) {
        change_by_bytes(header + JP1_DIR - JP1_BASE, 0xffffffff);
        change_by_bytes(header + JP1_MASK - JP1_BASE, 0xffffffff);
    }
}

TEST_F(ParallelPorts, DriveTheHeadersByTheBytesThatAreWritten) {
    write(JP1_DATA, 0x11223344);
    write(JP2_DATA, 0x55667788);
    for (unsigned byte = 0; byte < 4; ++byte) {
        write(JP1_DATA, 0xa1b2c3d4, static_cast<std::uint8_t>(1u << byte));
        const std::uint32_t written = 0xffffffffu >> (24 - 8 * byte);
        EXPECT_EQ(dut.jp1_o, (0xa1b2c3d4 & written) | (0x11223344 & ~written));
        EXPECT_EQ(dut.jp2_o, 0x55667788u);
    }
}

TEST_F(ParallelPorts, ReadThePinsOfAHeaderAfterTwoFlipFlops) {
    write(JP1_DIR, 0xffffffff);
    write(JP1_DATA, 0);
    dut.jp1_i = 0x3c3c3c3c;
    clock();
    EXPECT_EQ(read(JP1_DATA), 0xffffffffu);
    EXPECT_EQ(read(JP1_DATA), 0x3c3c3c3cu) << "and not what was written";
    clock();
    EXPECT_EQ(dut.rdata_o, 0u) << "when it was not asked";
}

TEST_F(ParallelPorts, ForgetTheEdgesOfTheBytesThatAreWritten) {
    dut.jp2_i = 0;
    clock(4);
    EXPECT_EQ(read(JP1_EDGE), 0u);
    std::uint32_t left = 0xffffffff;
    for (unsigned byte = 0; byte < 4; ++byte) {
        EXPECT_EQ(read(JP2_EDGE), left);
        write(JP2_EDGE, 0xffffffff, static_cast<std::uint8_t>(1u << byte));
        left &= ~(0xffu << 8 * byte);
    }
    EXPECT_EQ(read(JP2_EDGE), 0u);
}

TEST_F(ParallelPorts, HaveLampsAtTheirFirstOffsetAlone) {
    write(LEDR_DATA, 0x2a5);
    write(HEX3_0_DATA, 0x01020304);
    write(HEX5_4_DATA, 0x0506);
    for (const std::uint32_t base : {LEDR_BASE, HEX3_0_BASE, HEX5_4_BASE})
        for (const std::uint32_t offset : {0x4u, 0x8u, 0xcu}) is_nowhere(base + offset);
    EXPECT_EQ(dut.ledr_o, 0x2a5);
    EXPECT_EQ(lit(), 0x05ull << 35 | 0x06ull << 28 | 0x01ull << 21 | 0x02ull << 14 | 0x03ull << 7 |
                         0x04ull);
    EXPECT_EQ(read(LEDR_DATA), 0x2a5u);
    EXPECT_EQ(read(HEX3_0_DATA), 0x01020304u);
    EXPECT_EQ(read(HEX5_4_DATA), 0x0506u);
}

TEST_F(ParallelPorts, HaveSwitchesWithoutDirectionMaskOrEdges) {
    dut.sw_i = 0x3ff;
    clock(4);
    write(SW_DATA, 0);
    EXPECT_EQ(read(SW_DATA), 0x3ffu);
    dut.sw_i = 0x15a;
    clock(4);
    EXPECT_EQ(read(SW_DATA), 0x15au);
    for (const std::uint32_t offset : {0x4u, 0x8u, 0xcu}) is_nowhere(SW_BASE + offset);
    EXPECT_EQ(read(SW_DATA), 0x15au);
}

TEST_F(ParallelPorts, HaveKeysThatNothingDrives) {
    dut.key_ni = 0x9;
    clock(4);
    for (const std::uint32_t value : {0xffffffffu, 0u}) {
        write(KEY_DATA, value);
        clock(4);
        EXPECT_EQ(read(KEY_DATA), 6u);
        EXPECT_EQ(read(KEY_EDGE), 0u);
    }
    is_nowhere(KEY_BASE + 0x4);
    EXPECT_EQ(read(KEY_DATA), 6u);
}

TEST_F(ParallelPorts, AreDarkAndOpenAfterAReset) {
    for (const std::uint32_t data : {LEDR_DATA, HEX3_0_DATA, HEX5_4_DATA, JP1_DATA, JP2_DATA})
        write(data, 0xffffffff);
    for (const std::uint32_t direction : {JP1_DIR, JP2_DIR}) write(direction, 0xffffffff);
    reset();
    EXPECT_EQ(dut.ledr_o, 0);
    EXPECT_EQ(lit(), 0u);
    EXPECT_EQ(dut.jp1_o | dut.jp2_o, 0u);
    EXPECT_EQ(dut.jp1_oe_o | dut.jp2_oe_o, 0u);
}

TEST_F(ParallelPorts, InterruptEachForItself) {
    const auto irqs = [this] { return dut.key_irq_o | dut.jp1_irq_o << 1 | dut.jp2_irq_o << 2; };
    for (const std::uint32_t mask : {KEY_MASK, JP1_MASK, JP2_MASK}) write(mask, 0xffffffff);
    dut.key_ni = 0;
    clock(4);
    EXPECT_EQ(irqs(), 0) << "pressed";
    dut.key_ni = 0xf;
    clock(4);
    EXPECT_EQ(irqs(), 1);
    write(KEY_EDGE, 0xf);
    dut.jp1_i = 0x7fffffff;
    clock(4);
    EXPECT_EQ(irqs(), 2);
    write(JP1_EDGE, 0x80000000);
    dut.jp2_i = 0xfffffffe;
    clock(4);
    EXPECT_EQ(irqs(), 4);
}

}  // namespace
