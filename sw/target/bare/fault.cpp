// fault.cpp - an unexpected exception: one line on the console, then the program ends.
#include <cstdint>
#include <cstdio>

#include "hal/console.h"
#include "processor.h"

// Called from start.S.
extern "C" [[noreturn]] void fault(unsigned which, std::uint32_t pc, std::uint32_t cpsr) {
    static const char* const NAMES[] = {
        "undefined instruction", "supervisor call", "prefetch abort", "data abort", "interrupt",
        "fast interrupt"};
    std::uint32_t address = 0;
    if (which == 2) asm volatile("mrc p15, 0, %0, c6, c0, 2" : "=r"(address));  // IFAR
    if (which == 3) asm volatile("mrc p15, 0, %0, c6, c0, 0" : "=r"(address));  // DFAR
    char line[100];
    std::snprintf(line, sizeof line, "%s at pc 0x%08lX, address 0x%08lX, cpsr 0x%08lX\n",
                  NAMES[which], static_cast<unsigned long>(pc), static_cast<unsigned long>(address),
                  static_cast<unsigned long>(cpsr));
    bare::Registers io;
    hal::Console{io}.print(line);
    for (;;) asm volatile("wfi");
}
