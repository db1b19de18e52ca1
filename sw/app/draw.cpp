// draw.cpp - see draw.h
#include "app/draw.h"

#include <array>
#include <string_view>

#include "gfx/font.h"

namespace app {
namespace {

using collision::PIXEL;
using gfx::Canvas;

constexpr gfx::Colour EDGE_COLOUR = gfx::rgb(96, 96, 96), BOX_COLOUR = gfx::rgb(0, 96, 0),
                      FLASH_COLOUR = gfx::WHITE, TEXT_COLOUR = gfx::rgb(255, 230, 120);

// A line of text that is being put together; what does not fit on the screen is left out.
class Text {
public:
    Text& operator<<(std::string_view piece) {
        for (const char letter : piece)
            if (size_ < letters_.size()) letters_[size_++] = letter;
        return *this;
    }

    Text& operator<<(std::uint32_t number) {
        if (number >= 10) *this << number / 10;
        const char digit = static_cast<char>('0' + number % 10);
        return *this << std::string_view{&digit, 1};
    }

    std::string_view view() const { return {letters_.data(), size_}; }

private:
    std::array<char, Canvas::WIDTH / gfx::CELL_WIDTH> letters_{};
    unsigned size_ = 0;
};

void draw_lines(const collision::Polygon& polygon, gfx::Colour colour, Canvas& canvas) {
    for (unsigned i = 0; i < polygon.count; ++i) {
        const auto& [a, b] = polygon.lines[i];
        canvas.line(a.x / PIXEL, a.y / PIXEL, b.x / PIXEL, b.y / PIXEL, colour);
    }
}

void draw_box(const collision::Aabb& box, Canvas& canvas) {
    const int x = box.min.x / PIXEL, y = box.min.y / PIXEL;
    canvas.rect(x, y, box.max.x / PIXEL - x + 1, box.max.y / PIXEL - y + 1, BOX_COLOUR);
}

// On a black background, which covers the shapes.
void write(std::string_view text, int x, int y, Canvas& canvas) {
    canvas.fill(x - 2, y - 2, gfx::text_width(text) + 3, gfx::CELL_HEIGHT + 2, gfx::BLACK);
    gfx::text(canvas, x, y, text, TEXT_COLOUR);
}

}  // namespace

void draw(const World& world, const Overlay& overlay, Canvas& canvas) {
    std::array<bool, EDGES + World::CAPACITY> collides{};
    for (const auto& [first, second] : world.pairs) collides[first] = collides[second] = true;

    canvas.clear();
    for (unsigned i = 0; i < EDGES; ++i) draw_lines(world.polygons[i], EDGE_COLOUR, canvas);
    if (world.show_boxes)
        for (unsigned i = EDGES; i < EDGES + world.count; ++i)
            draw_box(world.polygons[i].aabb, canvas);
    for (unsigned i = EDGES; i < EDGES + world.count; ++i)
        draw_lines(world.polygons[i], collides[i] ? FLASH_COLOUR : world.bodies[i - EDGES].colour,
                   canvas);

    constexpr int MARGIN = 5;
    const std::uint32_t hundredths = overlay.tick_us / 10;
    Text status;
    status << world.count << (world.count == 1 ? " shape  " : " shapes  ");
    status << name(world.algorithm) << "  ";
    status << hundredths / 100 << "." << hundredths / 10 % 10 << hundredths % 10 << " ms";
    write(status.view(), MARGIN, MARGIN, canvas);
    if (world.paused) {
        constexpr std::string_view PAUSED = "PAUSED";
        write(PAUSED, (Canvas::WIDTH - gfx::text_width(PAUSED)) / 2,
              (Canvas::HEIGHT - gfx::CELL_HEIGHT) / 2, canvas);
    }
}

}  // namespace app
