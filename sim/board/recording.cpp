#include "sim/board/recording.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <samplerate.h>
#include <sndfile.h>

namespace sim {

namespace {

constexpr double LONGEST_S = 300;
constexpr double FULL_SCALE_32_BITS = 2147483648.0;

std::int32_t to_sample(double value) {
    using Limits = std::numeric_limits<std::int32_t>;
    return static_cast<std::int32_t>(
        std::clamp<double>(std::round(value * FULL_SCALE_32_BITS), Limits::min(), Limits::max()));
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
    const auto refuse = [&](const std::string& problem) {
        throw std::runtime_error(path.string() + ": " + problem);
    };
    std::error_code error;
    const auto kind = std::filesystem::status(path, error).type();
    if (kind == std::filesystem::file_type::not_found) refuse("is not there");
    if (kind != std::filesystem::file_type::regular) refuse("is not a file");  // a pipe would wait

    SF_INFO info{};
    const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> file{sf_open(path.c_str(), SFM_READ, &info),
                                                           sf_close};
    if (!file) refuse(sf_strerror(nullptr));
    if (info.channels > 2) refuse(fmt::format("{} channels, not one or two", info.channels));
    if (info.frames < 1) refuse("no sound");
    if (static_cast<double>(info.frames) > LONGEST_S * info.samplerate)
        refuse("longer than five minutes");

    const auto frames = static_cast<std::size_t>(info.frames);
    const auto channels = static_cast<std::size_t>(info.channels);
    std::vector<double> values(frames * channels);  // 1 is full scale; integers stay exact
    if (sf_readf_double(file.get(), values.data(), info.frames) != info.frames)
        refuse("is cut short");
    Recording recording{static_cast<double>(info.samplerate), {}};
    recording.samples.reserve(frames);
    for (std::size_t i = 0; i < frames; ++i)
        recording.samples.push_back(
            {to_sample(values[i * channels]), to_sample(values[(i + 1) * channels - 1])});
    return recording;
}

Recording at_rate(const Recording& recording, double rate_hz) {
    const double ratio = rate_hz / recording.rate_hz;
    if (std::abs(ratio - 1) < 1e-4) return {rate_hz, recording.samples};

    std::vector<float> in, out;
    for (const StereoSample& sample : recording.samples)
        for (const std::int32_t value : {sample.left, sample.right})
            in.push_back(static_cast<float>(value / FULL_SCALE_32_BITS));
    const double frames = std::ceil(static_cast<double>(recording.samples.size()) * ratio);
    out.resize(2 * static_cast<std::size_t>(frames));
    SRC_DATA data{};
    data.data_in = in.data();
    data.data_out = out.data();
    data.input_frames = static_cast<long>(recording.samples.size());
    data.output_frames = static_cast<long>(frames);
    data.src_ratio = ratio;
    if (const int failure = src_simple(&data, SRC_SINC_MEDIUM_QUALITY, 2))
        throw std::runtime_error(std::string{"cannot change the rate: "} + src_strerror(failure));

    Recording result{rate_hz, {}};
    for (long i = 0; i < data.output_frames_gen; ++i)
        result.samples.push_back({to_sample(out[2 * static_cast<std::size_t>(i)]),
                                  to_sample(out[2 * static_cast<std::size_t>(i) + 1])});
    return result;
}

}  // namespace sim
