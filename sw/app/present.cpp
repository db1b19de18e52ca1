#include "app/present.h"

#include <cstring>

namespace app {

void Presenter::present(const gfx::Canvas& canvas, hal::Display& display) {
    auto& picture = shown_[display.back()];
    for (unsigned y = 0; y < gfx::Canvas::HEIGHT; ++y) {
        const gfx::Colour* now = canvas.row(static_cast<int>(y));
        if (std::memcmp(now, picture[y].data(), sizeof(Row)) != 0)
            send_difference(y, now, picture[y], display);
    }
}

void Presenter::send_difference(unsigned y, const gfx::Colour* now, Row& shown,
                                hal::Display& display) {
    const auto differs = [&](unsigned x) {
        std::uint32_t word;
        std::memcpy(&word, now + 2 * x, sizeof word);
        return word != shown[x];
    };
    for (unsigned x = 0; x < WORDS;) {
        if (!differs(x)) {
            ++x;
            continue;
        }
        const unsigned first = x;
        unsigned end = ++x;  // one past the last word that differs
        for (; x < WORDS && x < end + JOIN; ++x)
            if (differs(x)) end = x + 1;
        std::memcpy(&shown[first], now + 2 * first, sizeof shown[0] * (end - first));
        display.write_row(y, first, &shown[first], end - first);
    }
}

}  // namespace app
