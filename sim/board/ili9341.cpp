#include "sim/board/ili9341.h"

#include <utility>

namespace sim {

namespace {

enum Command : std::uint8_t {
    SWRESET = 0x01,
    SLPIN = 0x10,
    SLPOUT = 0x11,
    INVOFF = 0x20,
    INVON = 0x21,
    DISPOFF = 0x28,
    DISPON = 0x29,
    CASET = 0x2A,
    PASET = 0x2B,
    RAMWR = 0x2C,
    MADCTL = 0x36,
    COLMOD = 0x3A,
    RAMWRC = 0x3C,
    FUNCTION_CONTROL = 0xB6,
};

constexpr std::uint8_t MY = 0x80, MX = 0x40, MV = 0x20, BGR = 0x08;  // of MADCTL
constexpr std::uint8_t GS = 0x40, SS = 0x20;                         // of B6's second parameter

// 6 bits to 8; all ones stay all ones.
std::uint32_t wide(unsigned six) { return six << 2 | six >> 4; }
unsigned six_of_five(unsigned five) { return five << 1 | five >> 4; }

}  // namespace

void Ili9341::drive(const Pins& pins) {
    if (!pins.reset_n) {
        if (before_.reset_n) {
            reset();
            madctl_ = 0;
            colmod_ = 0x66;
            function_ = 0x82;
        }
    } else if (pins.wr_n && !before_.wr_n && !before_.cs_n) {  // what was there up to the rise
        if (before_.rs)
            parameter(before_.data);
        else
            command(static_cast<std::uint8_t>(before_.data));
    }
    before_ = pins;
}

void Ili9341::reset() {
    command_ = 0;
    awake_ = on_ = inverted_ = false;
    column_begin_ = page_begin_ = 0;
    column_end_ = WIDTH - 1;
    page_end_ = HEIGHT - 1;
}

void Ili9341::command(std::uint8_t command) {
    command_ = command;
    parameters_ = word_count_ = 0;
    switch (command) {
        case SWRESET: reset(); break;
        case SLPIN: awake_ = false; break;
        case SLPOUT: awake_ = true; break;
        case INVOFF: inverted_ = false; break;
        case INVON: inverted_ = true; break;
        case DISPOFF: on_ = false; break;
        case DISPON: on_ = true; break;
        case RAMWR:
            column_ = column_begin_;
            page_ = page_begin_;
            break;
        default: break;
    }
}

void Ili9341::parameter(std::uint16_t word) {
    const auto byte = static_cast<std::uint8_t>(word);
    switch (command_) {
        case CASET: window(column_begin_, column_end_, byte); break;
        case PASET: window(page_begin_, page_end_, byte); break;
        case MADCTL: madctl_ = byte; break;
        case COLMOD: colmod_ = byte; break;
        case FUNCTION_CONTROL:
            if (parameters_ == 1) function_ = byte;
            break;
        case RAMWR:
        case RAMWRC: pixel_word(word); break;
        default: break;
    }
    ++parameters_;
}

// Four bytes: begin and end, the high one first.
void Ili9341::window(unsigned& begin, unsigned& end, std::uint8_t byte) {
    if (parameters_ > 3) return;
    unsigned& value = parameters_ < 2 ? begin : end;
    value = parameters_ % 2 ? (value & 0x100) | byte : (byte & 1u) << 8 | (value & 0xff);
}

void Ili9341::pixel_word(std::uint16_t word) {
    const unsigned high = word >> 10, low = word >> 2 & 0x3f;  // 18 bits: two colours in a word
    if ((colmod_ & 7) == 5) {
        store(six_of_five(word >> 11), word >> 5 & 0x3f, six_of_five(word & 0x1f));
    } else if (word_count_ < 2) {
        words_[word_count_++] = word;
        if (word_count_ == 2) store(words_[0] >> 10, words_[0] >> 2 & 0x3f, high);
    } else {
        store(words_[1] >> 2 & 0x3f, high, low);
        word_count_ = 0;
    }
}

void Ili9341::store(unsigned red, unsigned green, unsigned blue) {
    unsigned x = column_, y = page_;
    if (madctl_ & MV) std::swap(x, y);
    if (madctl_ & MX) x = WIDTH - 1 - x;
    if (madctl_ & MY) y = HEIGHT - 1 - y;
    if (x < WIDTH && y < HEIGHT)  // what is below 0 is very large
        memory_[y * WIDTH + x] = wide(red) << 16 | wide(green) << 8 | wide(blue);
    if (++column_ <= column_end_) return;
    column_ = column_begin_;
    if (++page_ > page_end_) page_ = page_begin_;
}

std::uint32_t Ili9341::seen(unsigned x, unsigned y) const {
    if (!(function_ & SS)) x = WIDTH - 1 - x;
    if (function_ & GS) y = HEIGHT - 1 - y;
    std::uint32_t colour = memory_[y * WIDTH + x];
    if (!(madctl_ & BGR)) colour = (colour & 0xff) << 16 | (colour & 0xff00) | colour >> 16;
    return inverted_ ? colour ^ 0xffffff : colour;
}

DisplayPicture Ili9341::picture() const {
    const bool landscape = madctl_ & MV;
    DisplayPicture all{landscape ? HEIGHT : WIDTH, landscape ? WIDTH : HEIGHT, {}};
    all.pixels.resize(memory_.size());
    if (!awake_ || !on_ || !before_.backlight) return all;
    const bool upside_down = !(madctl_ & MY) != !(function_ & GS);  // in portrait
    const bool pages_to_the_right = !(madctl_ & MX) == !!(function_ & SS);
    for (unsigned y = 0; y < all.height; ++y)
        for (unsigned x = 0; x < all.width; ++x) {
            std::uint32_t& pixel = all.pixels[y * all.width + x];
            if (landscape)
                pixel = pages_to_the_right ? seen(y, HEIGHT - 1 - x) : seen(WIDTH - 1 - y, x);
            else
                pixel = upside_down ? seen(WIDTH - 1 - x, HEIGHT - 1 - y) : seen(x, y);
        }
    return all;
}

}  // namespace sim
