// video_in_bench.h - video_in.v with the decoder chip on its pins, and memories that record what is
// written
#pragma once

#include <gmock/gmock.h>

#include <map>

#include "Vvideo_in.h"
#include "regmap.h"
#include "sim/board/adv7180.h"
#include "sim/fpga/asynchronous_clock.h"
#include "tb/support/register_bus.h"

namespace tb {

class VideoIn : public RegisterBus<Vvideo_in> {
protected:
    static constexpr std::uint32_t ENABLE = regmap::VIDEO_IN_STATUS_EN_MASK;
    static constexpr unsigned LINE_CLOCKS = 1589;  // a line of the camera, in clocks; 1588.9

    sim::Adv7180 chip;
    std::map<std::uint32_t, std::uint32_t> written;  // word by address
    std::uint64_t writes = 0;
    std::uint64_t ahead = 0;                // the chip's clock is ahead by so many clocks
    std::uint8_t damage = 0;                // bits that are wrong in each code
    unsigned damaged_byte = 3;              // of its four
    std::uint64_t busy_for = 0, every = 1;  // the memories are busy for `busy_for` of `every`
                                            // clocks
    sim::AsynchronousClock td_clock = sim::decoder_clock();

    void SetUp() override {
        dut.edges_we_i = dut.edges_re_i = 0;
        dut.rst_td_i = 1;
        dut.rst_i = 1;
        clock(20);
        dut.rst_td_i = 0;
        reset();
        clock(4);
    }

    void after_clock() override {
        for (; td_clock.clocks() < clocks; td_clock.next()) {
            dut.clk_td_i = td_clock.rises() && (dut.td_awake_o || dut.rst_td_i);
            if (td_clock.rises()) dut.td_data_i = byte(td_clock.number() + ahead);
            dut.eval();
        }
        dut.onchip_take_i = dut.sdram_take_i = clocks % every >= busy_for;
        dut.eval();
        // What the next edge takes.
        if (!dut.onchip_take_i) return;
        EXPECT_FALSE(dut.onchip_req_o && dut.sdram_req_o);
        if (dut.onchip_req_o) note(regmap::ONCHIP_BASE);
        if (dut.sdram_req_o) note(regmap::SDRAM_BASE);
    }

    // Moves the chip to this line, counted from 1, so that a test need not wait.
    void to_line(unsigned line) {
        const std::uint64_t frame = std::uint64_t{525} * sim::Adv7180::LINE_CLOCKS;
        const std::uint64_t now = td_clock.number() + ahead;
        ahead += 2 * frame + (line - 1) * sim::Adv7180::LINE_CLOCKS - now % frame;
    }
    void lines(unsigned count) { clock(std::uint64_t{count} * LINE_CLOCKS); }
    // A whole field, the first or the second, from before its first line until after its last.
    void field(unsigned number) {
        to_line(number == 1 ? 3 : 265);
        lines(263);
    }

    void edges(bool on) {
        std::swap(dut.we_i, dut.edges_we_i);
        dut.edges_we_i = 1;
        dut.waddr_i = regmap::EDGE_DETECTION_CONTROL & 0xfff;
        dut.wdata_i = on;
        dut.wstrb_i = 0xf;
        clock();
        dut.edges_we_i = 0;
        clock();
    }
    std::uint32_t read_edges(std::uint32_t address) {
        dut.edges_re_i = 1;
        dut.raddr_i = address & 0xfff;
        clock();
        dut.edges_re_i = 0;
        return dut.rdata_o;
    }

    unsigned pixel(unsigned x, unsigned y, std::uint32_t base = regmap::ONCHIP_BASE) {
        const auto word = written.find(base + (y << 10) + (x / 2 << 2));
        if (word == written.end()) return ~0u;
        return word->second >> x % 2 * 16 & 0xffff;
    }

private:
    std::uint8_t byte(std::uint64_t rise) {
        const std::uint64_t place = rise % sim::Adv7180::LINE_CLOCKS;
        const bool code = place == damaged_byte || place == 272 + damaged_byte;
        return static_cast<std::uint8_t>(chip.data(rise) ^ (code ? damage : 0));
    }
    void note(std::uint32_t base) {
        const std::uint32_t mask = base == regmap::ONCHIP_BASE ? 0xffff : 0xffffff;
        written[base + ((dut.index_o & mask) << 2)] = dut.wdata_o;
        ++writes;
    }
};

}  // namespace tb
