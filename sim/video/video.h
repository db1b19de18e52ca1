// video.h - the pictures and the sound of a run in one file, MP4 or WebM, in step
//
//   pictures, samples --> Matroska on a pipe --> ffmpeg --> NAME.part --> NAME
//
// The program ffmpeg encodes: H.264 and AAC, or VP9 and Opus, with one thread, so that the same run
// gives the same file.  Each picture has its own time and twice its size: browsers want colour at
// half the resolution, which at twice the size is one colour per pixel of the monitor.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/files/whole_file.h"
#include "sim/process/piped_command.h"
#include "sim/video/matroska.h"
#include "sim/video/sound_track.h"

namespace sim {

// Whether a file of this name could be written: its ending is .mp4 or .webm.
bool is_video_name(const std::filesystem::path& path);

// Times are simulated seconds since power-on, and never go back.  Failures to write are IoError;
// without close() there is no file.
class VideoWriter {
public:
    // IoError if the file cannot be created; std::runtime_error if there is no ffmpeg.
    explicit VideoWriter(const std::filesystem::path& path);

    // 0x00RRGGBB, row by row: shown from now on until the next one.  Before the first one the video
    // is black.  It has the first one's size, or 640 x 480 if none came within a second; others are
    // scaled to it.
    void frame(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height,
               double time_s);
    void sample(std::int16_t left, std::int16_t right, double time_s);
    void sample_rate(double hz) { sound_.rate(hz); }  // of the samples to come
    void close(double time_s);

private:
    void begin(unsigned width, unsigned height);
    void send(const std::string& bytes);
    void write_sound();
    void finish();

    WholeFile file_;
    PipedCommand ffmpeg_;
    SoundTrack sound_;
    std::optional<Matroska> matroska_;  // once the size is known
    unsigned width_ = 0, height_ = 0;
    bool scaling_reported_ = false;
};

}  // namespace sim
