// hex_counter.cpp - KEY0 counts up and KEY1 down on HEX5-0, KEY3 clears; classes, edges polled.
#include "processor.h"
#include "registers.h"

namespace {

class Keys {
public:
    // Keys released since the last call.
    unsigned edges() {
        const uint32_t seen = KEY_EDGE;
        KEY_EDGE = seen;
        return seen;
    }
};

class Display {
public:
    void show(int value) {
        uint32_t low = 0, high = 0;
        const bool minus = value < 0;
        unsigned rest = static_cast<unsigned>(minus ? -value : value);
        for (unsigned place = 0; place < 6; ++place, rest /= 10) {
            uint32_t segments = rest || place == 0 ? DIGITS[rest % 10] : 0;
            if (place == 5 && minus) segments = MINUS;
            (place < 4 ? low : high) |= segments << place % 4 * 8;
        }
        HEX3_0_DATA = low;
        HEX5_4_DATA = high;
    }

private:
    static constexpr uint32_t MINUS = 0x40;
};

class Counter {
public:
    void step(unsigned edges) {
        if (edges & 1) ++value_;
        if (edges & 2) --value_;
        if (edges & 8) value_ = 0;
    }
    int value() const { return value_; }

private:
    int value_ = 0;
};

}  // namespace

int main() {
    Keys keys;
    Display display;
    Counter counter;
    for (;;) {
        counter.step(keys.edges());
        display.show(counter.value());
    }
}
