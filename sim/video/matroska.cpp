#include "sim/video/matroska.h"

#include <cmath>
#include <cstring>

namespace sim {

namespace {

constexpr unsigned PICTURES = 1, SOUND = 2;  // tracks
constexpr std::uint64_t NS_PER_TICK = 1000;
// How long a picture is shown after which none comes.  FFmpeg 7.1 guesses none from two pictures,
// and VP9's encoder refuses a picture without.
constexpr std::uint64_t PICTURE_NS = 16'666'667;

std::string big_endian(std::uint64_t value, unsigned bytes) {
    std::string text;
    for (unsigned n = bytes; n-- > 0;) text += static_cast<char>(value >> 8 * n);
    return text;
}

// An element of EBML: its id, its size, and what is in it.
std::string element(std::uint32_t id, const std::string& content) {
    const unsigned bytes = id > 0xFFFFFF ? 4 : id > 0xFFFF ? 3 : id > 0xFF ? 2 : 1;
    return big_endian(id, bytes) + big_endian(std::uint64_t{1} << 56 | content.size(), 8) + content;
}

std::string element(std::uint32_t id, std::uint64_t value) {
    return element(id, big_endian(value, 8));
}

std::string element(std::uint32_t id, double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return element(id, bits);
}

std::string track(unsigned number, const char* codec, const std::string& format) {
    constexpr std::uint64_t PICTURES_ARE = 1, SOUND_IS = 2;
    return element(0xAE, element(0xD7, std::uint64_t{number}) +        // TrackNumber
                             element(0x73C5, std::uint64_t{number}) +  // TrackUID
                             element(0x83, number == PICTURES ? PICTURES_ARE : SOUND_IS) +
                             element(0x9C, std::uint64_t{0}) +  // FlagLacing
                             element(0x86, std::string{codec}) + format);
}

// A cluster with the one block.
std::string block(unsigned track_number, std::uint64_t time_us, const std::string& bytes) {
    constexpr std::uint64_t KEY_FRAME = 0x80, AT_THE_CLUSTERS_TIME = 0;
    const std::string head = big_endian(0x80 | track_number, 1) +
                             big_endian(AT_THE_CLUSTERS_TIME, 2) + big_endian(KEY_FRAME, 1);
    return element(0x1F43B675, element(0xE7, time_us) + element(0xA3, head + bytes));
}

}  // namespace

Matroska::Matroska(unsigned width, unsigned height, unsigned rate_hz)
    : width_{width}, height_{height}, rate_hz_{rate_hz} {}

std::string Matroska::head() const {
    const std::string unknown_size = '\1' + std::string(7, '\xff');
    const std::string video =
        element(0x23E383, PICTURE_NS) +  // DefaultDuration
        element(0xE0, element(0xB0, std::uint64_t{width_}) + element(0xBA, std::uint64_t{height_}) +
                          element(0x2EB524, std::string{"BGRA"}));
    const std::string audio =
        element(0xE1, element(0xB5, static_cast<double>(rate_hz_)) +
                          element(0x9F, std::uint64_t{2}) + element(0x6264, std::uint64_t{16}));
    return element(0x1A45DFA3,
                   element(0x4286, std::uint64_t{1}) + element(0x42F7, std::uint64_t{1}) +
                       element(0x42F2, std::uint64_t{4}) + element(0x42F3, std::uint64_t{8}) +
                       element(0x4282, std::string{"matroska"}) +
                       element(0x4287, std::uint64_t{4}) + element(0x4285, std::uint64_t{2})) +
           big_endian(0x18538067, 4) + unknown_size +
           element(0x1549A966, element(0x2AD7B1, NS_PER_TICK) +
                                   element(0x4D80, std::string{"de1sim"}) +
                                   element(0x5741, std::string{"de1sim"})) +
           element(0x1654AE6B,
                   track(PICTURES, "V_UNCOMPRESSED", video) + track(SOUND, "A_PCM/INT/LIT", audio));
}

std::string Matroska::picture(const std::vector<std::uint32_t>& pixels, double time_s) const {
    const std::string bytes{reinterpret_cast<const char*>(pixels.data()), 4 * pixels.size()};
    const auto time_us = static_cast<std::uint64_t>(std::llround(time_s * 1e6));
    return block(PICTURES, time_us, bytes);
}

std::string Matroska::sound(const std::vector<std::int16_t>& samples) {
    const std::uint64_t time_us = written_ * 1'000'000 / rate_hz_;
    written_ += samples.size() / 2;
    const std::string bytes{reinterpret_cast<const char*>(samples.data()), 2 * samples.size()};
    return block(SOUND, time_us, bytes);
}

}  // namespace sim
