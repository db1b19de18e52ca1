// dies.c - an exception whose handler never returns.
//
// DIES_BY 1: undefined instruction, 2: prefetch abort, 3: data abort, all into a vector that spins
// (start.S); 4: data abort into a handler with an endless loop.
#include "registers.h"

#if DIES_BY == 4
void on_data_abort(void) {
    for (;;) LEDR_DATA = LEDR_DATA + 1;
}
#endif

int main(void) {
    for (const char* c = "ready\n"; *c; ++c) REGISTER(0xFFC02000) = (uint32_t)*c;
#if DIES_BY == 1
    __asm volatile("udf #0");
#elif DIES_BY == 2
    ((void (*)(void))0x80000000)();
#else
    (void)REGISTER(0xFFC00000);
#endif
    LEDR_DATA = 0x3FF;
    return 0;
}
