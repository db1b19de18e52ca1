#include "sim/video/picture_track.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr int TICKS_PER_S = 90'000;

std::int64_t ticks(double time_s) { return std::llround(time_s * TICKS_PER_S); }

struct Yuv {
    std::uint8_t y, u, v;
};

std::uint8_t rounded(double value) { return static_cast<std::uint8_t>(std::lround(value)); }

// BT.709, limited range.
Yuv yuv(std::uint32_t rgb) {
    const double r = (rgb >> 16 & 0xFF) / 255.0, g = (rgb >> 8 & 0xFF) / 255.0,
                 b = (rgb & 0xFF) / 255.0;
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return {rounded(16 + 219 * y), rounded(128 + 224 * (b - y) / 1.8556),
            rounded(128 + 224 * (r - y) / 1.5748)};
}

// By quality: lines on black take little, whatever the size.
void set_quality(AVCodecContext& encoder, bool is_webm) {
    const auto set = [&encoder](const char* name, const char* value) {
        av_check(av_opt_set(encoder.priv_data, name, value, 0), name);
    };
    if (is_webm) {
        set("crf", "20");
        set("deadline", "realtime");
        set("cpu-used", "7");
        set("lag-in-frames", "0");
    } else {
        set("crf", "18");
        set("preset", "veryfast");
        set("x264-params", "cpu-independent=1");  // the same bytes on every machine
    }
}

}  // namespace

PictureTrack::PictureTrack(Muxer& muxer, unsigned width, unsigned height)
    : muxer_{muxer},
      width_{width},
      height_{height},
      encoder_{av_encoder(muxer.is_webm() ? "libvpx-vp9" : "libx264")},
      picture_{av_made(av_frame_alloc())} {
    encoder_->width = static_cast<int>(2 * width);
    encoder_->height = static_cast<int>(2 * height);
    encoder_->pix_fmt = AV_PIX_FMT_YUV420P;
    encoder_->color_range = AVCOL_RANGE_MPEG;
    encoder_->colorspace = AVCOL_SPC_BT709;
    encoder_->color_primaries = AVCOL_PRI_BT709;
    encoder_->color_trc = AVCOL_TRC_BT709;
    encoder_->time_base = {1, TICKS_PER_S};
    encoder_->framerate = {60, 1};  // for the rate control; the true times are the pictures'
    encoder_->gop_size = 120;       // two seconds, for seeking
    encoder_->max_b_frames = 0;     // so that packets come in the pictures' order
    encoder_->bit_rate = 0;
    encoder_->flags |= muxer.encoder_flags();
    set_quality(*encoder_, muxer.is_webm());
    av_check(avcodec_open2(encoder_.get(), nullptr, nullptr), "encode pictures of this size");
    track_ = &muxer.add_track(*encoder_);

    picture_->width = encoder_->width;
    picture_->height = encoder_->height;
    picture_->format = encoder_->pix_fmt;
    picture_->color_range = encoder_->color_range;
    picture_->colorspace = encoder_->colorspace;
    av_check(av_frame_get_buffer(picture_.get(), 0), "make a picture");
}

void PictureTrack::show(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height,
                        double time_s) {
    end_picture(time_s);
    draw(pixels, width, height);
    picture_->pts = ticks(time_s);
    waiting_ = true;
}

void PictureTrack::close(double time_s) {
    end_picture(time_s);
    write(nullptr);
}

void PictureTrack::draw(const std::vector<std::uint32_t>& pixels, unsigned width, unsigned height) {
    av_check(av_frame_make_writable(picture_.get()), "make a picture");
    std::uint32_t last = 0;
    Yuv colour = yuv(last);
    for (unsigned y = 0; y < height_; ++y) {
        const std::uint32_t* row = &pixels[std::size_t{y * height / height_} * width];
        const auto line = [&](unsigned plane, unsigned number) {
            return picture_->data[plane] +
                   std::ptrdiff_t{picture_->linesize[plane]} * std::ptrdiff_t{number};
        };
        std::uint8_t *even = line(0, 2 * y), *u = line(1, y), *v = line(2, y);
        for (unsigned x = 0; x < width_; ++x) {
            const std::uint32_t rgb = row[x * width / width_];
            if (rgb != last) colour = yuv(last = rgb);
            even[2 * x] = even[2 * x + 1] = colour.y;
            u[x] = colour.u;
            v[x] = colour.v;
        }
        std::copy_n(even, 2 * width_, line(0, 2 * y + 1));
    }
}

void PictureTrack::end_picture(double time_s) {
    if (!waiting_) return;
    waiting_ = false;
    durations_.push_back(std::max<std::int64_t>(ticks(time_s) - picture_->pts, 1));
    write(picture_.get());
}

void PictureTrack::write(const AVFrame* frame) {
    encode(*encoder_, frame, muxer_, *track_, [this](AVPacket& packet) {
        packet.duration = durations_.front();
        durations_.pop_front();
    });
}

}  // namespace sim
