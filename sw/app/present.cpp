#include "app/present.h"

#include <cstring>

namespace app {

void Presenter::present(const gfx::Canvas& canvas, hal::Display& display) {
    auto& picture = shown_[display.back()];
    for (unsigned y = 0; y < gfx::Canvas::HEIGHT; ++y) {
        Row now;
        std::memcpy(now.data(), canvas.row(static_cast<int>(y)), sizeof now);
        if (std::memcmp(now.data(), picture[y].data(), sizeof now) != 0)
            send_difference(y, now, picture[y], display);
    }
}

void Presenter::send_difference(unsigned y, const Row& now, Row& shown, hal::Display& display) {
    for (unsigned x = 0; x < WORDS;) {
        if (now[x] == shown[x]) {
            ++x;
            continue;
        }
        const unsigned first = x;
        unsigned end = ++x;  // behind the last word that differs
        for (; x < WORDS && x < end + JOIN; ++x)
            if (now[x] != shown[x]) end = x + 1;
        display.write_row(y, first, now.data() + first, end - first);
    }
    shown = now;
}

}  // namespace app
