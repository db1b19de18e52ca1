#include "app/present.h"

#include <algorithm>
#include <cstring>

namespace app {

void Presenter::present(const gfx::Canvas& canvas, hal::Display& display) {
    auto& picture = shown_[display.back()];
    for (unsigned y = 0; y < gfx::Canvas::HEIGHT; ++y) {
        const gfx::Canvas::Span now = canvas.dirty(static_cast<int>(y));
        const int min = std::min(now.min, picture[y].min), max = std::max(now.max, picture[y].max);
        picture[y] = now;
        if (min >= max) continue;
        const auto first = static_cast<unsigned>(min) / 2,
                   end = (static_cast<unsigned>(max) + 1) / 2;
        std::uint32_t words[gfx::Canvas::WIDTH / 2];
        std::memcpy(words, canvas.row(static_cast<int>(y)) + 2 * first, 4 * (end - first));
        display.write_row(y, first, words, end - first);
    }
}

}  // namespace app
