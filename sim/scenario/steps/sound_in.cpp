// sound_in.cpp - play-file, play-tone, play-silence: what LINE IN and the microphone get
#include <fmt/format.h>

#include "sim/board/sound_source.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

using namespace value_types;

class IntoInput : public Action {
protected:
    explicit IntoInput(const Values& v) : microphone_{v.number<bool>("into")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("AUD_ADCDAT", microphone_ ? "the microphone" : "LINE IN");
    }
    std::string into() const { return microphone_ ? " into the microphone" : " into LINE IN"; }
    SoundSource& source(BoardControl& board) const {
        return board.part<SoundSource>(microphone_ ? "microphone input" : "LINE IN");
    }

private:
    bool microphone_;
};

class PlayFile : public IntoInput {
public:
    explicit PlayFile(const Values& v)
        : IntoInput{v}, file_{v.path("file")}, for_ever_{v.number<bool>("repeat")} {}

    std::string describe() const override {
        return "play " + printable(file_.filename().string()) + into() +
               (for_ever_ ? " for ever" : "");
    }
    void load(Goldens) override {
        try {
            recording_ = std::make_shared<Recording>(read_recording(file_));
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(std::string{"expected a sound file, got "} + error.what());
        }
    }
    void act(BoardControl& board) const override {
        board.act([&into = source(board), what = recording_, for_ever = for_ever_,
                   now_ps = board.now_ps()] { into.play(what, for_ever, now_ps); });
    }

private:
    std::filesystem::path file_;
    bool for_ever_;
    std::shared_ptr<const Recording> recording_ = std::make_shared<Recording>();
};

class PlayTone : public IntoInput {
public:
    explicit PlayTone(const Values& v)
        : IntoInput{v}, hz_{v.get<double>("hz")}, level_{v.get<double>("level")} {}

    std::string describe() const override {
        return fmt::format("play {:.6g} Hz at {:.6g}%{}", hz_, 100 * level_, into());
    }
    void act(BoardControl& board) const override {
        board.act([&into = source(board), hz = hz_, level = level_, now_ps = board.now_ps()] {
            into.tone(hz, level, now_ps);
        });
    }

private:
    double hz_, level_;
};

class PlaySilence : public IntoInput {
public:
    explicit PlaySilence(const Values& v) : IntoInput{v} {}

    std::string describe() const override { return "play nothing" + into(); }
    void act(BoardControl& board) const override {
        board.act([&into = source(board)] { into.silence(); });
    }
};

const ValueType INPUT = word("line-in or microphone", {"line-in", "microphone"});
const ValueType REPEAT = word("once or forever", {"once", "forever"});
const ValueType AMPLITUDE = percent("a percentage such as 50%, from 1% to 100%", 1, 100);

}  // namespace

namespace steps {

std::vector<StepForm> sound_in() {
    const Field into{"into", INPUT, Need::OPTIONAL, "line-in", "line-in or microphone."};
    return {
        {"play-file",
         "Play a sound file into the codec and go on; it takes the place of what was played there.",
         Notation::BOTH,
         {},
         {{"file", FILE_NAME, Need::REQUIRED, "",
           "A WAV file, or another that libsndfile reads, relative to the scenario file; its rate "
           "becomes the codec's."},
          into,
          {"repeat", REPEAT, Need::OPTIONAL, "once", "once, or forever from the beginning."}},
         make<PlayFile>},
        {"play-tone",
         "Play a sine tone into the codec and go on, until something else is played there.",
         Notation::MAP,
         {},
         {{"hz", HERTZ, Need::REQUIRED, "", "Its frequency in hertz."},
          {"level", AMPLITUDE, Need::OPTIONAL, "50%", "Its amplitude in parts of full scale."},
          into},
         make<PlayTone>},
        {"play-silence",
         "Play nothing into the codec any more.",
         Notation::MAP,
         {},
         {into},
         make<PlaySilence>},
    };
}

}  // namespace steps

}  // namespace sim
