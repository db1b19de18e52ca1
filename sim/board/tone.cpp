// tone.cpp - Hann window, zero padding, FFT, parabola through the peak
#include "sim/board/tone.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace sim {

namespace {

constexpr std::size_t MIN_SAMPLES = 32;
constexpr std::size_t PADDING = 8;  // at least so many bins of the transform per bin of the window
constexpr std::size_t STRETCHES = 8;
constexpr double MIN_SHARE = 0.5;
constexpr double MIN_LEVEL_DBFS = -60;
constexpr double FULL_SCALE_16_BITS = 32768;
const double PI = std::acos(-1.0);

// |X| of the windowed, zero-padded samples, from 0 Hz to half the rate.
std::vector<double> magnitudes(const std::vector<std::int16_t>& samples, double mean) {
    const std::size_t count = samples.size();
    std::size_t size = 1;
    while (size < PADDING * count) size *= 2;
    std::vector<double> in(size, 0.0);
    std::vector<std::complex<double>> out(size / 2 + 1);
    // FFTW_ESTIMATE keeps the arrays' content and chooses without measuring: the same plan in each
    // run.
    fftw_plan plan =
        fftw_plan_dft_r2c_1d(static_cast<int>(size), in.data(),
                             reinterpret_cast<fftw_complex*>(out.data()), FFTW_ESTIMATE);
    for (std::size_t i = 0; i < count; ++i) {
        const double phase = 2 * PI * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        in[i] = (samples[i] - mean) * 0.5 * (1 - std::cos(phase));
    }
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    std::vector<double> magnitude(out.size());
    std::transform(out.begin(), out.end(), magnitude.begin(),
                   [](const std::complex<double>& x) { return std::abs(x); });
    return magnitude;
}

double energy(const std::vector<double>& magnitude, std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += magnitude[i] * magnitude[i];
    return sum;
}

double power(const std::int16_t* begin, const std::int16_t* end) {
    const auto count = static_cast<double>(end - begin);
    const double mean = std::accumulate(begin, end, 0.0) / count;
    const double squares = std::inner_product(begin, end, begin, 0.0);
    return squares / count - mean * mean;
}

bool sounds_throughout(const std::vector<std::int16_t>& samples) {
    const double least =
        FULL_SCALE_16_BITS * FULL_SCALE_16_BITS / 2 * std::pow(10, MIN_LEVEL_DBFS / 10);
    const std::int16_t* all = samples.data();
    for (std::size_t i = 0; i < STRETCHES; ++i) {
        const std::int16_t* begin = all + i * samples.size() / STRETCHES;
        const std::int16_t* end = all + (i + 1) * samples.size() / STRETCHES;
        if (power(begin, end) < least) return false;
    }
    return true;
}

}  // namespace

Tone analyse_tone(const std::vector<std::int16_t>& samples, double rate_hz) {
    Tone tone;
    if (samples.size() < MIN_SAMPLES) return tone;
    const auto count = static_cast<double>(samples.size());
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / count;
    const auto magnitude = magnitudes(samples, mean);
    const std::size_t bins = magnitude.size();
    const auto peak = static_cast<std::size_t>(
        std::max_element(magnitude.begin() + 1, magnitude.end() - 1) - magnitude.begin());
    const double total = energy(magnitude, 0, bins);
    if (!(total > 1e-6)) return tone;

    // Around its peak the window's spectrum is nearly a parabola in decibels.
    const double before = std::log(magnitude[peak - 1] + 1e-12);
    const double at = std::log(magnitude[peak] + 1e-12);
    const double after = std::log(magnitude[peak + 1] + 1e-12);
    const double curve = before - 2 * at + after;
    const double shift = curve < 0 ? std::clamp(0.5 * (before - after) / curve, -0.5, 0.5) : 0;
    const double height = std::exp(at - 0.25 * (before - after) * shift);

    const auto size = static_cast<double>(2 * (bins - 1));
    tone.hz = (static_cast<double>(peak) + shift) * rate_hz / size;
    // A sine of amplitude a peaks at a/2 times the window's sum, which is count/2.
    tone.level_dbfs = 20 * std::log10(height / (count / 4) / FULL_SCALE_16_BITS);
    // A Hann window's main lobe reaches two of the window's bins each way.
    const auto lobe = static_cast<std::size_t>(2 * size / count) + 1;
    tone.share =
        energy(magnitude, peak - std::min(peak, lobe), std::min(bins, peak + lobe + 1)) / total;
    return tone;
}

bool is_tone(const std::vector<std::int16_t>& samples, double rate_hz, double hz, double within) {
    const Tone tone = analyse_tone(samples, rate_hz);
    return tone.share >= MIN_SHARE && std::abs(tone.hz - hz) <= within * hz &&
           sounds_throughout(samples);
}

bool is_silence(const std::vector<std::int16_t>& samples) {
    return std::all_of(samples.begin(), samples.end(), [](std::int16_t s) { return s == 0; });
}

}  // namespace sim
