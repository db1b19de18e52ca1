#include "sim/video/muxer.h"

namespace sim {

Muxer::Muxer(const std::filesystem::path& path) : file_{path} {
    av_log_set_level(AV_LOG_QUIET);  // errors come by results
    av_check(avformat_alloc_output_context2(&format_, nullptr, is_webm() ? "webm" : "mp4", nullptr),
             "write this kind of file");
    format_->flags |= AVFMT_FLAG_BITEXACT;
    format_->avoid_negative_ts = 0;  // that of an encoder's run-up is what the file says itself
    check(avio_open(&format_->pb, ("file:" + file_.part().string()).c_str(), AVIO_FLAG_WRITE));
}

Muxer::~Muxer() {
    if (format_->pb) avio_closep(&format_->pb);
    avformat_free_context(format_);
}

int Muxer::encoder_flags() const {
    return format_->oformat->flags & AVFMT_GLOBALHEADER ? AV_CODEC_FLAG_GLOBAL_HEADER : 0;
}

AVStream& Muxer::add_track(const AVCodecContext& encoder) {
    AVStream& track = *av_made(avformat_new_stream(format_, nullptr));
    track.time_base = encoder.time_base;
    av_check(avcodec_parameters_from_context(track.codecpar, &encoder), "add a track");
    return track;
}

void Muxer::begin() {
    check(avformat_write_header(format_, nullptr));
    begun_ = true;
    for (const Early& early : early_) write(*early.packet, early.time_base);
    early_.clear();
}

void Muxer::write(AVPacket& packet, const AVCodecContext& encoder, const AVStream& track) {
    packet.stream_index = track.index;
    if (begun_) return write(packet, encoder.time_base);
    early_.push_back({AvPacket{av_made(av_packet_alloc())}, encoder.time_base});
    av_packet_move_ref(early_.back().packet.get(), &packet);
}

void Muxer::write(AVPacket& packet, AVRational time_base) {
    av_packet_rescale_ts(&packet, time_base, format_->streams[packet.stream_index]->time_base);
    check(av_interleaved_write_frame(format_, &packet));
    check(format_->pb->error);
}

void Muxer::commit() {
    check(av_write_trailer(format_));
    check(avio_closep(&format_->pb));
    file_.commit();
}

void Muxer::check(int result) const {
    if (result < 0) throw IoError(file_.path(), "write", AVUNERROR(result));
}

}  // namespace sim
