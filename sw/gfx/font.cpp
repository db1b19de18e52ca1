// font.cpp - see font.h
#include "gfx/font.h"

namespace gfx {
namespace {

constexpr unsigned FIRST = ' ', LAST = '~';
constexpr unsigned GLYPH_WIDTH = 5, GLYPH_HEIGHT = 8;
constexpr unsigned GLYPHS_A_ROW = 12;

// GLYPHS_A_ROW letters side by side, a column apart; each row of letters takes GLYPH_HEIGHT lines.
// clang-format off
constexpr const char* LETTERS[] = {
    // space ! " # $ % & ' ( ) * +
    "        #    # #   # #    #   ##  #  ##     #      #   #               ",
    "        #    # #   # #   #### ##  # #  #    #     #     #     #     #  ",
    "        #    # #  ##### # #      #  # #    #     #       #  # # #   #  ",
    "        #          # #   ###    #    #           #       #   ###  #####",
    "        #         #####   # #  #    # # #        #       #  # # #   #  ",
    "                   # #  ####  #  ## #  #          #     #     #     #  ",
    "        #          # #    #   #  ##  ## #          #   #               ",
    "                                                                       ",
    // , - . / 0 1 2 3 4 5 6 7
    "                      #  ###    #    ###   ###     #  #####   ##  #####",
    "                      # #   #  ##   #   # #   #   ##  #      #        #",
    "                     #  #  ##   #       #     #  # #  ####  #        # ",
    "      #####         #   # # #   #     ##    ##  #  #      # ####    #  ",
    "                   #    ##  #   #    #        # #####     # #   #   #  ",
    "  ##         ##   #     #   #   #   #     #   #    #  #   # #   #   #  ",
    "  #          ##   #      ###   ###  #####  ###     #   ###   ###    #  ",
    " #                                                                     ",
    // 8 9 : ; < = > ? @ A B C
    " ###   ###                 #         #     ###   ###   ###  ####   ### ",
    "#   # #   #  ##           #           #   #   # #   # #   # #   # #   #",
    "#   # #   #  ##    ##    #    #####    #      # # ### #   # #   # #    ",
    " ###   ####        ##   #               #    #  # # # ##### ####  #    ",
    "#   #     #  ##          #    #####    #    #   # ##  #   # #   # #    ",
    "#   #    #   ##    ##     #           #         #     #   # #   # #   #",
    " ###   ##           #      #         #      #    #### #   # ####   ### ",
    "                   #                                                   ",
    // D E F G H I J K L M N O
    "####  ##### #####  ###  #   #  ###    ### #   # #     #   # #   #  ### ",
    "#   # #     #     #   # #   #   #      #  #  #  #     ## ## ##  # #   #",
    "#   # #     #     #     #   #   #      #  # #   #     # # # ##  # #   #",
    "#   # ####  ####  # ### #####   #      #  ##    #     # # # # # # #   #",
    "#   # #     #     #   # #   #   #      #  # #   #     #   # #  ## #   #",
    "#   # #     #     #   # #   #   #   #  #  #  #  #     #   # #  ## #   #",
    "####  ##### #      #### #   #  ###   ##   #   # ##### #   # #   #  ### ",
    "                                                                       ",
    // P Q R S T U V W X Y Z [
    "####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####  ### ",
    "#   # #   # #   # #       #   #   # #   # #   # #   # #   #     #  #   ",
    "#   # #   # #   # #       #   #   # #   # #   #  # #   # #     #   #   ",
    "####  #   # ####   ###    #   #   # #   # # # #   #     #     #    #   ",
    "#     # # # # #       #   #   #   #  # #  # # #  # #    #    #     #   ",
    "#     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #      #   ",
    "#      ## # #   # ####    #    ###    #   #   # #   #   #   #####  ### ",
    "                                                                       ",
    // \ ] ^ _ ` a b c d e f g
    "#      ###    #          #          #               #         ##       ",
    "#        #   # #          #         #               #        #         ",
    " #       #  #   #          #   ###  ####   ###   ####  ###  ####   ####",
    "  #      #                        # #   # #     #   # #   #  #    #   #",
    "   #     #                     #### #   # #     #   # #####  #    #   #",
    "    #    #                    #   # #   # #   # #   # #      #     ####",
    "    #  ###        #####        #### ####   ###   ####  ###   #        #",
    "                                                                   ### ",
    // h i j k l m n o p q r s
    "#       #      #  #      ##                                            ",
    "#                 #       #                                            ",
    "####   ##     ##  #  #    #   ## #  ####   ###  ####   #### # ##   ####",
    "#   #   #      #  # #     #   # # # #   # #   # #   # #   # ##    #    ",
    "#   #   #      #  ##      #   # # # #   # #   # #   # #   # #      ### ",
    "#   #   #      #  # #     #   # # # #   # #   # #   # #   # #         #",
    "#   #  ###  #  #  #  #   ###  # # # #   #  ###  ####   #### #     #### ",
    "             ##                                 #         #            ",
    // t u v w x y z { | } ~
    " #                                           #    #    #               ",
    " #                                          #     #     #              ",
    "####  #   # #   # #   # #   # #   # #####   #     #     #    #         ",
    " #    #   # #   # # # #  # #  #   #    #   #      #      #  # # #      ",
    " #    #   # #   # # # #   #   #   #   #     #     #     #      #       ",
    " #  # #   #  # #  # # #  # #   ####  #      #     #     #              ",
    "  ##   ####   #    # #  #   #     # #####    #    #    #               ",
    "                               ###                                     ",
};
// clang-format on

bool inked(unsigned glyph, unsigned column, unsigned row) {
    const char* line = LETTERS[glyph / GLYPHS_A_ROW * GLYPH_HEIGHT + row];
    return line[glyph % GLYPHS_A_ROW * (GLYPH_WIDTH + 1) + column] == '#';
}

}  // namespace

void text(Canvas& canvas, int x, int y, std::string_view text, Colour colour) {
    for (const char letter : text) {
        if (x >= Canvas::WIDTH || y >= Canvas::HEIGHT) return;  // before a sum can overflow
        const auto code = static_cast<unsigned char>(letter);
        const unsigned glyph = (code >= FIRST && code <= LAST ? code : '?') - FIRST;
        for (unsigned row = 0; row < GLYPH_HEIGHT; ++row)
            for (unsigned column = 0; column < GLYPH_WIDTH; ++column)
                if (inked(glyph, column, row))
                    canvas.pixel(x + static_cast<int>(column), y + static_cast<int>(row), colour);
        x += CELL_WIDTH;
    }
}

}  // namespace gfx
