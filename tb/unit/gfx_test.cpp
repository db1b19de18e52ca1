// gfx_test.cpp - the canvas against the definition of a line, and the letters.
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gfx/font.h"

namespace {

using namespace gfx;

using Wide = __int128;
constexpr Colour RED = rgb(255, 0, 0);

std::set<std::pair<int, int>> painted(const Canvas& canvas) {
    std::set<std::pair<int, int>> pixels;
    for (int y = 0; y < Canvas::HEIGHT; ++y)
        for (int x = 0; x < Canvas::WIDTH; ++x)
            if (canvas.row(y)[x] != BLACK) pixels.insert({x, y});
    return pixels;
}

struct Ends {
    int x0, y0, x1, y1;
};

// By definition: in each column (row, if steep) between the ends the pixel nearest to the exact
// line.
void expect_nearest_pixels(const Ends& ends) {
    Canvas canvas;
    canvas.line(ends.x0, ends.y0, ends.x1, ends.y1, RED);
    auto [x0, y0, x1, y1] = ends;
    const auto length = [](int a, int b) { return a > b ? Wide{a} - b : Wide{b} - a; };
    const bool steep = length(y0, y1) > length(x0, x1);
    if (steep) std::swap(x0, y0), std::swap(x1, y1);
    if (x0 > x1) std::swap(x0, x1), std::swap(y0, y1);
    const Wide run = Wide{x1} - x0, rise = Wide{y1} - y0;
    for (int x = 0; x < (steep ? Canvas::HEIGHT : Canvas::WIDTH); ++x) {
        int lit = 0, must = 0;
        for (int y = 0; y < (steep ? Canvas::WIDTH : Canvas::HEIGHT); ++y) {
            const bool on = (steep ? canvas.row(x)[y] : canvas.row(y)[x]) == RED;
            const Wide off = (Wide{y} - y0) * run - (Wide{x} - x0) * rise;  // distance * run
            const bool between = x >= x0 && x <= x1;
            const bool may = between && 2 * off <= run && 2 * off >= -run;
            ASSERT_TRUE(may || !on) << x << " " << y;
            lit += on;
            must += between && (run == 0 ? y == y0 : 2 * off < run && 2 * off > -run);
        }
        ASSERT_LE(lit, 1) << "column " << x;
        ASSERT_GE(lit, must) << "column " << x;
    }
}

TEST(Colour, PacksRed5Green6Blue5) {
    EXPECT_EQ(rgb(255, 0, 0), 0xf800);
    EXPECT_EQ(rgb(0, 255, 0), 0x07e0);
    EXPECT_EQ(rgb(0, 0, 255), 0x001f);
    EXPECT_EQ(rgb(255, 255, 255), WHITE);
    EXPECT_EQ(rgb(8, 4, 8), 0x0821);
    EXPECT_EQ(rgb(7, 3, 7), BLACK);
}

TEST(Line, IsTheNearestPixelInEachColumn) {
    std::mt19937 random{1};
    std::uniform_int_distribution<int> x{-100, 420}, y{-100, 340};
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        expect_nearest_pixels({x(random), y(random), x(random), y(random)});
    }
}

TEST(Line, IsExactForAnyCoordinatesAnIntCanHold) {
    const Ends far[] = {{INT_MIN, INT_MIN, INT_MAX, INT_MAX},
                        {INT_MIN, INT_MAX, INT_MAX, INT_MIN},
                        {INT_MIN, 120, INT_MAX, 121},
                        {160, INT_MAX, 161, INT_MIN},
                        {INT_MIN, 0, INT_MAX, 239},
                        {0, INT_MIN, 319, INT_MAX},
                        {INT_MAX, INT_MAX, INT_MAX, INT_MAX},
                        {INT_MIN, 5, INT_MIN, 5},
                        {INT_MAX, 0, INT_MAX, 239},
                        {7, 9, INT_MAX, INT_MIN},
                        {0, 0, 0, 0},
                        {319, 239, 319, 239},
                        {INT_MIN, -200000000, 1000, 500}};
    for (const Ends& ends : far) expect_nearest_pixels(ends);
    std::mt19937 random{2};
    std::uniform_int_distribution<int> any{INT_MIN, INT_MAX}, inside{0, 239};
    for (int i = 0; i < 40; ++i)
        expect_nearest_pixels({any(random), any(random), inside(random), inside(random)});
}

TEST(Line, ClippedIsItsPartInside) {
    std::mt19937 random{3};
    std::uniform_int_distribution<int> x{0, 319}, y{0, 239}, shift{-200, 200};
    for (int i = 0; i < 100; ++i) {
        const Ends ends{x(random), y(random), x(random), y(random)};
        const int right = shift(random), down = shift(random);
        Canvas whole, clipped;
        whole.line(ends.x0, ends.y0, ends.x1, ends.y1, RED);
        clipped.line(ends.x0 + right, ends.y0 + down, ends.x1 + right, ends.y1 + down, RED);
        std::set<std::pair<int, int>> inside;
        for (const auto& [px, py] : painted(whole))
            if (px + right >= 0 && px + right < 320 && py + down >= 0 && py + down < 240)
                inside.insert({px + right, py + down});
        ASSERT_EQ(painted(clipped), inside);
    }
}

TEST(Line, IsTheSameFromEitherEnd) {
    for (int x = -7; x <= 7; ++x) {
        for (int y = -7; y <= 7; ++y) {
            Canvas there, back;
            there.line(50, 50, 50 + x, 50 + y, RED);
            back.line(50 + x, 50 + y, 50, 50, RED);
            ASSERT_EQ(painted(there), painted(back)) << x << " " << y;
            ASSERT_TRUE(painted(there).count({50 + x, 50 + y})) << x << " " << y;
        }
    }
}

TEST(Canvas, FillsARectangleAndOutlinesOne) {
    Canvas filled, outlined;
    filled.fill(10, 20, 4, 3, RED);
    outlined.rect(10, 20, 4, 3, RED);
    EXPECT_EQ(painted(filled).size(), 12u);
    auto hole = painted(filled);
    hole.erase({11, 21});
    hole.erase({12, 21});
    EXPECT_EQ(painted(outlined), hole);
}

TEST(Canvas, CutsRectanglesAtItsBorders) {
    Canvas canvas;
    canvas.fill(INT_MIN, INT_MIN, INT_MAX, INT_MAX, RED);
    canvas.fill(INT_MAX, INT_MAX, INT_MAX, INT_MAX, RED);
    canvas.fill(5, 5, 0, 9, RED);
    canvas.fill(5, 5, 9, -3, RED);
    canvas.fill(400, 5, -300, 9, RED);
    canvas.rect(5, 5, INT_MIN, 4, RED);
    canvas.rect(INT_MAX, 0, INT_MAX, 240, RED);
    canvas.pixel(-1, 0, RED);
    canvas.pixel(0, 240, RED);
    canvas.pixel(INT_MAX, INT_MIN, RED);
    EXPECT_TRUE(painted(canvas).empty());
    canvas.rect(-1, -1, 322, 242, RED);
    EXPECT_TRUE(painted(canvas).empty()) << "an outline just outside";
    canvas.fill(100, 200, INT_MAX, INT_MAX, RED);
    EXPECT_EQ(painted(canvas).size(), 220u * 40u);
    canvas.fill(-1000, -1000, INT_MAX, INT_MAX, RED);
    EXPECT_EQ(painted(canvas).size(), 320u * 240u);
}

TEST(Canvas, IsBlackAfterClear) {
    Canvas canvas;
    canvas.line(-50, -80, 400, 300, RED);
    canvas.fill(100, 200, 50, 100, WHITE);
    text(canvas, 200, 5, "gone", RED);
    canvas.clear();
    EXPECT_TRUE(painted(canvas).empty());
}

std::set<std::pair<int, int>> glyph(char letter) {
    Canvas canvas;
    text(canvas, 0, 0, {&letter, 1}, RED);
    return painted(canvas);
}

TEST(Text, HasItsOwnGlyphForEveryPrintableCharacter) {
    std::set<std::set<std::pair<int, int>>> glyphs;
    for (char letter = ' '; letter <= '~'; ++letter) {
        const auto pixels = glyph(letter);
        EXPECT_EQ(pixels.empty(), letter == ' ') << letter;
        EXPECT_TRUE(glyphs.insert(pixels).second) << letter << " looks like another";
        for (const auto& [x, y] : pixels)
            EXPECT_TRUE(x < CELL_WIDTH - 1 && y < CELL_HEIGHT - 1) << letter << " leaves its cell";
    }
}

TEST(Text, DrawsAnF) {
    const char* const f[] = {"#####", "#", "#", "####", "#", "#", "#"};
    std::set<std::pair<int, int>> expected;
    for (int y = 0; y < 7; ++y)
        for (int x = 0; f[y][x]; ++x) expected.insert({x, y});
    EXPECT_EQ(glyph('F'), expected);
}

TEST(Text, ShowsAQuestionMarkForWhatItCannotPrint) {
    for (const int code : {0, 10, 31, 127, 128, 255})
        EXPECT_EQ(glyph(static_cast<char>(code)), glyph('?')) << code;
}

TEST(Text, GoesOnACellToTheRight) {
    Canvas one, two;
    text(one, 10, 10, "AB", RED);
    text(two, 10, 10, "A", RED);
    text(two, 10 + text_width("A"), 10, "B", RED);
    EXPECT_EQ(painted(one), painted(two));
}

TEST(Text, IsCutAtTheBordersOfTheCanvas) {
    Canvas canvas;
    text(canvas, INT_MIN, 0, "far left", RED);
    text(canvas, 0, INT_MIN, "far up", RED);
    text(canvas, 0, INT_MAX, "far down", RED);
    text(canvas, INT_MAX, 0, "far right", RED);
    EXPECT_TRUE(painted(canvas).empty());
    text(canvas, 317, 0, "HHH", RED);
    EXPECT_EQ(painted(canvas).size(), 7u + 1 + 1) << "the left three columns of one H";
    canvas.clear();
    text(canvas, 0, 0, std::string(10000, 'H'), RED);
    EXPECT_EQ(canvas.row(0)[318], RED) << "the left leg of the 54th letter";
    EXPECT_EQ(canvas.row(0)[319], BLACK);
}

}  // namespace
