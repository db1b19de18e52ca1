// video.h - the pictures and the sound of a run in one file, MP4 or WebM, in step
//
// The encoders are FFmpeg's.  They bring a hundred libraries, which take longer to load than most
// commands run, so they are in a module (sim/video) that is loaded for --video alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace sim {

// Times are simulated seconds since power-on, and never go back.  Failures to write are IoError;
// without close() there is no file.
class VideoWriter {
public:
    virtual ~VideoWriter() = default;

    // 0x00RRGGBB, row by row: shown from now on until the next one.  Before the first one the video
    // is black.  It has the first one's size, or 640 x 480 if none came within a second; others are
    // scaled to it.
    virtual void frame(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height,
                       double time_s) = 0;
    virtual void sample(std::int16_t left, std::int16_t right, double time_s) = 0;
    virtual void sample_rate(double hz) = 0;  // of the samples to come
    virtual void close(double time_s) = 0;
};

// Whether a file of this name could be written: its ending is .mp4 or .webm.
bool is_video_name(const std::filesystem::path& path);

// IoError if the file cannot be created, std::runtime_error if there is no module.
std::unique_ptr<VideoWriter> open_video(const std::filesystem::path& path);

}  // namespace sim

// What the module is asked for by name.
extern "C" [[gnu::visibility("default")]] sim::VideoWriter* de1sim_open_video(
    const std::filesystem::path& path);
