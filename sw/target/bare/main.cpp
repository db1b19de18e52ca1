// main.cpp - collide.elf: the program on the board without an operating system.
#include "app/app.h"
#include "processor.h"

int main() {
    bare::Registers io;
    bare::Processor cpu{io};
    app::run(io, cpu);
}
