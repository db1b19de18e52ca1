// canvas.cpp - see canvas.h
#include "gfx/canvas.h"

#include <algorithm>
#include <utility>

namespace gfx {
namespace {

// [begin, begin + size) cut to [0, limit), without the sum overflowing.
std::pair<int, int> clip(int begin, int size, int limit) {
    const std::int64_t end = std::int64_t{begin} + size;
    return {std::max(begin, 0), static_cast<int>(std::min<std::int64_t>(end, limit))};
}

}  // namespace

void Canvas::pixel(int x, int y, Colour colour) {
    if (x >= 0 && x < WIDTH && y >= 0 && y < HEIGHT) pixels_[index(x, y)] = colour;
}

void Canvas::line(int x0, int y0, int x1, int y1, Colour colour) {
    // Step along the major axis, upwards; `rise` may go either way.  A difference of two ints needs
    // 33 bits; an unsigned product of two such differences just fits 64.
    const auto distance = [](int from, int to) {
        return static_cast<std::uint64_t>(to > from ? std::int64_t{to} - from
                                                    : std::int64_t{from} - to);
    };
    const bool steep = distance(y0, y1) > distance(x0, x1);
    if (steep) std::swap(x0, y0), std::swap(x1, y1);
    if (x0 > x1) std::swap(x0, x1), std::swap(y0, y1);
    const std::uint64_t run = distance(x0, x1), rise = distance(y0, y1);
    const int limit = steep ? HEIGHT : WIDTH;
    if (x1 < 0 || x0 >= limit) return;

    // At step i the line has risen i * rise / run, to the nearest pixel: whole + (part >= run / 2).
    const int first = std::max(x0, 0), last = std::min(x1, limit - 1);
    const std::uint64_t skipped = distance(x0, first) * rise;
    std::uint64_t whole = run ? skipped / run : 0, part = run ? skipped % run : 0;
    for (int x = first; x <= last; ++x) {
        const auto risen = static_cast<std::int64_t>(whole + (run && 2 * part >= run));
        const std::int64_t y = y1 > y0 ? y0 + risen : y0 - risen;
        if (y >= 0 && y < (steep ? WIDTH : HEIGHT)) {
            const int minor = static_cast<int>(y);
            steep ? pixel(minor, x, colour) : pixel(x, minor, colour);
        }
        part += rise;
        if (part >= run) part -= run, ++whole;
    }
}

void Canvas::rect(int x, int y, int width, int height, Colour colour) {
    if (width < 1 || height < 1) return;
    const std::int64_t right = std::int64_t{x} + width - 1, bottom = std::int64_t{y} + height - 1;
    fill(x, y, width, 1, colour);
    fill(x, y, 1, height, colour);
    if (bottom < HEIGHT) fill(x, static_cast<int>(bottom), width, 1, colour);
    if (right < WIDTH) fill(static_cast<int>(right), y, 1, height, colour);
}

void Canvas::fill(int x, int y, int width, int height, Colour colour) {
    const auto [left, right] = clip(x, width, WIDTH);
    const auto [top, bottom] = clip(y, height, HEIGHT);
    if (left >= right) return;
    for (int row = top; row < bottom; ++row)
        std::fill_n(&pixels_[index(left, row)], right - left, colour);
}

void Canvas::clear() { pixels_.fill(BLACK); }

}  // namespace gfx
