// gen_font.cpp - prints rtl/vga/character_font.vh from the letters of font.cpp
#include <cstdint>
#include <cstdio>
#include <string>

#include "gfx/font.h"

namespace {

constexpr int COLUMNS = 5, ROWS = 8;
constexpr int MARGIN = 1;  // blank columns on the left, of 8

// Bit 8 * row + column.
std::uint64_t strokes(char letter) {
    static gfx::Canvas canvas;
    canvas.clear();
    gfx::text(canvas, MARGIN, 0, std::string(1, letter), gfx::rgb(255, 255, 255));
    std::uint64_t bits = 0;
    for (int row = 0; row < ROWS; ++row)
        for (int column = MARGIN; column < MARGIN + COLUMNS; ++column)
            if (canvas.row(row)[column]) bits |= std::uint64_t{1} << (8 * row + column);
    return bits;
}

}  // namespace

int main() {
    std::puts(
        "// character_font.vh - generated from sw/gfx/font.cpp by `make regmap`; do not edit.");
    std::puts("// 8 x 8 pixels per letter: bit 8 * row + column; blank where there is none.\n");
    std::puts("function [63:0] letter;\n    input [6:0] code;\n    case (code)");
    for (char code = ' ' + 1; code <= '~'; ++code)
        std::printf("        7'h%02x:   letter = 64'h%016llx;\n", static_cast<unsigned>(code),
                    static_cast<unsigned long long>(strokes(code)));
    std::puts("        default: letter = 64'd0;\n    endcase\nendfunction");
}
