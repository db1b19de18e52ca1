// av.h - FFmpeg's objects with their ends, and its errors
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswresample/swresample.h>
}

#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace sim {

template <auto release>
struct AvRelease {
    template <class T>
    void operator()(T* object) const {
        release(&object);
    }
};
using AvFrame = std::unique_ptr<AVFrame, AvRelease<av_frame_free>>;
using AvPacket = std::unique_ptr<AVPacket, AvRelease<av_packet_free>>;
using AvEncoder = std::unique_ptr<AVCodecContext, AvRelease<avcodec_free_context>>;
using AvResampler = std::unique_ptr<SwrContext, AvRelease<swr_free>>;

// What is not the disk's fault.
inline int av_check(int result, const char* doing) {
    if (result >= 0) return result;
    char text[AV_ERROR_MAX_STRING_SIZE] = {};
    av_strerror(result, text, sizeof text);
    throw std::runtime_error{std::string{"FFmpeg cannot "} + doing + ": " + text};
}

template <class T>
T* av_made(T* object) {
    if (!object) throw std::bad_alloc{};
    return object;
}

// One thread and nothing of the library's version, so that the same run gives the same file.
inline AvEncoder av_encoder(const char* name) {
    const AVCodec* codec = avcodec_find_encoder_by_name(name);
    if (!codec)
        throw std::runtime_error{std::string{"--video: FFmpeg's libraries have no "} + name};
    AvEncoder encoder{av_made(avcodec_alloc_context3(codec))};
    encoder->thread_count = 1;
    encoder->flags |= AV_CODEC_FLAG_BITEXACT;
    return encoder;
}

}  // namespace sim
