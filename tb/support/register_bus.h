// register_bus.h - test fixture for one block on the register bus: clock, reset, read, write.
#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "tb/support/random_registers.h"

namespace tb {

template <class Dut>
class RegisterBus : public ::testing::Test {
protected:
    static void SetUpTestSuite() { start_with_random_registers(); }

    Dut dut;
    std::uint64_t clocks = 0;

    // Whether a read is of the lowest byte, too, for blocks that need to know.
    template <class Block>
    static auto set_lane(Block& block, bool low, int) -> decltype(void(block.rlow_i)) {
        block.rlow_i = low;
    }
    template <class Block>
    static void set_lane(Block&, bool, long) {}

    // Whether a write makes the bus wait, which keeps its address and data meanwhile.
    template <class Block>
    static auto held(Block& block, int) -> decltype(bool(block.hold_o)) {
        return block.hold_o;
    }
    template <class Block>
    static bool held(Block&, long) {
        return false;
    }

    // Called after each rising edge, for models on the pins.
    virtual void after_clock() {}

    void clock(std::uint64_t count = 1) {
        while (count--) {
            dut.clk_i = 0;
            dut.eval();
            dut.clk_i = 1;
            dut.eval();
            ++clocks;
            after_clock();
        }
    }

    void reset() {
        dut.rst_i = 1;
        dut.we_i = dut.re_i = 0;
        clock(4);
        dut.rst_i = 0;
    }

    void write(std::uint32_t address, std::uint32_t value, std::uint8_t strobes = 0xf) {
        dut.we_i = 1;
        dut.waddr_i = address & 0xfff;
        dut.wdata_i = value;
        dut.wstrb_i = strobes;
        clock();
        dut.we_i = 0;
        const bool waits = held(dut, 0);
        for (int i = 0; held(dut, 0) && i < 100'000; ++i) clock();
        if (waits) clock();  // in which the block takes it
        dut.wdata_i = 0;
        clock();
    }

    std::uint32_t read(std::uint32_t address, bool low = true) {
        dut.re_i = 1;
        set_lane(dut, low, 0);
        dut.raddr_i = address & 0xfff;
        clock();
        dut.re_i = 0;
        return dut.rdata_o;
    }
};

}  // namespace tb
