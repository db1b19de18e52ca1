#include "sim/scenario/observations.h"

#include <algorithm>
#include <cstdlib>

namespace sim {

namespace {

constexpr std::size_t HEARD_SECONDS = 10;

}  // namespace

void Observations::frame(const Monitor::Frame& frame) {
    frames = frame.number;
    new_pictures += frame.is_new;
    if (frame.is_new) {
        pixels_ = frame.pixels;
        width_ = frame.width;
        height_ = frame.height;
    }
    if (frame_shown) frame_shown();
}

void Observations::sample(std::int16_t left, std::int16_t right) {
    ++samples;
    recent_samples_.emplace_back(left, right);
    while (recent_samples_.size() >
           HEARD_SECONDS * static_cast<std::size_t>(std::max(rate_hz, 8000.0)))
        recent_samples_.pop_front();
}

void Observations::sample_rate(double hz) {
    if (rate_hz != 0) recent_samples_.clear();
    rate_hz = hz;
}

void Observations::console(char character) {
    text.print(character);
    tap.print(character);
    if (printed) printed();
}

bool Observations::is_black() const {
    return std::all_of(pixels_.begin(), pixels_.end(), [](std::uint32_t pixel) { return !pixel; });
}

Image Observations::picture() const { return image_of(pixels_, width_, height_); }

std::vector<std::int16_t> Observations::last_samples(std::uint64_t count) const {
    const auto n =
        static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(count, recent_samples_.size()));
    std::int64_t left = 0, right = 0;
    for (auto it = recent_samples_.end() - n; it != recent_samples_.end(); ++it) {
        left += std::abs(it->first);
        right += std::abs(it->second);
    }
    std::vector<std::int16_t> mono;
    mono.reserve(static_cast<std::size_t>(n));
    for (auto it = recent_samples_.end() - n; it != recent_samples_.end(); ++it)
        mono.push_back(left >= right ? it->first : it->second);
    return mono;
}

Image image_of(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height) {
    Image image{width, height, std::vector<std::uint8_t>(pixels.size() * 3)};
    std::uint8_t* to = image.rgb.data();
    for (const std::uint32_t pixel : pixels) {
        *to++ = static_cast<std::uint8_t>(pixel >> 16);
        *to++ = static_cast<std::uint8_t>(pixel >> 8);
        *to++ = static_cast<std::uint8_t>(pixel);
    }
    return image;
}

}  // namespace sim
