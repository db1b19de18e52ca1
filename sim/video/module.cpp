// module.cpp - both tracks; the file begins with the first picture, whose size it has
#include <fmt/format.h>

#include <optional>
#include <utility>

#include "sim/files/video.h"
#include "sim/text/messages.h"
#include "sim/video/picture_track.h"
#include "sim/video/sound_track.h"

namespace sim {

namespace {

constexpr unsigned WIDTH = 640, HEIGHT = 480;  // if there is no picture
constexpr double LATE_S = 0.1;                 // sound that has not come by then is silence

class AvVideoWriter : public VideoWriter {
public:
    explicit AvVideoWriter(const std::filesystem::path& path) : muxer_{path}, sound_{muxer_} {}

    void frame(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height,
               double time_s) override {
        if (!pictures_) begin(width, height);
        if (!scaling_reported_ && std::pair{width, height} != size_) {
            scaling_reported_ = true;
            complain(fmt::format("--video: pictures of {} x {} are scaled to {} x {}", width,
                                 height, size_.first, size_.second));
        }
        sound_.fill(time_s - LATE_S);
        pictures_->show(pixels, width, height, time_s);
    }

    void sample(std::int16_t left, std::int16_t right, double time_s) override {
        sound_.play(left, right, time_s);
    }

    void sample_rate(double hz) override { sound_.rate(hz); }

    void close(double time_s) override {
        if (!pictures_) begin(WIDTH, HEIGHT);
        pictures_->close(time_s);
        sound_.close(time_s);
        muxer_.commit();
    }

private:
    void begin(unsigned width, unsigned height) {
        size_ = {width, height};
        pictures_.emplace(muxer_, width, height);
        muxer_.begin();
        pictures_->show({0}, 1, 1, 0);  // black
    }

    Muxer muxer_;
    SoundTrack sound_;
    std::optional<PictureTrack> pictures_;
    std::pair<unsigned, unsigned> size_;
    bool scaling_reported_ = false;
};

}  // namespace

}  // namespace sim

sim::VideoWriter* de1sim_open_video(const std::filesystem::path& path) {
    return new sim::AvVideoWriter{path};
}
