// wav_test.cpp - the sound file, as sox reads it
#include "sim/files/wav.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>

#include "sim/files/whole_file.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim;
using testing::ElementsAre;

class Wav : public testing::Test {
protected:
    // Left and right in turn, from the start of the file; sox reads WAV by itself.
    std::vector<int> samples(const std::string& name) {
        const std::string raw =
            output_of("sox " + (folder / name).string() + " -t raw -e signed -b 16 -L -");
        std::vector<int> out;
        for (std::size_t i = 0; i + 1 < raw.size(); i += 2)
            out.push_back(static_cast<std::int16_t>(static_cast<unsigned char>(raw[i]) |
                                                    static_cast<unsigned char>(raw[i + 1]) << 8));
        return out;
    }
    // "rate channels bits samples"
    std::string facts(const std::string& name) {
        const std::string file = (folder / name).string();
        std::string out;
        for (const char* option : {"-r", "-c", "-b", "-s"}) {
            out += output_of(std::string("soxi ") + option + " " + file);
            out.back() = ' ';
        }
        return out;
    }
    void silence(unsigned count) {
        for (; count > 0; --count) wav.push(0, 0);
    }

    TempFolder folder;
    WavWriter wav{folder.path()};
};

TEST_F(Wav, HoldsEverySampleAtTheNearestWholeRate) {
    wav.rate_changed(8000);
    wav.push(1, -2);
    wav.push(32767, -32768);
    wav.push(0, 0);
    EXPECT_THAT(wav.close(), ElementsAre(folder / "audio.wav"));
    EXPECT_EQ(facts("audio.wav"), "8000 2 16 3 ");
    EXPECT_THAT(samples("audio.wav"), ElementsAre(1, -2, 32767, -32768, 0, 0));
    EXPECT_EQ(folder.count(), 1u);
}

TEST_F(Wav, BeginsWithThePlainestHeaderThereIs) {
    wav.rate_changed(48000);
    wav.push(0x1234, 0x5678);
    wav.close();
    EXPECT_EQ(folder.get("audio.wav"),
              std::string("RIFF\x28\0\0\0WAVEfmt \x10\0\0\0\1\0\2\0\x80\xBB\0\0\0\xEE\2\0\4\0\x10\0"
                          "data\4\0\0\0\x34\x12\x78\x56",
                          48));
}

TEST_F(Wav, AppearsOnlyWhenItIsClosed) {
    wav.rate_changed(8000);
    for (int i = 0; i < 10000; ++i) wav.push(1, 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "audio.wav"));
    wav.close();
    EXPECT_EQ(facts("audio.wav"), "8000 2 16 10000 ");
    EXPECT_EQ(folder.count(), 1u);
}

TEST_F(Wav, KeepsWhatWasHeardBeforeTheRateWasKnown) {
    silence(2);
    wav.push(5, 6);
    silence(1);
    wav.rate_changed(8000);
    wav.push(7, 8);
    wav.close();
    EXPECT_THAT(samples("audio.wav"), ElementsAre(0, 0, 0, 0, 5, 6, 0, 0, 7, 8));
}

TEST_F(Wav, RestartsWithEqualSilenceBeforeAnySound) {
    wav.rate_changed(8000);
    silence(4000);  // half a second
    wav.rate_changed(48000);
    wav.push(9, 9);
    EXPECT_THAT(wav.close(), ElementsAre(folder / "audio.wav"));
    EXPECT_EQ(facts("audio.wav"), "48000 2 16 24001 ");
    const auto all = samples("audio.wav");
    EXPECT_EQ(std::count(all.begin(), all.end(), 0), 48000);
    EXPECT_EQ(all.back(), 9);
}

TEST_F(Wav, BeginsASecondFileWhenTheRateChanges) {
    wav.rate_changed(8000);
    wav.push(1, 1);
    wav.rate_changed(48000);
    EXPECT_TRUE(std::filesystem::exists(folder / "audio.wav"));
    silence(1);
    wav.push(2, 2);
    wav.rate_changed(8000);
    wav.push(3, 3);
    EXPECT_THAT(wav.close(),
                ElementsAre(folder / "audio.wav", folder / "audio-2.wav", folder / "audio-3.wav"));
    EXPECT_THAT(samples("audio.wav"), ElementsAre(1, 1));
    EXPECT_EQ(facts("audio-2.wav"), "48000 2 16 2 ");
    EXPECT_THAT(samples("audio-2.wav"), ElementsAre(0, 0, 2, 2));
    EXPECT_THAT(samples("audio-3.wav"), ElementsAre(3, 3));
}

TEST_F(Wav, ContinuesWhenTheRateChangesByAFraction) {
    wav.rate_changed(8000.0);
    wav.push(1, 1);
    wav.rate_changed(8000.4);
    wav.push(2, 2);
    EXPECT_EQ(wav.close().size(), 1u);
}

TEST_F(Wav, IsWrittenEvenIfAllWasSilent) {
    wav.rate_changed(8000);
    silence(8000);
    EXPECT_EQ(wav.close().size(), 1u);
    EXPECT_EQ(facts("audio.wav"), "8000 2 16 8000 ");
}

TEST_F(Wav, IsNotWrittenWithoutARateOrASample) {
    silence(5);
    EXPECT_TRUE(wav.close().empty());
    wav.rate_changed(8000);
    EXPECT_EQ(WavWriter(folder.path()).close().size(), 0u);
    EXPECT_EQ(folder.count(), 0u);
}

TEST_F(Wav, LeavesNothingWhenItIsDroppedUnclosed) {
    {
        WavWriter dropped(folder.path());
        dropped.rate_changed(8000);
        dropped.push(1, 1);
    }
    EXPECT_EQ(folder.count(), 0u);
}

TEST_F(Wav, RefusesARateThatIsNone) {
    for (const double hz : {0.0, -1.0, 0.5, 1e9, std::nan(""), HUGE_VAL})
        EXPECT_THROW(wav.rate_changed(hz), std::invalid_argument) << hz;
}

TEST_F(Wav, RefusesEndlessSoundWithoutARate) {
    const auto push_many = [&] {
        for (int i = 0; i < 70000; ++i) wav.push(1, 1);
    };
    EXPECT_THROW(push_many(), std::logic_error);
}

TEST_F(Wav, ReportsThatTheDiskIsFull) {
    std::filesystem::create_symlink("/dev/full", folder / "audio.wav.part");
    const auto play = [&] {
        wav.rate_changed(8000);
        wav.push(1, 1);
        wav.close();
    };
    try {
        play();
        FAIL();
    } catch (const IoError& error) {
        EXPECT_EQ(error.what(),
                  (folder / "audio.wav").string() + ": cannot create: No space left on device");
    }
    EXPECT_EQ(folder.count(), 0u);
}

// At each size, so that every write of header and samples is once the one that fails.
TEST_F(Wav, NeverLeavesHalfAFileWhenTheDiskFillsUp) {
    signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    for (const rlim_t bytes : {0u, 1u, 43u, 44u, 45u, 100u, 16384u, 40043u}) {
        rlimit limit = before;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
        bool refused = false;
        try {
            WavWriter full(folder.path());
            full.rate_changed(8000);
            for (int i = 0; i < 10000; ++i) full.push(1, 1);
            full.close();
        } catch (const IoError&) {
            refused = true;
        }
        setrlimit(RLIMIT_FSIZE, &before);
        EXPECT_TRUE(refused) << bytes;
        EXPECT_EQ(folder.count(), 0u) << bytes;
    }
}

TEST_F(Wav, NeedsConstantMemory) {
    const auto peak_kb = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    wav.rate_changed(8000);
    for (int i = 0; i < 8000; ++i) wav.push(1, 1);
    const long before_kb = peak_kb();
    for (int i = 0; i < 600 * 8000; ++i) wav.push(1, 1);
    EXPECT_LT(peak_kb() - before_kb, 2000);
    wav.close();
}

}  // namespace
