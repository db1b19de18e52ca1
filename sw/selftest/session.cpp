// session.cpp - what only a person can do and see: keys, switches, lamps
#include <cstdio>

#include "hal/keypad.h"
#include "hal/panel.h"
#include "regmap.h"
#include "selftest/checks.h"

namespace selftest {

namespace {

constexpr std::uint32_t PATIENCE_US = 60'000'000;

template <class Done>
bool wait_for(hal::Cpu& cpu, Done done) {
    const std::uint32_t begin = cpu.micros();
    while (!done()) {
        if (cpu.micros() - begin > PATIENCE_US) return false;
        cpu.idle();
    }
    return true;
}

std::uint32_t keys(hal::Mmio& io) { return io.read(regmap::KEY_DATA) & 0xF; }

Finding seen(Bench& bench, const char* what) {
    char line[96];
    std::snprintf(line, sizeof line, "# %s: KEY0 if so, KEY3 if not\n", what);
    bench.cpu.print(line);
    std::uint32_t answer = 0;
    if (!wait_for(bench.cpu, [&] { return ((answer = keys(bench.io)) & 0b1001) != 0; }))
        return unmet("no answer within 60 s");
    (void)wait_for(bench.cpu, [&] { return keys(bench.io) == 0; });
    return answer & 1 ? met("seen") : unmet("not seen");
}

}  // namespace

Finding keypad(Bench& bench) {
    hal::Keypad pad{bench.io};
    char line[64];
    while (pad.pressed()) {
    }
    for (const char* wanted = "159D"; *wanted; ++wanted) {
        std::snprintf(line, sizeof line, "# press %c on the keypad\n", *wanted);
        bench.cpu.print(line);
        char key = 0;
        if (!wait_for(bench.cpu, [&] { return (key = pad.pressed()) != 0; })) {
            std::snprintf(line, sizeof line, "%c was not pressed within 60 s", *wanted);
            return unmet(line);
        }
        if (key != *wanted) {
            std::snprintf(line, sizeof line, "%c, expected %c", key, *wanted);
            return unmet(line);
        }
    }
    bench.io.write(regmap::KEYPAD_CONTROL, 0);
    return met("159D");
}

Finding lamps(Bench& bench) {
    bench.io.write(regmap::LEDR_DATA, 0x3FF);
    bench.io.write(regmap::HEX3_0_DATA, 0x7F7F7F7F);
    bench.io.write(regmap::HEX5_4_DATA, 0x7F7F);
    const Finding finding = seen(bench, "all ten LEDs and six eights are lit");
    bench.io.write(regmap::LEDR_DATA, 0);
    bench.io.write(regmap::HEX3_0_DATA, 0);
    bench.io.write(regmap::HEX5_4_DATA, 0);
    return finding;
}

Finding monitor(Bench& bench) {
    return seen(bench, "the monitor shows bars in four colours and \"de1sim check\"");
}

Finding switches(Bench& bench) {
    const hal::Panel panel{bench.io};
    const std::uint32_t before = panel.switches();
    bench.cpu.print("# move SW0\n");
    if (!wait_for(bench.cpu, [&] { return panel.switches() != before; }))
        return unmet("nothing moved within 60 s");
    return equal(regmap::SW_DATA, panel.switches() ^ before, 1);
}

Finding push_buttons(Bench& bench) {
    char line[64];
    for (unsigned key = 0; key < 4; ++key) {
        std::snprintf(line, sizeof line, "# press KEY%u\n", key);
        bench.cpu.print(line);
        std::uint32_t held = 0;
        if (!wait_for(bench.cpu, [&] { return (held = keys(bench.io)) != 0; })) {
            std::snprintf(line, sizeof line, "KEY%u was not pressed within 60 s", key);
            return unmet(line);
        }
        const Finding finding = equal(regmap::KEY_DATA, held, 1u << key);
        if (!finding.met) return finding;
        (void)wait_for(bench.cpu, [&] { return keys(bench.io) == 0; });
    }
    return met("all four");
}

}  // namespace selftest
