#include "sim/run/recorder.h"

#include <regex>
#include <system_error>

#include <fmt/format.h>

namespace sim {

namespace fs = std::filesystem;

namespace {

// Only names that a run makes; anything else in the folder is somebody's.
void remove_old(const fs::path& folder, const char* names) {
    const std::regex pattern{names};
    std::error_code error;
    for (fs::directory_iterator it{folder, error}, end; !error && it != end; it.increment(error)) {
        std::error_code failed;
        if (std::regex_match(it->path().filename().string(), pattern) &&
            it->is_regular_file(failed))
            fs::remove(it->path(), failed);
        if (failed) throw IoError{it->path(), "cannot remove", failed.value()};
    }
}

const fs::path& prepared(const fs::path& out) {
    make_folder(out);
    remove_old(out, R"(audio(-\d+)?\.wav|report\.json|junit\.xml|console\.txt)");
    remove_old(out / "frames", R"(frame_\d{6,}\.png)");
    remove_old(out / "mismatch", R"(line\d+_.*_(actual|expected|difference)\.png)");
    return out;
}

}  // namespace

Recorder::Recorder(const fs::path& out, FrameChoice frames)
    : out_{prepared(out)}, frames_{frames}, wav_{out}, console_{out / "console.txt"} {
    if (frames.which != FrameChoice::Which::NONE) frame_writer_.emplace(out);
}

template <class Write>
void Recorder::attempt(Write write) {
    if (error_) return;
    try {
        write();
    } catch (const IoError& e) {
        error_ = e;
        sc_core::sc_pause();
    }
}

void Recorder::frame(const Monitor::Frame& frame) {
    senses_.frame(frame);
    on_frame();
    if (frame_writer_ && frames_.wants(frame.number))
        attempt([&] { frame_writer_->push(frame.number, image_of(frame.pixels)); });
}

void Recorder::sample(std::int16_t left, std::int16_t right) {
    senses_.sample(left, right);
    attempt([&] { wav_.push(left, right); });
}

void Recorder::sample_rate(double hz) {
    senses_.sample_rate(hz);
    attempt([&] { wav_.rate_changed(hz); });
}

void Recorder::console(char character) {
    senses_.console(character);
    attempt([&] { console_.write(&character, 1); });
}

void Recorder::log(const std::string& line) {
    constexpr std::uint64_t MOST = 20;
    if (++log_lines_ > MOST) return;
    log_.push_back(line);
    fmt::print(stderr, "de1sim: {}\n", line);
    if (log_lines_ == MOST) fmt::print(stderr, "de1sim: more of the kind is only counted\n");
}

void Recorder::close() {
    if (error_) throw *error_;
    if (frame_writer_) {
        if (frames_.which == FrameChoice::Which::LAST && senses_.frames > 0)
            frame_writer_->push(senses_.frames, senses_.picture());
        frame_writer_->close();
    }
    wav_.close();
    console_.commit();
}

}  // namespace sim
