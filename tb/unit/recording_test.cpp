// recording_test.cpp - sound files, written by libsndfile, read into the simulation.
#include "sim/board/recording.h"

#include <cmath>

#include <gmock/gmock.h>
#include <sndfile.h>
#include <sys/stat.h>

#include "sim/board/tone.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim;

class RecordingFile : public testing::Test {
protected:
    const TempFolder folder;

    // 32-bit values of all channels, in a file with so many bits.
    std::filesystem::path write(int channels, int rate, int format,
                                const std::vector<int>& values) {
        SF_INFO info{};
        info.channels = channels;
        info.samplerate = rate;
        info.format = format;
        const auto path = folder / "a.wav";
        SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
        sf_write_int(file, values.data(), static_cast<sf_count_t>(values.size()));
        sf_close(file);
        return path;
    }
    std::string refusal(const std::filesystem::path& path) {
        try {
            read_recording(path);
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string{error.what()}.find(path.string() + ": "), 0u);
            return error.what() + path.string().size() + 2;
        }
        return "none";
    }
};

TEST_F(RecordingFile, KeepsEveryBitOf16And24) {
    const std::vector<int> values = {0x12340000, -0x7FFF0000, 0x00010000, -0x00010000};
    for (const int format : {SF_FORMAT_PCM_16, SF_FORMAT_PCM_24}) {
        const Recording r = read_recording(write(2, 8000, SF_FORMAT_WAV | format, values));
        EXPECT_EQ(r.rate_hz, 8000);
        ASSERT_EQ(r.samples.size(), 2u);
        EXPECT_EQ(r.samples[0].left, values[0]);
        EXPECT_EQ(r.samples[0].right, values[1]);
        EXPECT_EQ(r.samples[1].left, values[2]);
        EXPECT_EQ(r.samples[1].right, values[3]);
    }
    const Recording r =
        read_recording(write(1, 8000, SF_FORMAT_WAV | SF_FORMAT_PCM_24, {0x12345600}));
    EXPECT_EQ(r.samples.at(0).left, 0x12345600);
}

TEST_F(RecordingFile, PutsOneChannelOnBothSides) {
    const Recording r =
        read_recording(write(1, 44100, SF_FORMAT_WAV | SF_FORMAT_PCM_16, {0x10000, 0x20000}));
    ASSERT_EQ(r.samples.size(), 2u);
    EXPECT_EQ(r.samples[1].left, 0x20000);
    EXPECT_EQ(r.samples[1].right, 0x20000);
}

TEST_F(RecordingFile, IsScaledFromFloats) {
    SF_INFO info{};
    info.channels = 1;
    info.samplerate = 8000;
    info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
    SNDFILE* file = sf_open((folder / "a.wav").c_str(), SFM_WRITE, &info);
    const float values[] = {0.5f, -0.25f, 1.5f};
    sf_write_float(file, values, 3);
    sf_close(file);
    const Recording r = read_recording(folder / "a.wav");
    EXPECT_EQ(r.samples.at(0).left, 0x40000000);
    EXPECT_EQ(r.samples.at(1).left, -0x20000000);
    EXPECT_EQ(r.samples.at(2).left, 0x7fffffff);
}

TEST_F(RecordingFile, IsRefusedWhenItIsNone) {
    EXPECT_EQ(refusal(folder / "b.wav"), "is not there");
    EXPECT_EQ(refusal(folder.path()), "is not a file");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(refusal(folder / "pipe"), "is not a file");
    folder.put("text", "hello");
    EXPECT_NE(refusal(folder / "text"), "none");
    EXPECT_EQ(refusal(write(3, 8000, SF_FORMAT_WAV | SF_FORMAT_PCM_16, {0, 0, 0})),
              "3 channels, not one or two");
    EXPECT_EQ(refusal(write(1, 8000, SF_FORMAT_WAV | SF_FORMAT_PCM_16, {})), "no sound");
    EXPECT_EQ(refusal(write(1, 10, SF_FORMAT_WAV | SF_FORMAT_PCM_16, std::vector<int>(3001))),
              "longer than five minutes");
}

// A sine on the left, silence on the right.
Recording sine(double hz, double rate_hz, std::size_t count) {
    Recording r{rate_hz, {}};
    for (std::size_t i = 0; i < count; ++i)
        r.samples.push_back(
            {static_cast<std::int32_t>(
                 std::lround(1e9 * std::sin(6.283185307 * hz * static_cast<double>(i) / rate_hz))),
             0});
    return r;
}

TEST(Recording, SoundsTheSameAtAnotherRate) {
    for (const double rate : {8000.0, 8138.02, 48000.0}) {
        const Recording r = at_rate(sine(440, 44100, 44100), rate);
        EXPECT_EQ(r.rate_hz, rate);
        EXPECT_NEAR(static_cast<double>(r.samples.size()), rate, 1);
        std::vector<std::int16_t> left;
        for (const StereoSample& sample : r.samples) {
            left.push_back(static_cast<std::int16_t>(sample.left >> 16));
            EXPECT_EQ(sample.right, 0);
        }
        const Tone tone = analyse_tone(left, rate);
        EXPECT_NEAR(tone.hz, 440, 2);
        EXPECT_NEAR(tone.level_dbfs, 20 * std::log10(1e9 / 0x7fffffff), 0.2);
        EXPECT_GT(tone.share, 0.99);
    }
}

TEST(Recording, LosesWhatAnotherRateCanNotCarry) {
    const Recording r = at_rate(sine(5000, 44100, 44100), 8000);
    for (std::size_t i = 200; i + 200 < r.samples.size(); ++i)
        ASSERT_LT(std::abs(r.samples[i].left), 1'000'000) << i;  // 60 dB below
}

TEST(Recording, KeepsItsSamplesAtNearlyTheSameRate) {
    const Recording before = sine(440, 8000, 100), after = at_rate(before, 8000.5);
    EXPECT_EQ(after.rate_hz, 8000.5);
    ASSERT_EQ(after.samples.size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(after.samples[i].left, before.samples[i].left);
}

}  // namespace
