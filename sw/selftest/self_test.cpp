#include "selftest/self_test.h"

#include <cstdio>

#include "selftest/checks.h"

namespace selftest {

namespace {

struct Check {
    const char* name;
    Finding (*make)(Bench&);
};

constexpr Check CHECKS[] = {
    {"system ID and register map are this build's", system_id},  // first: the rest relies on it
    {"LEDR reads back", ledr},
    {"HEX3-0 read back", hex3_0},
    {"HEX5-4 read back", hex5_4},
    {"KEY's interrupt mask reads back", key_mask},
    {"JP2's interrupt mask reads back", jp2_mask},
    {"unused bits of SW and KEY read 0", unused_bits},
    {"the pictures are 320 x 240", resolution},
    {"the audio codec has acknowledged its set-up", codec},
    {"the interval timer ends a period of 10 ms", interval_timer},
    {"a frame takes 16.8 ms", frame_rate},
    {"128 samples leave in 16 ms", sample_rate},
    {"picture 0 keeps what is written", picture0},
    {"picture 1 keeps what is written", picture1},
    {"a drawn picture has its checksum", drawn_picture},
    {"the monitor shows it", monitor},
    {"the keypad tells 1, 5, 9 and D", keypad},
    {"LEDs and HEX are lit", lamps},
    {"SW0 moves", switches},
    {"KEY0 to KEY3 are pressed", push_buttons},
};

}  // namespace

Finding met(const char* detail) {
    Finding finding{true, ""};
    std::snprintf(finding.detail, sizeof finding.detail, "%s", detail);
    return finding;
}

Finding unmet(const char* detail) {
    Finding finding = met(detail);
    finding.met = false;
    return finding;
}

Finding equal(std::uint32_t address, std::uint32_t got, std::uint32_t expected) {
    Finding finding{got == expected, ""};
    const auto number = [](std::uint32_t value) { return static_cast<unsigned long>(value); };
    if (finding.met)
        std::snprintf(finding.detail, sizeof finding.detail, "0x%08lX", number(got));
    else
        std::snprintf(finding.detail, sizeof finding.detail, "0x%08lX at 0x%08lX, expected 0x%08lX",
                      number(got), number(address), number(expected));
    return finding;
}

unsigned run(hal::Mmio& io, hal::Cpu& cpu, Listener* listener) {
    Bench bench{io, cpu};
    char line[192];
    std::snprintf(line, sizeof line, "TAP version 13\n1..%u\n",
                  static_cast<unsigned>(sizeof CHECKS / sizeof *CHECKS));
    cpu.print(line);
    unsigned number = 0, failures = 0;
    for (const Check& check : CHECKS) {
        const Finding finding = check.make(bench);
        if (listener) listener->decided(check.name, finding.met, finding.detail);
        std::snprintf(line, sizeof line, "%s %u - %s: %s\n", finding.met ? "ok" : "not ok",
                      ++number, check.name, finding.detail);
        cpu.print(line);
        failures += !finding.met;
        if (failures > 0 && number == 1) {
            cpu.print("Bail out! program and bitstream are not of one build\n");
            return failures;
        }
    }
    reset_display(bench);
    cpu.print("# done\n");
    return failures;
}

}  // namespace selftest
