// observations.h - what a person in front of the board has seen and heard: picture, sound, console
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "sim/board/monitor.h"
#include "sim/files/png.h"
#include "sim/report/tap.h"
#include "sim/scenario/console_text.h"

namespace sim {

// Records what a person would see and hear: the last whole picture, the sound, the console.
class Observations {
public:
    void frame(const Monitor::Frame& frame);
    void sample(std::int16_t left, std::int16_t right);
    void sample_rate(double hz);
    void console(char character);

    bool is_black() const;  // all of the picture
    Image picture() const;  // the last frame; before the first one 640 x 480, black
    std::uint64_t frames = 0, new_pictures = 0;

    std::uint64_t samples = 0;  // since power-on
    double rate_hz = 0;
    // Louder channel of the last `count` samples, oldest first; fewer if there were fewer, or the
    // rate changed in between.  At most ten seconds are kept.
    std::vector<std::int16_t> last_samples(std::uint64_t count) const;

    ConsoleText text;  // what the console printed
    TapReader tap;     // the checks in it

    std::function<void()> frame_shown, printed;  // called after each frame and character

private:
    std::vector<std::uint32_t> pixels_ = std::vector<std::uint32_t>(640 * 480);
    unsigned width_ = 640, height_ = 480;
    std::deque<std::pair<std::int16_t, std::int16_t>> recent_samples_;
};

// 0x00RRGGBB to PNG's bytes; as many pixels as the size says.
Image image_of(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height);

}  // namespace sim
