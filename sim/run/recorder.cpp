#include "sim/run/recorder.h"

#include "sim/files/sha256.h"
#include "sim/text/messages.h"
#include "sim/text/seconds.h"

namespace sim {

namespace {

double now_s() { return seconds(sc_core::sc_time_stamp()); }

}  // namespace

Recorder::Recorder(const std::filesystem::path& out, FrameChoice frames,
                   const std::filesystem::path& video)
    : frames_{frames}, folder_{out}, wav_{out}, console_{out / "console.txt"} {
    if (!video.empty()) video_.emplace(video);
    if (frames.which != FrameChoice::Which::NONE) frame_writer_.emplace(out);
}

template <class Write>
void Recorder::attempt(Write write) {
    if (error_) return;
    try {
        write();
    } catch (const std::exception&) {
        error_ = std::current_exception();
        sc_core::sc_pause();
    }
}

void Recorder::frame(const Monitor::Frame& frame) {
    observations_.frame(frame);
    on_frame();
    if (page && frame.is_new) page->film.show(now_s(), observations_);
    constexpr std::size_t MOST_PICTURES = 1000;
    if (frame.is_new && pictures_.size() < MOST_PICTURES)
        pictures_.emplace_back(frame.number, sha256_hex(observations_.picture().rgb));
    if (frame_writer_ && frames_.wants(frame.number, frame.is_new))
        attempt([&] {
            frame_writer_->push(frame.number, image_of(frame.pixels, frame.width, frame.height));
        });
    if (video_) attempt([&] { video_->frame(frame.pixels, frame.width, frame.height, now_s()); });
}

void Recorder::sample(std::int16_t left, std::int16_t right) {
    observations_.sample(left, right);
    if (page) page->sound.sample(now_s(), left, right);
    attempt([&] {
        wav_.push(left, right);
        if (video_) video_->sample(left, right, now_s());
    });
}

void Recorder::sample_rate(double hz) {
    observations_.sample_rate(hz);
    if (page) page->sound.sample_rate(hz);
    attempt([&] {
        wav_.rate_changed(hz);
        if (video_) video_->sample_rate(hz);
    });
}

void Recorder::console(char character, SerialLine) {
    observations_.console(character);
    if (page) page->console.print(now_s(), character);
    if (output) output->print(character);
    attempt([&] { console_.print(character); });
}

void Recorder::log(const std::string& line) {
    constexpr std::uint64_t MOST = 20;
    if (++log_lines_ > MOST) return;
    log_.push_back(line);
    complain(line);
    if (log_lines_ == MOST) complain("more of the kind is only counted");
}

void Recorder::close() {
    if (error_) std::rethrow_exception(error_);
    if (frame_writer_) {
        if (frames_.which == FrameChoice::Which::LAST && observations_.frames > 0)
            frame_writer_->push(observations_.frames, observations_.picture());
        frame_writer_->close();
    }
    wav_.close();
    if (video_) video_->close(now_s());
    console_.commit();
}

}  // namespace sim
