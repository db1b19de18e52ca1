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
    const short samples[] = {1, 2, 3};
    sf_write_short(file, samples, 3);
    sf_close(file);
    for (const char* step : {"play-file: a.wav", "play-file: {file: a.wav, repeat: forever}",
                             "play-file: {file: a.wav, into: microphone}"})
        load(step).steps.at(0).step->play(board);
    EXPECT_THAT(board.done,
                ElementsAre("play 3 into 0 false", "play 3 into 0 true", "play 3 into 1 false"));
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
    EXPECT_THAT(acts("play-tone: {hz: 440}"), ElementsAre("tone 440 0.5 into 0"));
    EXPECT_THAT(acts("play-tone: {hz: 440.5, level: 100%, into: microphone}"),
                ElementsAre("tone 440.5 1 into 1"));
    EXPECT_EQ(said("play-tone: {hz: 440}"), "play 440 Hz at 50% into LINE IN");
    EXPECT_EQ(step_error("play-tone: {hz: 440, level: 0%}"),
              "a.yaml:4:31: expected a percentage such as 50%, from 1% to 100%, got \"0%\"");
}

TEST_F(SoundInSteps, PlayNothing) {
    EXPECT_THAT(acts("play-silence: {}"), ElementsAre("silence into 0"));
    EXPECT_THAT(acts("play-silence: {into: microphone}"), ElementsAre("silence into 1"));
    EXPECT_EQ(said("play-silence: {}"), "play nothing into LINE IN");
}

}  // namespace
