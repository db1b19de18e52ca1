// sound_in_test.cpp - play-file, play-tone, play-silence
#include <sndfile.h>

#include "tb/support/temp_folder.h"
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;
using testing::EndsWith;

class SoundInSteps : public StepTest {
protected:
    const TempFolder files;

    // A tone after a quarter of its period, as a part of full scale.
    static double crest(sim::SoundSource& source, std::uint64_t us) {
        return source.sample(us * 1'000'000, 48'000).left / 2147483648.0;
    }
    sim::Scenario load(const std::string& step) {
        files.put("run.yaml", "name: a\nversion: 1\nsteps:\n- " + step);
        return sim::load_scenario(files / "run.yaml");
    }
};

TEST_F(SoundInSteps, PlayAFileBesideTheScenario) {
    SF_INFO info{};
    info.channels = 1;
    info.samplerate = 8000;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* file = sf_open((files / "a.wav").c_str(), SFM_WRITE, &info);
    const short samples[] = {100, 200, 300};
    sf_write_short(file, samples, 3);
    sf_close(file);
    // 16 bits of each sample.
    const auto heard = [](sim::SoundSource& source) {
        std::vector<int> all;
        for (std::uint64_t n = 0; n < 5; ++n)
            all.push_back(source.sample(n * 125'000'000, 8000).left >> 16);
        return all;
    };
    load("play-file: a.wav").steps.at(0).step->play(board);
    EXPECT_THAT(heard(board.line_in), ElementsAre(100, 200, 300, 0, 0));
    load("play-file: {file: a.wav, repeat: forever}").steps.at(0).step->play(board);
    EXPECT_THAT(heard(board.line_in), ElementsAre(100, 200, 300, 100, 200));
    EXPECT_THAT(heard(board.microphone), ElementsAre(0, 0, 0, 0, 0));
    load("play-file: {file: a.wav, into: microphone}").steps.at(0).step->play(board);
    EXPECT_THAT(heard(board.microphone), ElementsAre(100, 200, 300, 0, 0));
    EXPECT_EQ(said("play-file: b/a.wav"), "play a.wav into LINE IN");
    EXPECT_EQ(said("play-file: {file: a.wav, into: microphone, repeat: forever}"),
              "play a.wav into the microphone for ever");
}

TEST_F(SoundInSteps, RefuseAFileThatIsNotThere) {
    try {
        load("play-file: b.wav");
        FAIL();
    } catch (const sim::ScenarioError& error) {
        EXPECT_THAT(error.what(), EndsWith("run.yaml:4:3: expected a sound file, got " +
                                           (files / "b.wav").string() + ": is not there"));
    }
}

TEST_F(SoundInSteps, PlayATone) {
    acts("play-tone: {hz: 1000}");
    EXPECT_NEAR(crest(board.line_in, 250), 0.5, 0.001);
    EXPECT_EQ(crest(board.microphone, 250), 0);
    acts("play-tone: {hz: 2000.0, level: 100%, into: microphone}");
    EXPECT_NEAR(crest(board.microphone, 125), 1, 0.001);
    EXPECT_EQ(said("play-tone: {hz: 440}"), "play 440 Hz at 50% into LINE IN");
    EXPECT_EQ(step_error("play-tone: {hz: 440, level: 0%}"),
              "a.yaml:4:31: expected a percentage such as 50%, from 1% to 100%, got \"0%\"");
}

TEST_F(SoundInSteps, PlayNothing) {
    board.line_in.tone(1000, 0.5, 0);
    board.microphone.tone(1000, 0.5, 0);
    acts("play-silence: {into: microphone}");
    EXPECT_EQ(crest(board.microphone, 250), 0);
    EXPECT_NEAR(crest(board.line_in, 250), 0.5, 0.001);
    acts("play-silence: {}");
    EXPECT_EQ(crest(board.line_in, 250), 0);
    EXPECT_EQ(said("play-silence: {}"), "play nothing into LINE IN");
}

}  // namespace
