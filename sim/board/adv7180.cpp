#include "sim/board/adv7180.h"

#include <cmath>
#include <utility>

namespace sim {

namespace {

constexpr unsigned ACTIVE = 276;  // the first byte of the pixels
constexpr std::uint8_t BLACK = 0x10, GREY = 0x80;
constexpr std::uint8_t DEF_Y = 0x0C, DEF_C = 0x0D;
constexpr unsigned DEF_VAL_EN = 1, DEF_VAL_AUTO_EN = 2;  // of DEF_Y

// Lines of a frame, counted from 1 as the standard does.
bool second_field(unsigned line) { return line < 4 || line >= 266; }
bool blanking(unsigned line) { return line < 10 || (line >= 264 && line < 273); }

std::uint8_t code(bool f, bool v, bool h) {
    return static_cast<std::uint8_t>(0x80 | f << 6 | v << 5 | h << 4 | (v ^ h) << 3 | (f ^ h) << 2 |
                                     (f ^ v) << 1 | (f ^ v ^ h));
}

std::uint8_t rounded(double level) { return static_cast<std::uint8_t>(std::lround(level)); }

}  // namespace

void Adv7180::show(std::shared_ptr<const Image> picture) {
    picture_ = std::move(picture);
    registers_.signal(picture_ != nullptr);
}

bool Adv7180::byte(unsigned number, std::uint8_t value) {
    if (number == 0) return value >> 1 == ADDRESS && speed_.answers(control_.shortest_ps());
    if (number == 1)
        registers_.select(value);
    else
        registers_.write(value);
    return true;
}

void Adv7180::make_line(std::uint64_t number) {
    line_ = number;
    const unsigned line = static_cast<unsigned>(number % LINES) + 1;
    const bool f = second_field(line), v = blanking(line);
    for (unsigned i = 0; i < LINE_CLOCKS; i += 2) bytes_[i] = GREY, bytes_[i + 1] = BLACK;
    for (const bool h : {true, false}) {
        std::uint8_t* at = &bytes_[h ? 0 : ACTIVE - 4];
        at[0] = 0xFF, at[1] = at[2] = 0, at[3] = code(f, v, h);
    }
    if (line >= 22 && line < 262) make_row(2 * (line - 22));
    if (line >= 285 && line < 525) make_row(2 * (line - 285) + 1);
}

void Adv7180::make_row(unsigned row) {
    std::uint8_t* out = &bytes_[ACTIVE];
    const unsigned def_y = registers_.main(DEF_Y), def_c = registers_.main(DEF_C);
    const bool forced = def_y & DEF_VAL_EN;
    for (unsigned x = 0; x < WIDTH; ++x, out += 2) {
        std::uint8_t y = BLACK, cb = GREY, cr = GREY;
        if (forced || (!picture_ && def_y & DEF_VAL_AUTO_EN)) {
            y = static_cast<std::uint8_t>(def_y & 0xfc);
            cb = static_cast<std::uint8_t>(def_c << 4);
            cr = static_cast<std::uint8_t>(def_c & 0xf0);
        } else if (picture_) {
            const std::size_t from =
                std::size_t{row * picture_->height / HEIGHT} * picture_->width +
                x * picture_->width / WIDTH;
            const std::uint8_t* rgb = &picture_->rgb[3 * from];
            const double r = rgb[0] / 255.0, g = rgb[1] / 255.0, b = rgb[2] / 255.0;
            const double light = 0.299 * r + 0.587 * g + 0.114 * b;
            y = rounded(16 + 219 * light);
            cb = rounded(128 + 224 * (b - light) / 1.772);
            cr = rounded(128 + 224 * (r - light) / 1.402);
        }
        if (x % 2 == 0) out[0] = cb, out[2] = cr;
        out[1] = y;
    }
}

}  // namespace sim
