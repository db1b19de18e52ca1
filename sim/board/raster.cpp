#include "sim/board/raster.h"

#include <algorithm>
#include <cmath>

#include "sim/pins/pins.h"

namespace sim {

Raster::Raster(const Placement& place)
    : place_{place},
      left_{place.by_blank ? 0 : static_cast<std::uint64_t>(place.left)},
      left_fraction_{place.by_blank ? 0 : place.left - std::floor(place.left)},
      phase_{place.line_samples},
      samples_(place.width),
      pixels_(std::size_t{place.width} * place.height) {
    if (place.samples_per_pixel == 1) return;
    samples_.resize(static_cast<std::size_t>(place.width * place.samples_per_pixel) + 2);
    row_.resize(place.width);
}

void Raster::run(const std::uint32_t* pins, unsigned count, bool blank_n) {
    const std::uint64_t sample = now_ - line_begin_;
    if (place_.by_blank) {
        if (blank_n) {
            if (stored_ == 0 && !row_.empty()) early_ = phase_.edge(now_);
            store(pins, count, false);
        }
    } else {
        const auto before = static_cast<unsigned>(
            left_ > sample ? std::min<std::uint64_t>(left_ - sample, count) : 0);
        if (blank_n && line_known_ && !colour_in_porch_)
            colour_in_porch_ = std::any_of(pins, pins + before,
                                           [](std::uint32_t pin) { return pin & video::RGB; });
        store(pins + before, count - before, place_.blank_is_black && !blank_n);
    }
    now_ += count;
}

void Raster::store(const std::uint32_t* pins, unsigned count, bool black) {
    count = std::min(count, static_cast<unsigned>(samples_.size()) - stored_);
    std::uint32_t* to = samples_.data() + stored_;
    for (unsigned i = 0; i < count; ++i) to[i] = black ? 0 : pins[i] & video::RGB;
    stored_ += count;
}

void Raster::begin_line() {
    if (line_known_) end_line();
    line_known_ = true;
    line_begin_ = now_;
    if (!place_.by_blank && !row_.empty()) early_ = phase_.edge(now_);
    stored_ = 0;
}

void Raster::end_line() {
    if (place_.by_blank ? stored_ > 0 : line_ >= place_.top) {
        if (rows_ < place_.height) {
            std::fill(samples_.begin() + stored_, samples_.end(), 0u);
            const std::uint32_t* const from = row();
            std::uint32_t* const to = pixels_.data() + std::size_t{rows_} * place_.width;
            if (!std::equal(from, from + place_.width, to)) {
                std::copy(from, from + place_.width, to);
                is_new_ = true;
            }
        }
        ++rows_;
    }
    ++line_;
}

const std::uint32_t* Raster::row() {
    if (row_.empty()) return samples_.data();
    for (unsigned x = 0; x < place_.width; ++x) {
        const double middle = left_fraction_ - early_ + (x + 0.5) * place_.samples_per_pixel;
        row_[x] = samples_[static_cast<std::size_t>(middle + 0.5)];
    }
    return row_.data();
}

bool Raster::end_frame() {
    if (!in_step_ || rows_ == 0) return false;
    if (rows_ < place_.height)
        std::fill(pixels_.begin() + std::size_t{rows_} * place_.width, pixels_.end(), 0u);
    return true;
}

void Raster::begin_frame() {
    in_step_ = line_known_;
    line_ = 0;
    rows_ = 0;
}

}  // namespace sim
