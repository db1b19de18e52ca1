// globals.cpp - start.S constructs C++'s global objects before main(), by priority and in order.
#include "registers.h"

namespace {

unsigned order;  // a digit for each that was constructed

struct Counted {
    explicit Counted(unsigned digit) { order = order << 4 | digit; }
    ~Counted() { LEDR_DATA = 0; }  // a destructor makes the compiler register the object
};

Counted first{1}, second{2};
__attribute__((init_priority(200))) Counted early{3};

unsigned calls() {
    static Counted once{4};
    static unsigned count = order;
    return ++count;
}

}  // namespace

int main() {
    LEDR_DATA = order;  // 0x312
    HEX3_0_DATA = 0;
    if (order == 0x312 && calls() == 0x3125 && calls() == 0x3126) LEDR_DATA = 0x155;
    for (;;) {
    }
}
