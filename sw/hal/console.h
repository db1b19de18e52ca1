// console.h - driver for HPS UART0 as the preloader leaves it, with FIFOs; sending only.
#pragma once

#include <cstdint>

#include "hal/mmio.h"

namespace hal {

class Console {
public:
    explicit Console(Mmio& io) : io_{io} {}

    // Sends the text, "\n" as "\r\n".
    void print(const char* text) {
        for (; *text; ++text) {
            if (*text == '\n') send('\r');
            send(*text);
        }
    }

    // Gives up if the transmitter is still full after 100,000 reads of its status.
    void send(char character) {
        for (unsigned i = 0; i < 100'000 && !(io_.read(USR) & NOT_FULL); ++i) {
        }
        io_.write(THR, static_cast<unsigned char>(character));
    }

private:
    // Cyclone V HPS TRM, UART0 at 0xFFC02000.
    static constexpr std::uint32_t THR = 0xFFC02000, USR = 0xFFC0207C, NOT_FULL = 1u << 1;

    Mmio& io_;
};

}  // namespace hal
