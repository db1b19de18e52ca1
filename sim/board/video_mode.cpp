#include "sim/board/video_mode.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr bool NEGATIVE = false, POSITIVE = true;

// Among equals the first is taken.
constexpr VideoMode MODES[] = {
    {25'175, {640, 16, 96, 48, NEGATIVE}, {480, 10, 2, 33, NEGATIVE}},      // 60 Hz
    {31'500, {640, 24, 40, 128, NEGATIVE}, {480, 9, 3, 28, NEGATIVE}},      // 72 Hz
    {31'500, {640, 16, 64, 120, NEGATIVE}, {480, 1, 3, 16, NEGATIVE}},      // 75 Hz
    {36'000, {800, 24, 72, 128, POSITIVE}, {600, 1, 2, 22, POSITIVE}},      // 56 Hz
    {40'000, {800, 40, 128, 88, POSITIVE}, {600, 1, 4, 23, POSITIVE}},      // 60 Hz
    {50'000, {800, 56, 120, 64, POSITIVE}, {600, 37, 6, 23, POSITIVE}},     // 72 Hz
    {49'500, {800, 16, 80, 160, POSITIVE}, {600, 1, 3, 21, POSITIVE}},      // 75 Hz
    {65'000, {1024, 24, 136, 160, NEGATIVE}, {768, 3, 6, 29, NEGATIVE}},    // 60 Hz
    {75'000, {1024, 24, 136, 144, NEGATIVE}, {768, 3, 6, 29, NEGATIVE}},    // 70 Hz
    {74'250, {1280, 110, 40, 220, POSITIVE}, {720, 5, 5, 20, POSITIVE}},    // 60 Hz
    {108'000, {1280, 48, 112, 248, POSITIVE}, {1024, 1, 3, 38, POSITIVE}},  // 60 Hz
    {25'175, {640, 16, 96, 48, NEGATIVE}, {400, 12, 2, 35, POSITIVE}},      // 70 Hz
    {28'322, {720, 18, 108, 54, NEGATIVE}, {400, 12, 2, 35, POSITIVE}},     // 70 Hz
    {25'175, {640, 16, 96, 48, POSITIVE}, {350, 37, 2, 60, NEGATIVE}},      // 70 Hz
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
