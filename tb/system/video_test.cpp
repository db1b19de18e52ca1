// video_test.cpp - what --video writes, as FFmpeg's own programs play it.
#include <cmath>
#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <sndfile.h>

#include "sim/files/png.h"
#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double FRAME_S = 0.0168, WAV_HZ = 8000;

// The sound from time 0 of the pictures on.
constexpr const char* IN_STEP = "-copyts -af aresample=8000:async=1:first_pts=0";

// Of the left channel at 8 kHz.
std::vector<double> sound_of(const std::filesystem::path& wav) {
    SF_INFO info{};
    SNDFILE* file = sf_open(wav.c_str(), SFM_READ, &info);
    EXPECT_TRUE(file) << wav;
    if (!file) return {};
    EXPECT_EQ(info.samplerate, WAV_HZ);
    std::vector<double> both(static_cast<std::size_t>(2 * info.frames)), left;
    sf_readf_double(file, both.data(), info.frames);
    sf_close(file);
    for (std::size_t i = 0; i < both.size(); i += 2) left.push_back(both[i]);
    return left;
}

// Where the sound is first louder than a twentieth.
std::size_t begin_of(const std::vector<double>& sound) {
    std::size_t at = 0;
    while (at < sound.size() && std::abs(sound[at]) < 0.05) ++at;
    return at;
}

// By the zeros of 50 ms from there.
double hz_of(const std::vector<double>& sound, std::size_t begin) {
    int rises = 0;
    std::size_t first = 0, last = 0;
    for (std::size_t i = begin + 1; i < begin + 400 && i < sound.size(); ++i)
        if (sound[i - 1] < 0 && sound[i] >= 0) {
            if (rises++ == 0) first = i;
            last = i;
        }
    return rises < 2 ? 0 : WAV_HZ * (rises - 1) / static_cast<double>(last - first);
}

double mean_difference(const sim::Image& a, const sim::Image& b) {
    EXPECT_EQ(a.rgb.size(), b.rgb.size());
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); ++i)
        sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
    return sum / static_cast<double>(a.rgb.size());
}

sim::Image black(const sim::Image& image) {
    return {image.width, image.height, std::vector<std::uint8_t>(image.rgb.size())};
}

sim::Image twice(const sim::Image& small) {
    sim::Image big{2 * small.width, 2 * small.height, {}};
    for (unsigned y = 0; y < big.height; ++y)
        for (unsigned x = 0; x < big.width; ++x)
            for (unsigned c = 0; c < 3; ++c)
                big.rgb.push_back(small.rgb[3 * (y / 2 * small.width + x / 2) + c]);
    return big;
}

std::vector<double> numbers(const std::string& lines) {
    std::istringstream in{lines};
    std::vector<double> all;
    for (double number; in >> number;) all.push_back(number);
    return all;
}

class Video : public tb::CommandLine, public ::testing::WithParamInterface<const char*> {
protected:
    const std::filesystem::path video = folder / ("film" + std::string{GetParam()});

    void film(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"--frames", "all", "--quiet", "--video", video};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const tb::Outcome outcome = play(SCENARIO, arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
    std::string probe(const std::string& what) const {
        return output_of("ffprobe -v error -of csv=p=0 " + what + " '" + video.string() + "'");
    }
    std::string decoded(const std::string& how, const std::string& name) const {
        const std::string to = folder / name;
        EXPECT_EQ(output_of("ffmpeg -v error -y -i '" + video.string() + "' " + how + " '" + to +
                            "' 2>&1"),
                  "");
        return to;
    }
};

TEST_P(Video, HasEachFrameAtItsTime) {
    film();
    const double simulated_s = report()["simulated_s"];
    EXPECT_THAT(numbers(probe("-show_entries format=duration")),
                ::testing::ElementsAre(::testing::DoubleNear(simulated_s, FRAME_S)));
    const auto times = numbers(probe("-select_streams v -show_entries packet=pts_time"));
    ASSERT_THAT(times, SizeIs(report()["frames"]["shown"].get<std::size_t>() + 1));
    EXPECT_EQ(times[0], 0);                 // black
    EXPECT_NEAR(times[1], 0.0171, 0.0006);  // the monitor's first frame is whole
    for (std::size_t i = 2; i < times.size(); ++i)
        EXPECT_NEAR(times[i], times[1] + static_cast<double>(i - 1) * FRAME_S, 0.0011) << i;
}

TEST_P(Video, OfLessThanTwoFramesHasThem) {
    for (const auto& [duration, pictures] : {std::pair{"10ms", 1u}, std::pair{"25ms", 2u}}) {
        const tb::Outcome outcome = play(scenario("duration: " + std::string{duration} + "\n"),
                                         {"--quiet", "--video", video});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_THAT(numbers(probe("-select_streams v -show_entries packet=pts_time")),
                    SizeIs(pictures));
    }
}

TEST_P(Video, ShowsTheMonitorsPixelsAtTwiceTheirSize) {
    film();
    const sim::Image first = sim::read_png(decoded("-frames:v 1", "black.png"));
    EXPECT_LT(mean_difference(first, black(first)), 3);
    for (const unsigned number : {10u, 40u}) {
        const std::string nth =
            "-sws_flags neighbor -vf 'select=eq(n\\," + std::to_string(number) + ")' -frames:v 1";
        const sim::Image shown = sim::read_png(decoded(nth, "shown.png"));
        EXPECT_EQ(shown.width, 1280u);
        EXPECT_EQ(shown.height, 960u);
        const sim::Image expected = twice(sim::read_png(out / frame(number)));
        EXPECT_LT(mean_difference(shown, expected), 0.5) << number;
        EXPECT_GT(mean_difference(black(expected), expected), 1) << number;
    }
}

TEST_P(Video, SoundsAsTheWavFileAndWhenItDoes) {
    film();
    const std::vector<double> heard = sound_of(decoded(IN_STEP, "heard.wav")),
                              expected = sound_of(out / "audio.wav");
    const std::size_t begin = begin_of(expected);
    ASSERT_LT(begin, expected.size());
    EXPECT_NEAR(static_cast<double>(begin_of(heard)), static_cast<double>(begin), 0.002 * WAV_HZ);
    EXPECT_NEAR(hz_of(heard, begin), 740, 15);
    EXPECT_NEAR(static_cast<double>(heard.size()), static_cast<double>(expected.size()),
                FRAME_S * WAV_HZ);
}

TEST_P(Video, IsTheSameByteForByteASecondTime) {
    film();
    const std::string first = folder.get(video.filename());
    film();
    EXPECT_GT(first.size(), 1000u);
    EXPECT_LT(first.size(), 100'000u);
    EXPECT_TRUE(folder.get(video.filename()) == first);
}

TEST_P(Video, IsAbsentWithOneLineOnAFullDisk) {
    tb::Command command;
    command.disk_full = 8'000;
    const tb::Outcome outcome =
        play(SCENARIO, {"--frames", "none", "--quiet", "--video", video}, command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
    EXPECT_THAT(outcome.err, HasSubstr(": cannot write: File too large"));
    EXPECT_FALSE(std::filesystem::exists(video));
    EXPECT_FALSE(std::filesystem::exists(video.string() + ".part"));
}

TEST_P(Video, IsRefusedBeforeTheRunWithoutFfmpeg) {
    tb::Command command;
    command.shell = "export PATH=/nonexistent";
    const tb::Outcome outcome =
        play(SCENARIO, {"--frames", "none", "--quiet", "--video", video}, command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "de1sim: --video: ffmpeg is not installed (apt install ffmpeg)\n");
    EXPECT_FALSE(std::filesystem::exists(video.string() + ".part"));
}

INSTANTIATE_TEST_SUITE_P(Of, Video, ::testing::Values(".mp4", ".webm"),
                         [](const auto& test) { return std::string{test.param}.substr(1); });

}  // namespace
