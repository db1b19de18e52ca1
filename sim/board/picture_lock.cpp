#include "sim/board/picture_lock.h"

#include <cmath>

#include <fmt/format.h>

namespace sim {

namespace {

using Blank = VideoSignal::Blank;

constexpr double MOST_CLOCKS_OFF = 0.03, MOST_SIZE_OFF = 1.0 / 16;
// Samples of a pixel, below which a mode is rather undersampled than another.
constexpr double LEAST_OWN_RATE = 0.75;
// What a monitor follows without knowing the mode.
constexpr double LEAST_LINE_HZ = 20e3, MOST_LINE_HZ = 150e3, LEAST_HZ = 24, MOST_HZ = 160;

bool near(double value, double standard, double most) {
    return std::abs(value - standard) <= most * standard;
}

// Nothing: VGA_CLK has a rate of its own beside the mode's, so that the mode is another one.
std::optional<double> samples_per_pixel(const VideoSignal& signal, const VideoMode& mode) {
    const double by_mode = signal.line_samples / mode.h.total();
    const auto whole = static_cast<unsigned>(std::lround(by_mode));
    const bool is_whole = whole && near(by_mode, whole, MOST_CLOCKS_OFF);
    if (is_whole && signal.even_line && signal.even_line % whole == 0) return whole;
    if (!is_whole && by_mode > LEAST_OWN_RATE && signal.even_line && signal.blank == Blank::MOVES)
        return {};
    return by_mode;
}

unsigned rounded(double value) { return static_cast<unsigned>(std::lround(value)); }

std::string polarities(const VideoSignal& signal) {
    const auto name = [](bool positive) { return positive ? "positive" : "negative"; };
    if (signal.hs_positive == signal.vs_positive)
        return fmt::format("HS and VS {}", name(signal.hs_positive));
    return fmt::format("HS {}, VS {}", name(signal.hs_positive), name(signal.vs_positive));
}

}  // namespace

PictureLock lock_on(const VideoSignal& signal, std::uint64_t sample_ps, bool has_blank) {
    const double line_ps = signal.line_samples * static_cast<double>(sample_ps);
    const double hz = 1e12 / (line_ps * signal.lines);
    const bool moves = signal.blank == Blank::MOVES;
    const VideoMode* mode =
        nearest_mode({line_ps, signal.line_samples, signal.lines, signal.hs_positive,
                      signal.vs_positive, moves ? signal.shown_lines : 0});
    const double line_hz = 1e12 / line_ps;
    const bool in_range =
        line_hz >= LEAST_LINE_HZ && line_hz <= MOST_LINE_HZ && hz >= LEAST_HZ && hz <= MOST_HZ;
    if (!mode && !(moves && in_range))
        return {{},
                fmt::format("out of range: {:.1f} kHz, {:.1f} Hz, {}, {} lines", line_hz / 1e3, hz,
                            polarities(signal), signal.lines)};

    Placement picture;
    const std::optional<double> by_mode = mode ? samples_per_pixel(signal, *mode) : std::nullopt;
    if (!by_mode) mode = nullptr;
    picture.samples_per_pixel = by_mode.value_or(1);
    picture.line_samples = signal.line_samples;
    const unsigned blank_width = rounded(signal.shown_samples / picture.samples_per_pixel);
    picture.by_blank = moves && (!mode || (near(blank_width, mode->h.shown, MOST_SIZE_OFF) &&
                                           near(signal.shown_lines, mode->v.shown, MOST_SIZE_OFF)));
    picture.width = picture.by_blank ? blank_width : mode->h.shown;
    picture.height = picture.by_blank ? signal.shown_lines : mode->v.shown;
    if (mode) {
        picture.left = mode->h.sync_to_picture() * picture.samples_per_pixel;
        picture.top = mode->v.sync_to_picture();
    }
    picture.blank_is_black = signal.blank != Blank::NEVER_HIGH;

    std::string text = fmt::format(
        "{} x {} at {:.1f} Hz, {}, {} x {} clocks", picture.width, picture.height, hz,
        polarities(signal), rounded(signal.line_samples / picture.samples_per_pixel), signal.lines);
    if (picture.samples_per_pixel != 1)
        text += fmt::format(", {:.4g} samples per pixel", picture.samples_per_pixel);
    if (signal.blank == Blank::NEVER_LOW && has_blank)
        text += ", BLANK_N ignored: never low";
    else if (signal.blank == Blank::NEVER_HIGH)
        text += ", BLANK_N ignored: never high, with which the board's ADV7123 shows black";
    else if (!picture.by_blank && has_blank)
        text += fmt::format(", BLANK_N not taken for the picture's size: high for {} x {}",
                            blank_width, signal.shown_lines);
    return {picture, text};
}

}  // namespace sim
