#include "sim/board/led_matrix.h"

#include <algorithm>
#include <utility>

namespace sim {

namespace {

constexpr double FULL = 1.0 / 3, LEAST = 1.0 / 8;  // of the brightest
constexpr double DARK = 0.005;

HeaderMasks both(const HeaderPinList& some, const HeaderPinList& others) {
    HeaderMasks mask = mask_of(some);
    const HeaderMasks more = mask_of(others);
    for (unsigned n = 0; n < HEADERS; ++n) mask[n] |= more[n];
    return mask;
}

}  // namespace

LedMatrix::LedMatrix(Wiring wiring)
    : wiring_{std::move(wiring)},
      wires_{both(wiring_.rows, wiring_.columns)},
      width_{wiring_.columns.empty() ? 1 : static_cast<unsigned>(wiring_.columns.size())},
      lit_(wiring_.row_count()),
      lamps_{wiring_.row_count() * width_} {}

std::uint64_t LedMatrix::shown_rows(const HeaderMasks& levels) const {
    if (!wiring_.coded_rows)
        return gathered(levels, wiring_.rows) ^ (wiring_.row_lit ? 0 : ~std::uint64_t{0});
    unsigned number = 0;
    for (const HeaderPin pin : wiring_.rows) number = number << 1 | unsigned{is_high(levels, pin)};
    return std::uint64_t{1} << number;
}

void LedMatrix::look(const HeaderMasks& levels, std::uint64_t time_ps) {
    HeaderMasks now_here = levels;
    for (unsigned n = 0; n < HEADERS; ++n) now_here[n] &= wires_[n];
    if (looked_ && now_here == levels_here_) return;
    looked_ = true;
    levels_here_ = now_here;
    const std::uint64_t rows = shown_rows(levels);
    const std::uint64_t columns =
        wiring_.columns.empty() ? 1
                                : gathered(levels, wiring_.columns) ^
                                      (wiring_.column_lit ? 0 : (std::uint64_t{1} << width_) - 1);
    lamps_.pass(time_ps);
    for (unsigned row = 0; row < lit_.size(); ++row) {
        const std::uint64_t now = rows >> row & 1 ? columns : 0;
        for (std::uint64_t moved = now ^ lit_[row]; moved; moved &= moved - 1) {
            const auto column = static_cast<unsigned>(__builtin_ctzll(moved));
            lamps_.light(row * width_ + column, now >> column & 1);
        }
        lit_[row] = now;
    }
}

bool LedMatrix::lit(std::uint64_t time_ps) {
    lamps_.pass(time_ps);
    return lamps_.seen(0);
}

std::vector<std::string> LedMatrix::rows(std::uint64_t time_ps) {
    lamps_.pass(time_ps);
    const auto count = static_cast<unsigned>(lit_.size()) * width_;
    double brightest = DARK;
    for (unsigned n = 0; n < count; ++n) brightest = std::max(brightest, lamps_.brightness(n));
    std::vector<std::string> rows(lit_.size());
    for (unsigned n = 0; n < count; ++n) {
        const double share = lamps_.brightness(n) / brightest;
        rows[n / width_] += share >= FULL ? '#' : share >= LEAST ? '+' : '.';
    }
    return rows;
}

}  // namespace sim
