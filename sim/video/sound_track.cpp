#include "sim/video/sound_track.h"

extern "C" {
#include <libavutil/audio_fifo.h>
}

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr int RATE_HZ = 48'000;
constexpr std::size_t BLOCK_VALUES = 2 * 512;
constexpr double GAP_S = 0.02;  // more than the jitter of the samples' times
const AVChannelLayout STEREO = AV_CHANNEL_LAYOUT_STEREO;

}  // namespace

SoundTrack::SoundTrack(Muxer& muxer)
    : muxer_{muxer}, encoder_{av_encoder(muxer.is_webm() ? "libopus" : "aac")} {
    encoder_->sample_rate = RATE_HZ;
    encoder_->sample_fmt = muxer.is_webm() ? AV_SAMPLE_FMT_S16 : AV_SAMPLE_FMT_FLTP;
    encoder_->ch_layout = STEREO;
    encoder_->time_base = {1, RATE_HZ};
    encoder_->bit_rate = 128'000;
    encoder_->flags |= muxer.encoder_flags();
    av_check(avcodec_open2(encoder_.get(), nullptr, nullptr), "encode sound");
    track_ = &muxer.add_track(*encoder_);
    waiting_ = av_made(av_audio_fifo_alloc(encoder_->sample_fmt, 2, encoder_->frame_size));
    rate(RATE_HZ);
}

SoundTrack::~SoundTrack() { av_audio_fifo_free(waiting_); }

void SoundTrack::rate(double hz) {
    const int rate_hz = static_cast<int>(std::lround(hz));
    if (rate_hz == rate_hz_ || rate_hz <= 0) return;
    drain();
    SwrContext* made = nullptr;
    av_check(swr_alloc_set_opts2(&made, &encoder_->ch_layout, encoder_->sample_fmt, RATE_HZ,
                                 &encoder_->ch_layout, AV_SAMPLE_FMT_S16, rate_hz, 0, nullptr),
             "resample");
    resampler_.reset(made);
    av_check(swr_init(resampler_.get()), "resample");
    rate_hz_ = rate_hz;
}

void SoundTrack::play(std::int16_t left, std::int16_t right, double time_s) {
    if (played_s_ + GAP_S < time_s) fill(time_s);
    push(left, right);
}

void SoundTrack::fill(double time_s) {
    while (played_s_ < time_s) push(0, 0);
}

void SoundTrack::close(double time_s) {
    fill(time_s);
    drain();
    write(av_audio_fifo_size(waiting_));
    encode_frame(nullptr);
}

void SoundTrack::push(std::int16_t left, std::int16_t right) {
    pushed_.insert(pushed_.end(), {left, right});
    played_s_ += 1.0 / rate_hz_;
    if (pushed_.size() == BLOCK_VALUES) resample();
}

void SoundTrack::resample() {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(pushed_.data());
    keep(&bytes, static_cast<int>(pushed_.size() / 2));
    pushed_.clear();
}

void SoundTrack::drain() {
    if (!resampler_) return;
    resample();
    keep(nullptr, 0);
}

void SoundTrack::keep(const std::uint8_t** samples, int count) {
    const int most = av_check(swr_get_out_samples(resampler_.get(), count), "resample");
    if (most == 0) return;
    const AvFrame block{av_made(av_frame_alloc())};
    block->format = encoder_->sample_fmt;
    block->ch_layout = STEREO;
    block->nb_samples = most;
    av_check(av_frame_get_buffer(block.get(), 0), "resample");
    const int made =
        av_check(swr_convert(resampler_.get(), block->data, most, samples, count), "resample");
    av_check(av_audio_fifo_write(waiting_, reinterpret_cast<void**>(block->data), made),
             "resample");
    while (av_audio_fifo_size(waiting_) >= encoder_->frame_size) write(encoder_->frame_size);
}

void SoundTrack::write(int count) {
    if (count == 0) return;
    const AvFrame frame{av_made(av_frame_alloc())};
    frame->format = encoder_->sample_fmt;
    frame->ch_layout = STEREO;
    frame->sample_rate = RATE_HZ;
    frame->nb_samples = count;
    av_check(av_frame_get_buffer(frame.get(), 0), "encode sound");
    av_check(av_audio_fifo_read(waiting_, reinterpret_cast<void**>(frame->data), count),
             "encode sound");
    frame->pts = written_;
    written_ += count;
    encode_frame(frame.get());
}

// An encoder's first samples are its run-up, at times before 0.  A player of WebM subtracts its
// length from all times, since the header says it.  FFmpeg 5 writes that into the header, and does
// not add it to the times, as later ones do.
void SoundTrack::encode_frame(const AVFrame* frame) {
    const bool added = !muxer_.is_webm() || avformat_version() >= AV_VERSION_INT(60, 0, 0);
    const int run_up = added ? 0 : encoder_->initial_padding;
    encode(*encoder_, frame, muxer_, *track_, [run_up](AVPacket& packet) {
        packet.pts += run_up;
        packet.dts += run_up;
    });
}

}  // namespace sim
