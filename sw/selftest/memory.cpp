// memory.cpp - the two pictures: every bit of every pixel, and a drawing by its checksum
#include "gfx/canvas.h"
#include "gfx/font.h"
#include "hal/display.h"
#include "regmap.h"
#include "selftest/checks.h"

namespace selftest {

namespace {

constexpr unsigned WORDS = hal::Display::WIDTH / 2;  // a row

// Each word holds its own address, so that a write to a wrong place shows; then the complement.
Finding keeps(Bench& bench, std::uint32_t base) {
    for (const std::uint32_t flip : {0u, 0xFFFFFFFFu}) {
        for (std::uint32_t y = 0; y < hal::Display::HEIGHT; ++y) {
            std::uint32_t row[WORDS];
            for (std::uint32_t i = 0; i < WORDS; ++i) row[i] = (base + (y << 10) + 4 * i) ^ flip;
            bench.io.write_words(base + (y << 10), row, WORDS);
        }
        for (std::uint32_t y = 0; y < hal::Display::HEIGHT; ++y)
            for (std::uint32_t i = 0; i < WORDS; ++i) {
                const std::uint32_t address = base + (y << 10) + 4 * i;
                const Finding word = equal(address, bench.io.read(address), address ^ flip);
                if (!word.met) return word;
            }
    }
    return met("38400 words");
}

// FNV-1a over words instead of bytes.
struct Checksum {
    std::uint32_t value = 2166136261u;
    void add(std::uint32_t word) { value = (value ^ word) * 16777619u; }
};

void draw(gfx::Canvas& canvas) {
    canvas.clear();
    for (int i = 0; i < 8; ++i) {
        const auto level = static_cast<unsigned>(255 - 32 * i);
        canvas.fill(40 * i, 0, 40, 60, gfx::rgb(level, 0, 0));
        canvas.fill(40 * i, 60, 40, 60, gfx::rgb(0, level, 0));
        canvas.fill(40 * i, 120, 40, 60, gfx::rgb(0, 0, level));
        canvas.fill(40 * i, 180, 40, 60, gfx::rgb(level, level, level));
    }
    for (int i = 0; i < 8; ++i) {
        canvas.line(0, 0, 319, 34 * i, gfx::WHITE);
        canvas.line(319, 239, 0, 239 - 34 * i, gfx::BLACK);
    }
    canvas.rect(0, 0, 320, 240, gfx::WHITE);
    gfx::text(canvas, 124, 116, "de1sim check", gfx::WHITE);
}

// False if it does not take place within six frames.
bool swap(Bench& bench) {
    bench.io.write(regmap::PIXEL_BUFFER, 1);
    const std::uint32_t begin = bench.cpu.micros();
    while (bench.io.read(regmap::PIXEL_STATUS) & regmap::PIXEL_STATUS_S_MASK) {
        if (bench.cpu.micros() - begin > 100'000) return false;
        bench.cpu.idle();
    }
    return true;
}

}  // namespace

Finding picture0(Bench& bench) { return keeps(bench, regmap::ONCHIP_BASE); }
Finding picture1(Bench& bench) { return keeps(bench, regmap::SDRAM_BASE); }

// Drawn into picture 1, which the display then shows.
Finding drawn_picture(Bench& bench) {
    static gfx::Canvas canvas;  // 150 KB: too large for a stack
    draw(canvas);
    hal::Display display{bench.io};
    Checksum sent, kept;
    for (unsigned y = 0; y < hal::Display::HEIGHT; ++y) {
        std::uint32_t row[WORDS];
        for (unsigned i = 0; i < WORDS; ++i) {
            const gfx::Colour* pixels = canvas.row(static_cast<int>(y)) + 2 * i;
            row[i] = pixels[0] | static_cast<std::uint32_t>(pixels[1]) << 16;
            sent.add(row[i]);
        }
        display.write_row(y, 0, row, WORDS);
    }
    for (std::uint32_t y = 0; y < hal::Display::HEIGHT; ++y)
        for (std::uint32_t i = 0; i < WORDS; ++i)
            kept.add(bench.io.read(regmap::SDRAM_BASE + (y << 10) + 4 * i));
    if (!swap(bench)) return unmet("the swap never took place");
    return equal(regmap::SDRAM_BASE, kept.value, sent.value);
}

void reset_display(Bench& bench) {
    if (bench.io.read(regmap::PIXEL_BUFFER) == regmap::ONCHIP_BASE) return;
    bench.io.write(regmap::PIXEL_BACK_BUFFER, regmap::ONCHIP_BASE);
    (void)swap(bench);
}

}  // namespace selftest
