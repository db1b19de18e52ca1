#include "sim/video/video.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/process/run_command.h"
#include "sim/text/messages.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

constexpr unsigned WIDTH = 640, HEIGHT = 480;  // if there is no picture
constexpr double PATIENCE_S = 1;               // until then
constexpr double LATE_S = 0.1;                 // sound that has not come by then is silence
constexpr unsigned ANSWER_S = 30;

bool is_webm(const std::filesystem::path& path) { return path.extension() == ".webm"; }

// std::runtime_error: it is not there.
int major_version_of_ffmpeg() {
    const Outcome outcome = run_command({"ffmpeg", "-version"}, ".", ANSWER_S);
    if (outcome.code != 0)
        throw std::runtime_error{"--video: ffmpeg is not installed (apt install ffmpeg)"};
    constexpr const char* HEAD = "ffmpeg version ";
    const std::size_t at = outcome.output.find(HEAD);
    const int version =
        at == std::string::npos ? 0 : std::atoi(outcome.output.c_str() + at + std::strlen(HEAD));
    return version ? version : 99;  // one of its developers
}

std::vector<std::string> command_for(const std::filesystem::path& path,
                                     const std::filesystem::path& part) {
    const int version = major_version_of_ffmpeg();
    std::vector<std::string> command{
        "ffmpeg", "-nostdin", "-v", "error", "-xerror", "-y", "-f", "matroska", "-i", "pipe:0",
        "-map", "0:v", "-map", "0:a",
        // The pictures' own times, and all of them.
        "-fps_mode", "passthrough", "-enc_time_base:v", "1:90000", "-vf",
        "scale=2*iw:2*ih:flags=neighbor:out_color_matrix=bt709:out_range=tv,format=yuv420p",
        "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range",
        "tv", "-g", "120",  // two seconds, for seeking
        "-bf", "0", "-threads", "1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-flags:a",
        "+bitexact"};
    const auto add = [&command](std::initializer_list<const char*> words) {
        command.insert(command.end(), words.begin(), words.end());
    };
    // By quality: lines on black take little, whatever the size.
    if (is_webm(path)) {
        add({"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0", "-deadline", "realtime", "-cpu-used",
             "7", "-lag-in-frames", "0", "-c:a", "libopus", "-f", "webm"});
        // The encoder's first 312 samples are its run-up, whose length players subtract from all
        // times.  FFmpeg 5 subtracts it, too.
        if (version < 6) add({"-af", "asetpts=PTS+312"});
    } else {
        add({"-c:v", "libx264", "-crf", "18", "-preset", "veryfast", "-x264-params",
             "cpu-independent=1",  // the same bytes on every machine
             "-video_track_timescale", "90000", "-c:a", "aac", "-f", "mp4"});
    }
    add({"-avoid_negative_ts", "disabled"});
    command.push_back("file:" + part.string());
    return command;
}

}  // namespace

bool is_video_name(const std::filesystem::path& path) {
    return path.extension() == ".mp4" || path.extension() == ".webm";
}

VideoWriter::VideoWriter(const std::filesystem::path& path)
    : file_{path}, ffmpeg_{command_for(path, file_.part())} {}

void VideoWriter::frame(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height,
                        double time_s) {
    if (!matroska_) begin(width, height);
    sound_.fill(time_s - LATE_S);
    write_sound();
    if (width == width_ && height == height_) return send(matroska_->picture(pixels, time_s));
    if (!scaling_reported_) {
        scaling_reported_ = true;
        complain(fmt::format("--video: pictures of {} x {} are scaled to {} x {}", width, height,
                             width_, height_));
    }
    std::vector<std::uint32_t> scaled(std::size_t{width_} * height_);
    for (std::size_t y = 0; y < height_; ++y)
        for (std::size_t x = 0; x < width_; ++x)
            scaled[y * width_ + x] = pixels[y * height / height_ * width + x * width / width_];
    send(matroska_->picture(scaled, time_s));
}

void VideoWriter::sample(std::int16_t left, std::int16_t right, double time_s) {
    sound_.play(left, right, time_s);
    if (!matroska_ && time_s > PATIENCE_S) begin(WIDTH, HEIGHT);
    if (matroska_) write_sound();
}

void VideoWriter::close(double time_s) {
    if (!matroska_) begin(WIDTH, HEIGHT);
    sound_.close(time_s);
    write_sound();
    finish();
    file_.commit();
}

void VideoWriter::begin(unsigned width, unsigned height) {
    width_ = width;
    height_ = height;
    matroska_.emplace(width, height, SoundTrack::RATE_HZ);
    send(matroska_->head());
    send(matroska_->picture(std::vector<std::uint32_t>(std::size_t{width} * height), 0));  // black
}

void VideoWriter::write_sound() {
    const std::vector<std::int16_t> samples = sound_.remove();
    if (!samples.empty()) send(matroska_->sound(samples));
}

// ffmpeg ends early if it cannot write.
void VideoWriter::send(const std::string& bytes) {
    if (!ffmpeg_.write(bytes)) finish();
}

void VideoWriter::finish() {
    const Outcome outcome = ffmpeg_.finish();
    if (outcome.code == 0) return;
    for (const int reason : {ENOSPC, EFBIG, EDQUOT, EROFS, EIO})
        if (outcome.output.find(std::strerror(reason)) != std::string::npos)
            throw IoError{file_.path(), "write", reason};
    const std::string line = outcome.last_line();
    throw IoError{file_.path(),
                  "ffmpeg cannot write it: " +
                      (line.empty() ? fmt::format("exit code {}", outcome.code) : printable(line))};
}

}  // namespace sim
