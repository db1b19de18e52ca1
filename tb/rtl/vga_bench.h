// vga_bench.h - test fixture for vga_bench.v: the memories of pictures and characters, and the
// samples of the ADV7123's pins.
#pragma once

#include <array>
#include <deque>
#include <random>
#include <vector>

#include "Vvga_bench.h"
#include "tb/support/register_bus.h"

namespace tb {

constexpr int FRAME = 800 * 525;  // clocks

class VgaBench : public RegisterBus<Vvga_bench> {
protected:
    static constexpr std::size_t ONCHIP_WORDS = 65536, SDRAM_WORDS = 1 << 18;  // again and again
    std::vector<std::uint32_t> onchip = std::vector<std::uint32_t>(ONCHIP_WORDS),
                               sdram = std::vector<std::uint32_t>(SDRAM_WORDS);
    struct Answer {
        std::uint64_t clock;
        std::uint32_t word;
    };
    std::deque<Answer> answers;  // the SDRAM's
    std::mt19937 random{1};
    std::vector<std::uint32_t> seen;  // where BLANK_N is high
    std::array<std::uint8_t, 80 * 60> text{};
    std::uint32_t word = 0, cells = 0;
    unsigned cell_fetches = 0;

    void SetUp() override {
        dut.resampler_re_i = dut.text_we_i = dut.text_re_i = dut.clearing_i = 0;
        dut.onchip_read_i = dut.sdram_take_i = dut.sdram_valid_i = 0;
        dut.cells_any_i = 1;
        reset();
    }

    void after_clock() override {
        dut.word_i = word;  // asked for a clock ago
        dut.cells_i = cells;
        cells = 0x41414141;  // holds only for the clock after the fetch
        if (dut.cell_o) {
            ++cell_fetches;
            const unsigned row = dut.cell_index_o >> 5, column = (dut.cell_index_o & 31) * 4;
            const unsigned at = row * 80 + column;
            cells = 0x20202020;  // beside and below what the screen shows at first
            if (row < 60 && column < 80)
                cells = text[at] | text[at + 1] << 8 | text[at + 2] << 16 |
                        static_cast<std::uint32_t>(text[at + 3]) << 24;
        }
        dut.onchip_read_i = 0;
        dut.eval();
        if (dut.fetch_o) {
            word = onchip[dut.index_o];
        } else if (random() % 4 == 0) {
            dut.onchip_read_i = 1;
            word = 0xdeadbeef;
        }
        answer();
        if (dut.vga_blank_no)
            seen.push_back(
                static_cast<std::uint32_t>(dut.vga_r_o << 16 | dut.vga_g_o << 8 | dut.vga_b_o));
    }

    // The SDRAM takes a request when it has time, and answers four clocks later.
    void answer() {
        dut.sdram_valid_i = !answers.empty() && answers.front().clock == clocks;
        if (dut.sdram_valid_i) {
            dut.sdram_i = answers.front().word;
            answers.pop_front();
        }
        dut.sdram_take_i = dut.sdram_req_o && random() % 3 == 0;
        if (dut.sdram_take_i) {
            answers.push_back({clocks + 4, sdram[dut.sdram_index_o % SDRAM_WORDS]});
        }
        dut.eval();
    }

    // Runs to the end of the frame on screen and returns the 640 x 480 shown after the next one.
    std::vector<std::uint32_t> shown() {
        while (!(dut.vga_vs_no == 0)) clock();
        while (dut.vga_vs_no == 0) clock();
        seen.clear();
        clock(FRAME);
        return seen;
    }

    void write_text(std::uint32_t address, std::uint32_t value) {
        dut.text_we_i = 1;
        dut.waddr_i = address & 0xfff;
        dut.wdata_i = value;
        dut.wstrb_i = 0xf;
        clock();
        dut.text_we_i = 0;
    }
    std::uint32_t read_text(std::uint32_t address) {
        dut.text_re_i = 1;
        dut.raddr_i = address & 0xfff;
        clock();
        dut.text_re_i = 0;
        return dut.rdata_o;
    }

    // A half-word at a byte offset.
    static void poke(std::vector<std::uint32_t>& memory, std::uint32_t at, std::uint16_t colour) {
        std::uint32_t& w = memory[at / 4];
        w = at & 2 ? (w & 0x0000ffff) | static_cast<std::uint32_t>(colour) << 16
                   : (w & 0xffff0000) | colour;
    }
    // A pixel of a picture at offset 0.
    static void poke(std::vector<std::uint32_t>& memory, unsigned x, unsigned y,
                     std::uint16_t colour) {
        poke(memory, y << 10 | x << 1, colour);
    }
};

}  // namespace tb
