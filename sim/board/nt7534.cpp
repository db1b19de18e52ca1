#include "sim/board/nt7534.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint8_t ALL_POWER = 7;

}  // namespace

void Nt7534::reset() {
    begin_anew();
    kept_column_ = 0;
    power_ = 0;
    takes_byte_ = on_ = all_ = inverted_ = from_right_ = false;
}

// By command E2.
void Nt7534::begin_anew() {
    column_ = page_ = first_line_ = 0;
    from_top_ = false;
}

void Nt7534::write(std::uint8_t byte, bool is_data) {
    if (!is_data) {
        if (!std::exchange(takes_byte_, false)) command(byte);
        return;
    }
    if (page_ < PAGES && column_ < COLUMNS) memory_[page_][column_] = byte;
    if (column_ < COLUMNS - 1) ++column_;
}

void Nt7534::command(std::uint8_t byte) {
    switch (byte >> 4) {
        case 0x0: column_ = (column_ & 0xF0u) | (byte & 0xFu); break;
        case 0x1: column_ = (column_ & 0xFu) | (byte & 0xFu) << 4; break;
        case 0x2:
            if (byte & 8) power_ = byte & ALL_POWER;
            break;
        case 0x4:
        case 0x5:
        case 0x6:
        case 0x7: first_line_ = byte & 0x3F; break;
        case 0xB: page_ = byte & 0xF; break;
        case 0xC: from_top_ = byte & 8; break;
        default: break;
    }
    switch (byte) {
        case 0x81:
        case 0xAD: takes_byte_ = true; break;
        case 0xA0:
        case 0xA1: from_right_ = byte & 1; break;
        case 0xA4:
        case 0xA5: all_ = byte & 1; break;
        case 0xA6:
        case 0xA7: inverted_ = byte & 1; break;
        case 0xAE:
        case 0xAF: on_ = byte & 1; break;
        case 0xE0: kept_column_ = column_; break;
        case 0xEE: column_ = kept_column_; break;
        case 0xE2: begin_anew(); break;
        default: break;
    }
}

bool Nt7534::is_on(unsigned x, unsigned y) const {
    if (!on_ || power_ != ALL_POWER) return false;
    if (all_) return true;
    const unsigned line = (first_line_ + (from_top_ ? y : HEIGHT - 1 - y)) % HEIGHT;
    const unsigned column = from_right_ ? COLUMNS - 1 - x : x;
    return (memory_[line / 8][column] >> line % 8 & 1) != inverted_;
}

DisplayPicture Nt7534::picture(bool backlight) const {
    constexpr std::uint32_t BLACK = 0, GREY = 0x808080, WHITE = 0xFFFFFF;
    DisplayPicture all{WIDTH, HEIGHT, {}};
    for (unsigned y = 0; y < HEIGHT; ++y)
        for (unsigned x = 0; x < WIDTH; ++x)
            all.pixels.push_back(is_on(x, y) ? BLACK : backlight ? WHITE : GREY);
    return all;
}

}  // namespace sim
