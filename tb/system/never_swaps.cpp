// never_swaps.cpp - a de1sim whose firmware draws into the back picture and never shows it.

#include "hal/display.h"
#include "sim/program.h"

namespace {

void never_swaps(hal::Mmio& io, hal::Cpu& cpu) {
    hal::Display display{io};
    const std::uint32_t white[hal::Display::WIDTH / 2] = {0xffffffff};
    for (;;) {
        display.write_row(0, 0, white, hal::Display::WIDTH / 2);
        cpu.idle();
    }
}

}  // namespace

int main(int argc, char** argv) { return sim::program(argc, argv, never_swaps); }
