// A picture is refused, or decoded; encoded again it is the same.  Of one whose chunks' checksums
// are wrong, the same with right ones is tried, so that damage gets beyond them.
#include <cstdint>

#include <zlib.h>

#include "sim/files/png.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

constexpr std::size_t SIGNATURE = 8, HEAD = 8, SUM = 4;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

std::string with_right_sums(std::string bytes) {
    for (std::size_t at = SIGNATURE; at + HEAD + SUM <= bytes.size();) {
        const std::size_t length = word_at(bytes, at);
        if (length > bytes.size() - at - HEAD - SUM) break;
        const auto* type = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
        const auto sum = crc32(0, type, static_cast<uInt>(4 + length));
        at += HEAD + length;
        for (unsigned i = 0; i < SUM; ++i) bytes[at++] = static_cast<char>(sum >> (24 - 8 * i));
    }
    return bytes;
}

// A picture of some bytes that says it is large takes long to clear the memory for.
bool is_slow(const std::string& bytes) {
    if (bytes.size() < 24) return false;
    const std::uint64_t width = word_at(bytes, 16), height = word_at(bytes, 20);
    return width <= 4096 && height <= 4096 && width * height > 0x10000;
}

void try_picture(const std::string& bytes) {
    try {
        const sim::Image image = sim::decode_png(bytes);
        must(image.rgb.size() == std::size_t{3} * image.width * image.height,
             "a picture has all its pixels");
        const auto encoded = sim::encode_png(image);
        must(sim::decode_png({reinterpret_cast<const char*>(encoded.data()), encoded.size()}) ==
                 image,
             "a picture that is written is read as it was");
    } catch (const sim::PngError& error) {
        must_be_a_line(error.what());
    }
}

}  // namespace

void try_png(std::string_view input) {
    const std::string bytes{input}, mended = with_right_sums(bytes);
    if (is_slow(bytes)) return;
    try_picture(bytes);
    if (mended != bytes) try_picture(mended);
}

}  // namespace fuzz
