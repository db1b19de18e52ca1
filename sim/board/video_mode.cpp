#include "sim/board/video_mode.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr bool NEGATIVE = false, POSITIVE = true;

// Among equals the first is taken.
constexpr VideoMode MODES[] = {
    {25'175, {640, 16, 96, 48, NEGATIVE}, {480, 10, 2, 33, NEGATIVE}},       // 60 Hz
    {31'500, {640, 24, 40, 128, NEGATIVE}, {480, 9, 3, 28, NEGATIVE}},       // 72 Hz
    {31'500, {640, 16, 64, 120, NEGATIVE}, {480, 1, 3, 16, NEGATIVE}},       // 75 Hz
    {36'000, {800, 24, 72, 128, POSITIVE}, {600, 1, 2, 22, POSITIVE}},       // 56 Hz
    {40'000, {800, 40, 128, 88, POSITIVE}, {600, 1, 4, 23, POSITIVE}},       // 60 Hz
    {50'000, {800, 56, 120, 64, POSITIVE}, {600, 37, 6, 23, POSITIVE}},      // 72 Hz
    {49'500, {800, 16, 80, 160, POSITIVE}, {600, 1, 3, 21, POSITIVE}},       // 75 Hz
    {65'000, {1024, 24, 136, 160, NEGATIVE}, {768, 3, 6, 29, NEGATIVE}},     // 60 Hz
    {75'000, {1024, 24, 136, 144, NEGATIVE}, {768, 3, 6, 29, NEGATIVE}},     // 70 Hz
    {74'250, {1280, 110, 40, 220, POSITIVE}, {720, 5, 5, 20, POSITIVE}},     // 60 Hz
    {108'000, {1280, 48, 112, 248, POSITIVE}, {1024, 1, 3, 38, POSITIVE}},   // 60 Hz
    {25'175, {640, 16, 96, 48, NEGATIVE}, {400, 12, 2, 35, POSITIVE}},       // 70 Hz
    {28'322, {720, 18, 108, 54, NEGATIVE}, {400, 12, 2, 35, POSITIVE}},      // 70 Hz
    {25'175, {640, 16, 96, 48, POSITIVE}, {350, 37, 2, 60, NEGATIVE}},       // 70 Hz
    {36'000, {640, 56, 56, 80, NEGATIVE}, {480, 1, 3, 25, NEGATIVE}},        // 85 Hz
    {33'750, {848, 16, 112, 112, POSITIVE}, {480, 6, 8, 23, POSITIVE}},      // 60 Hz
    {56'250, {800, 32, 64, 152, POSITIVE}, {600, 1, 3, 27, POSITIVE}},       // 85 Hz
    {78'750, {1024, 16, 96, 176, POSITIVE}, {768, 1, 3, 28, POSITIVE}},      // 75 Hz
    {94'500, {1024, 48, 96, 208, POSITIVE}, {768, 1, 3, 36, POSITIVE}},      // 85 Hz
    {108'000, {1152, 64, 128, 256, POSITIVE}, {864, 1, 3, 32, POSITIVE}},    // 75 Hz
    {79'500, {1280, 64, 128, 192, NEGATIVE}, {768, 3, 7, 20, POSITIVE}},     // 60 Hz
    {83'500, {1280, 72, 128, 200, NEGATIVE}, {800, 3, 6, 22, POSITIVE}},     // 60 Hz
    {108'000, {1280, 96, 112, 312, POSITIVE}, {960, 1, 3, 36, POSITIVE}},    // 60 Hz
    {135'000, {1280, 16, 144, 248, POSITIVE}, {1024, 1, 3, 38, POSITIVE}},   // 75 Hz
    {85'500, {1360, 64, 112, 256, POSITIVE}, {768, 3, 6, 18, POSITIVE}},     // 60 Hz
    {85'500, {1366, 70, 143, 213, POSITIVE}, {768, 3, 3, 24, POSITIVE}},     // 60 Hz
    {121'750, {1400, 88, 144, 232, NEGATIVE}, {1050, 3, 4, 32, POSITIVE}},   // 60 Hz
    {106'500, {1440, 80, 152, 232, NEGATIVE}, {900, 3, 6, 25, POSITIVE}},    // 60 Hz
    {108'000, {1600, 24, 80, 96, POSITIVE}, {900, 1, 3, 96, POSITIVE}},      // 60 Hz
    {162'000, {1600, 64, 192, 304, POSITIVE}, {1200, 1, 3, 46, POSITIVE}},   // 60 Hz
    {146'250, {1680, 104, 176, 280, NEGATIVE}, {1050, 3, 6, 30, POSITIVE}},  // 60 Hz
    {119'000, {1680, 48, 32, 80, POSITIVE}, {1050, 3, 6, 21, NEGATIVE}},     // 60 Hz
    {148'500, {1920, 88, 44, 148, POSITIVE}, {1080, 4, 5, 36, POSITIVE}},    // 60 Hz
    {154'000, {1920, 48, 32, 80, POSITIVE}, {1200, 3, 6, 26, NEGATIVE}},     // 60 Hz
};

constexpr double MOST_LINES_OFF = 0.05, MOST_TIME_OFF = 0.10;
// What the lesser marks of a mode weigh beside those two.
constexpr double POLARITY = 0.002, MOST_BY_LINES_SHOWN = 0.02, MOST_BY_CLOCKS = 0.02;

double off(double value, double standard) { return std::abs(value - standard) / standard; }

}  // namespace

const VideoMode* nearest_mode(const VideoTiming& timing) {
    const VideoMode* nearest = nullptr;
    double least = 0;
    for (const VideoMode& mode : MODES) {
        const double lines_off = off(timing.lines, mode.v.total());
        const double time_off = off(timing.line_ps, mode.line_ps());
        if (lines_off > MOST_LINES_OFF || time_off > MOST_TIME_OFF) continue;
        double distance = lines_off + time_off;
        distance += POLARITY * ((timing.hs_positive != mode.h.positive) +
                                (timing.vs_positive != mode.v.positive));
        if (timing.shown_lines)
            distance += std::min(off(timing.shown_lines, mode.v.shown), MOST_BY_LINES_SHOWN);
        const double per_clock = timing.line_samples / mode.h.total();
        distance += std::min(off(per_clock, std::max(1.0, std::round(per_clock))), MOST_BY_CLOCKS);
        if (!nearest || distance < least) {
            nearest = &mode;
            least = distance;
        }
    }
    return nearest;
}

}  // namespace sim
