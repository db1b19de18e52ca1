// display_test.cpp - pictures as they come and go, with the processor writing as fast as it can.
#include <algorithm>
#include <set>

#include "app/app.h"
#include "hal/display.h"
#include "sim/scenario/controls.h"
#include "tb/support/whole_board.h"

namespace {

constexpr unsigned WORDS = hal::Display::WIDTH / 2;

// Colours whose widened form is plain: all bits of a channel equal.
struct Colour {
    std::uint32_t rgb565, rgb888;
};
constexpr Colour COLOURS[] = {{0xf800, 0xff0000}, {0x07e0, 0x00ff00}, {0x001f, 0x0000ff},
                              {0xffe0, 0xffff00}, {0x07ff, 0x00ffff}, {0xf81f, 0xff00ff},
                              {0xffff, 0xffffff}};

const Colour& colour(unsigned number) { return COLOURS[number % std::size(COLOURS)]; }
std::uint32_t two_pixels(const Colour& c) { return c.rgb565 << 16 | c.rgb565; }

// Writes a whole picture, row by row, and reads a word of each row back.
void fill(hal::Mmio& io, std::uint32_t picture, const Colour& c) {
    const std::vector<std::uint32_t> row(WORDS, two_pixels(c));
    for (unsigned y = 0; y < hal::Display::HEIGHT; ++y) {
        const std::uint32_t address = picture + (y << 10);
        io.write_words(address, row.data(), WORDS);
        EXPECT_EQ(io.read(address + 4 * (y % WORDS)), two_pixels(c));
    }
}

class DisplayOnTheBoard : public tb::WholeBoard {};

TEST_F(DisplayOnTheBoard, NeverTearsAPicture) {
    power_on([](hal::Mmio& io, hal::Cpu&) {
        hal::Display display{io};
        for (unsigned number = 0;; ++number) {
            fill(io, display.back() ? regmap::SDRAM_BASE : regmap::ONCHIP_BASE, colour(number));
            display.swap();
            while (!display.swapped()) {
            }
        }
    });
    while (next_picture().pixels[0] == 0) {  // colour 0 comes next, or is being shown
    }
    for (unsigned number = 1; number < 20; ++number) {
        const tb::Picture picture = next_picture();
        EXPECT_EQ(std::set<std::uint32_t>(picture.pixels.begin(), picture.pixels.end()),
                  std::set<std::uint32_t>{colour(number).rgb888})
            << "frame " << picture.number;
    }
}

TEST_F(DisplayOnTheBoard, ShowsOldOrNewPixelsWhileTheFrontPictureIsDrawn) {
    const Colour &old_one = COLOURS[0], &new_one = COLOURS[2];
    power_on([&](hal::Mmio& io, hal::Cpu&) {
        for (;;) {
            fill(io, regmap::ONCHIP_BASE, old_one);
            fill(io, regmap::ONCHIP_BASE, new_one);
        }
    });
    next_picture();  // of before the first was filled
    unsigned mixed = 0;
    for (unsigned i = 0; i < 12; ++i) {
        const tb::Picture picture = next_picture();
        const std::set<std::uint32_t> seen(picture.pixels.begin(), picture.pixels.end());
        const std::set<std::uint32_t> allowed{old_one.rgb888, new_one.rgb888};
        EXPECT_TRUE(std::includes(allowed.begin(), allowed.end(), seen.begin(), seen.end()))
            << "frame " << picture.number;
        mixed += seen.size() == 2;
    }
    EXPECT_GT(mixed, 0u) << "nothing was drawn while it was shown";
}

TEST_F(DisplayOnTheBoard, ShowsANewPictureInEachFrameWithAHundredShapes) {
    power_on(app::run);
    run_ms(100);
    for (const char cap : std::string{"20000000000"}) {
        const auto key = static_cast<std::uint16_t>(1u << *sim::keypad_key(cap));
        board->hold(key, 0, 0);
        run_ms(40);
        board->release(key, 0, 0);
        run_ms(40);
    }
    const std::uint64_t frames = board->monitor.frames(), swaps = board->monitor.new_pictures();
    run_ms(400);
    EXPECT_GE(board->monitor.frames() - frames, 23u);
    EXPECT_EQ(board->monitor.new_pictures() - swaps, board->monitor.frames() - frames);
}

}  // namespace
