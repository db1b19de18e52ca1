// whole_board.h - test fixture: the whole board with a firmware of the test's choice.
//
// A test's firmware may also operate the board: it calls board->hold().
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/board/board.h"
#include "sim/chip/computer.h"

namespace tb {

// What the monitor showed: 640 x 480 of 0x00RRGGBB.
struct Picture {
    std::uint64_t number;
    bool is_new;
    std::vector<std::uint32_t> pixels;
};

class WholeBoard : public ::testing::Test, private sim::BoardObserver {
protected:
    std::unique_ptr<sim::Board> board;
    sim::Computer* computer = nullptr;  // in its chip

    std::vector<sim::PartPlan> parts;  // to be hung on the headers at power-on

    void power_on(sim::Firmware firmware) {
        constexpr std::uint64_t SEED = 1;
        sim::Computer::Settings settings;
        settings.seed = SEED;
        sim::BoardObserver& ours = *this;
        board = std::make_unique<sim::Board>(
            "board", ours, SEED, sim::Ps2Ports{},
            [&](sim::PinListener& pins, sim::ChipObserver& observer, std::uint8_t* sdram) {
                auto chip = std::make_unique<sim::Computer>("computer", pins, observer, sdram,
                                                            std::move(firmware), settings);
                computer = chip.get();
                return chip;
            },
            sim::Monitor::Strictness::STRICT, parts);
    }

    // The same for firmware that comes to an end, and runs to there.
    void run_to_end(const sim::Firmware& firmware, double limit_ms = 500) {
        bool done = false;
        power_on([&](hal::Mmio& io, hal::Cpu& cpu) {
            firmware(io, cpu);
            done = true;
        });
        const sc_core::sc_time limit{limit_ms, sc_core::SC_MS};
        while (!done && !computer->cpu.fault() && sc_core::sc_time_stamp() < limit) run_ms(1);
        ASSERT_TRUE(done) << computer->cpu.fault().value_or("still running");
    }

    void run_ms(double ms) {
        sc_core::sc_start(sc_core::sc_time{ms, sc_core::SC_MS});
        board->chip().catch_up();
    }

    // Runs until the monitor has the next whole picture, as of which the test then acts.
    Picture next_picture() {
        while (shown_.empty()) run_ms(0.25);
        Picture picture = std::move(shown_.front());
        shown_.pop_front();
        return picture;
    }

    void TearDown() override {
        ASSERT_TRUE(board);
        EXPECT_EQ(board->monitor.violations(), 0u) << board->monitor.messages().front();
        EXPECT_EQ(board->sdram_chip.violations(), 0u) << board->sdram_chip.messages().front();
        EXPECT_EQ(board->codec_chip.errors(), std::vector<std::string>{});
    }

    static void idle_ms(hal::Cpu& cpu, unsigned ms) {
        for (unsigned i = 0; i < 20 * ms; ++i) cpu.idle();  // 50 us each
    }

private:
    void frame(const sim::Monitor::Frame& f) override {
        shown_.push_back({f.number, f.is_new, f.pixels});
    }
    void sample(std::int16_t, std::int16_t) override {}
    void sample_rate(double) override {}
    void console(char, sim::SerialLine) override {}
    void log(const std::string&) override {}

    std::deque<Picture> shown_;
};

}  // namespace tb
