// keypad.h - driver for the KEYPAD block: key events as the characters on the caps.
#pragma once

#include <cstdint>

#include "hal/mmio.h"
#include "regmap.h"

namespace hal {

class Keypad {
public:
    // Takes JP1 D7-D0 for the scanner.
    explicit Keypad(Mmio& io) : io_{io} {
        io_.write(regmap::KEYPAD_CONTROL, regmap::KEYPAD_CONTROL_EN_MASK);
    }

    // The oldest press that was not yet returned ('0'-'9', 'A'-'F'), or 0.  Releases are skipped.
    char pressed() {
        for (unsigned i = 0; i < 16; ++i) {  // as many as the FIFO holds
            const std::uint32_t event = io_.read(regmap::KEYPAD_EVENT);
            if (!(event & regmap::KEYPAD_EVENT_VALID_MASK)) return 0;
            io_.write(regmap::KEYPAD_EVENT, 0);
            if (event & regmap::KEYPAD_EVENT_PRESSED_MASK)
                return CAPS[event & regmap::KEYPAD_EVENT_KEY_MASK];
        }
        return 0;
    }

private:
    static constexpr char CAPS[] = "123A456B789C0FED";  // row by row

    Mmio& io_;
};

}  // namespace hal
