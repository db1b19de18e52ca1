// main.cpp - collide.elf: the program on the board without an operating system.
//
// SW9 up at the start: the paper's table instead, on the console.
#include "app/app.h"
#include "bench/table1.h"
#include "hal/panel.h"
#include "processor.h"

int main() {
    constexpr std::uint32_t SW9 = 1u << 9;
    bare::Registers io;
    bare::Processor cpu{io};
    if (hal::Panel{io}.switches() & SW9)
        bench::table1(cpu);
    else
        app::run(io, cpu);
}
