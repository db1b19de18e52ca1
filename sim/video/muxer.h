// muxer.h - the file: packets of both tracks, by time
#pragma once

#include <filesystem>
#include <vector>

#include "sim/files/whole_file.h"
#include "sim/video/av.h"

namespace sim {

class Muxer {
public:
    explicit Muxer(const std::filesystem::path& path);  // IoError
    ~Muxer();

    bool is_webm() const { return file_.path().extension() == ".webm"; }
    // What its encoders need to be told.
    int encoder_flags() const;

    // Tracks are added, then the file begins.  Packets from before are kept until then.
    AVStream& add_track(const AVCodecContext& encoder);
    void begin();
    // `packet` is in the encoder's time base, and empty afterwards.
    void write(AVPacket& packet, const AVCodecContext& encoder, const AVStream& track);
    void commit();

private:
    struct Early {
        AvPacket packet;
        AVRational time_base;
    };

    void write(AVPacket& packet, AVRational time_base);
    void check(int result) const;

    WholeFile file_;
    AVFormatContext* format_ = nullptr;
    bool begun_ = false;
    std::vector<Early> early_;
};

// Encodes a frame, or with null what is left, and writes what comes of it.  `before` sees each
// packet first.
template <class Before>
void encode(AVCodecContext& encoder, const AVFrame* frame, Muxer& muxer, const AVStream& track,
            Before before) {
    av_check(avcodec_send_frame(&encoder, frame), "encode");
    const AvPacket packet{av_made(av_packet_alloc())};
    for (;;) {
        const int result = avcodec_receive_packet(&encoder, packet.get());
        if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return;
        av_check(result, "encode");
        before(*packet);
        muxer.write(*packet, encoder, track);
    }
}

}  // namespace sim
