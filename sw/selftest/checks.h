// checks.h - the checks themselves; self_test.cpp lists them in the order they are made.
#pragma once

#include <cstdint>

#include "hal/cpu.h"
#include "hal/mmio.h"

namespace selftest {

struct Bench {
    hal::Mmio& io;
    hal::Cpu& cpu;
};

struct Finding {
    bool met = false;
    char detail[96] = "";
};

Finding met(const char* detail);
Finding unmet(const char* detail);
// Met if both are equal; otherwise the detail has both.
Finding equal(std::uint32_t address, std::uint32_t got, std::uint32_t expected);

// ---- registers.cpp ----
Finding system_id(Bench&);
Finding ledr(Bench&);
Finding hex3_0(Bench&);
Finding hex5_4(Bench&);
Finding key_mask(Bench&);
Finding jp2_mask(Bench&);
Finding unused_bits(Bench&);
Finding resolution(Bench&);
Finding codec(Bench&);

// ---- timing.cpp ----
Finding interval_timer(Bench&);
Finding frame_rate(Bench&);
Finding sample_rate(Bench&);

// ---- memory.cpp ----
Finding picture0(Bench&);
Finding picture1(Bench&);
Finding drawn_picture(Bench&);  // leaves it on the monitor
void reset_display(Bench&);     // picture 0, as after reset

// ---- session.cpp: asks the person ----
Finding keypad(Bench&);
Finding monitor(Bench&);
Finding lamps(Bench&);
Finding switches(Bench&);
Finding push_buttons(Bench&);

}  // namespace selftest
