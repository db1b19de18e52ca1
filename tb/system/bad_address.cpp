// bad_address.cpp - a de1sim whose firmware reads an address that nobody answers, after 50 ms.

#include "sim/program.h"

namespace {

void bad_address(hal::Mmio& io, hal::Cpu& cpu) {
    for (int i = 0; i < 1000; ++i) cpu.idle();  // 50 us each
    io.read(0xFFC00000);                        // CAN0, which is not modelled
}

}  // namespace

int main(int argc, char** argv) { return sim::program(argc, argv, bad_address); }
