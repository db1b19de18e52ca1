// film.cpp - see film.h
#include "sim/page/film.h"

#include <utility>

namespace sim::page {

Image half_size(const Image& image) {
    if (image.width < 2 || image.height < 2) return image;
    Image half{image.width / 2, image.height / 2, {}};
    half.rgb.resize(std::size_t{3} * half.width * half.height);
    std::uint8_t* to = half.rgb.data();
    const std::size_t row = std::size_t{3} * image.width;
    for (unsigned y = 0; y < half.height; ++y)
        for (unsigned x = 0; x < half.width; ++x)
            for (unsigned colour = 0; colour < 3; ++colour) {
                const std::uint8_t* from = &image.rgb[2 * y * row + 6 * x + colour];
                *to++ = static_cast<std::uint8_t>(
                    (from[0] + from[3] + from[row] + from[row + 3] + 2) / 4);
            }
    return half;
}

void Film::show(double time_s, const Observations& eyes) {
    number_ = eyes.frames;
    time_s_ = time_s;
    if (shown_++ % every_ != 0) return;
    pictures_.push_back({number_, time_s, false, encode_png(half_size(eyes.picture()))});
    ++others_;
    other_bytes_ += pictures_.back().png.size();
    while (others_ > 1 && (others_ > MOST || other_bytes_ > MOST_BYTES)) thin_out();
}

std::uint64_t Film::keep(const Observations& eyes) {
    if (number_ == 0) return 0;
    const bool there = !pictures_.empty() && pictures_.back().number == number_;
    if (there && pictures_.back().of_step) return number_;
    if (of_steps_ == MOST_OF_STEPS) return 0;
    ++of_steps_;
    if (there) {
        --others_;
        other_bytes_ -= pictures_.back().png.size();
        pictures_.back().of_step = true;
    } else {
        pictures_.push_back({number_, time_s_, true, encode_png(half_size(eyes.picture()))});
    }
    return number_;
}

void Film::thin_out() {
    every_ *= 2;
    std::vector<Picture> kept;
    others_ = other_bytes_ = 0;
    bool stays = false;
    for (Picture& picture : pictures_) {
        if (!picture.of_step && !(stays = !stays)) continue;
        if (!picture.of_step) {
            ++others_;
            other_bytes_ += picture.png.size();
        }
        kept.push_back(std::move(picture));
    }
    pictures_ = std::move(kept);
}

}  // namespace sim::page
