// blinker.cpp - a firmware in C++ for this machine: LEDR shows the switches.
#include "regmap.h"
#include "sim/program.h"

namespace {

void blinker(hal::Mmio& io, hal::Cpu& cpu) {
    for (;;) {
        io.write(regmap::LEDR_DATA, io.read(regmap::SW_DATA));
        cpu.idle();
    }
}

}  // namespace

int main(int argc, char** argv) { return sim::program(argc, argv, blinker); }
