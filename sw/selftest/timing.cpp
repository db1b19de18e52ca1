// timing.cpp - the FPGA's clocks against the processor's
//
// The limits allow for a Linux that now and then runs something else for a few milliseconds.
#include <cstdio>

#include "hal/audio_out.h"
#include "hal/display.h"
#include "regmap.h"
#include "selftest/checks.h"

namespace selftest {

namespace {

// Microseconds until done() is true; LONGEST if it never is.
constexpr std::uint32_t LONGEST = 1'000'000;

template <class Done>
std::uint32_t time_until(hal::Cpu& cpu, Done done) {
    const std::uint32_t begin = cpu.micros();
    for (;;) {
        const bool over = done();
        const std::uint32_t taken = cpu.micros() - begin;
        if (over) return taken;
        if (taken >= LONGEST) return LONGEST;
        cpu.idle();
    }
}

Finding between(std::uint32_t us, std::uint32_t least, std::uint32_t most, const char* detail) {
    if (us >= least && us <= most) return met(detail);
    char text[64];
    std::snprintf(text, sizeof text, "%lu us, expected %lu to %lu", static_cast<unsigned long>(us),
                  static_cast<unsigned long>(least), static_cast<unsigned long>(most));
    return unmet(text);
}

}  // namespace

Finding interval_timer(Bench& bench) {
    constexpr std::uint32_t TICKS = 1'000'000 - 1;  // 10 ms of 100 MHz
    bench.io.write(regmap::TIMER0_CONTROL, regmap::TIMER0_CONTROL_STOP_MASK);
    bench.io.write(regmap::TIMER0_STATUS, 0);
    bench.io.write(regmap::TIMER0_PERIOD_LOW, TICKS & 0xFFFF);
    bench.io.write(regmap::TIMER0_PERIOD_HIGH, TICKS >> 16);
    bench.io.write(regmap::TIMER0_CONTROL, regmap::TIMER0_CONTROL_START_MASK);
    const std::uint32_t us = time_until(bench.cpu, [&] {
        return (bench.io.read(regmap::TIMER0_STATUS) & regmap::TIMER0_STATUS_TO_MASK) != 0;
    });
    bench.io.write(regmap::TIMER0_STATUS, 0);
    bench.io.write(regmap::TIMER0_PERIOD_LOW, regmap::TIMER0_PERIOD_LOW_RESET);
    bench.io.write(regmap::TIMER0_PERIOD_HIGH, regmap::TIMER0_PERIOD_HIGH_RESET);
    return between(us, 9'800, 15'000, "9.8 to 15 ms");
}

// Over twenty frames, from the end of one on.  The number is even, so that afterwards the same
// picture is on screen.
Finding frame_rate(Bench& bench) {
    constexpr unsigned FRAMES = 21;
    hal::Display display{bench.io};
    std::uint32_t us = 0;
    for (unsigned frame = 0; frame <= FRAMES; ++frame) {
        display.swap();
        const std::uint32_t taken = time_until(bench.cpu, [&] { return display.swapped(); });
        if (frame > 1) us += taken;
    }
    return between(us / (FRAMES - 1), 16'500, 17'100, "16.5 to 17.1 ms");
}

Finding sample_rate(Bench& bench) {
    hal::AudioOut audio{bench.io};
    const auto empty = [&] { return audio.space() == 128; };
    (void)time_until(bench.cpu, empty);
    for (unsigned i = 0; i < 128; ++i) audio.push(0, 0);
    return between(time_until(bench.cpu, empty), 15'000, 20'000, "15 to 20 ms");
}

}  // namespace selftest
