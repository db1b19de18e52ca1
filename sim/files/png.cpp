// png.cpp - PNG by libpng
#include "sim/files/png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <new>
#include <string>

#include "sim/files/whole_file.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

constexpr unsigned MAX_SIDE = 4096;
constexpr std::size_t MAX_FILE_BYTES = 64u << 20;
constexpr char END_CHUNK[] = "\0\0\0\0IEND\xAE\x42\x60\x82";

void append(png_structp png, png_bytep bytes, std::size_t size) {
    bool stored = false;
    try {
        auto& out = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
        out.insert(out.end(), bytes, bytes + size);
        stored = true;
    } catch (const std::bad_alloc&) {  // must not pass through libpng's C
    }
    if (!stored) png_error(png, "out of memory");
}

void require_one_size(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size())
        throw std::invalid_argument(fmt::format("images of {} x {} and {} x {} do not compare",
                                                a.width, a.height, b.width, b.height));
}

bool differs_at(const Image& a, const Image& b, std::size_t i) {
    return !std::equal(&a.rgb[i], &a.rgb[i] + 3, &b.rgb[i]);
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    const std::size_t row_bytes = std::size_t{3} * image.width;
    if (image.width == 0 || image.height == 0 || image.rgb.size() != row_bytes * image.height)
        throw std::invalid_argument(fmt::format("an image of {} x {} pixels with {} bytes",
                                                image.width, image.height, image.rgb.size()));
    std::vector<std::uint8_t> out;
    out.reserve(64 * 1024);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    // Nothing with a destructor may be declared from here to the last png_ call: libpng longjmps.
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        throw std::bad_alloc();  // the only possible failure: it writes to memory
    }
    png_set_write_fn(png, &out, append, nullptr);
    png_set_IHDR(png, info, image.width, image.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, 0);  // Z_DEFAULT_STRATEGY; libpng's own is for filtered rows
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_write_info(png, info);
    for (unsigned y = 0; y < image.height; ++y)
        png_write_row(png, image.rgb.data() + y * row_bytes);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return out;
}

Image decode_png(std::string_view bytes) {
    if (bytes.substr(0, 8) != "\x89PNG\r\n\x1A\n") throw PngError("not a PNG");
    const std::string_view end(END_CHUNK, sizeof END_CHUNK - 1);
    if (bytes.size() < end.size() || bytes.substr(bytes.size() - end.size()) != end)
        throw PngError("the PNG is cut short, or something follows its end");

    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
        throw PngError("damaged PNG: " + printable(png.message));
    if (png.width > MAX_SIDE || png.height > MAX_SIDE) {
        png_image_free(&png);
        throw PngError(fmt::format("the PNG is too large: {} x {} pixels, at most {} x {}",
                                   png.width, png.height, MAX_SIDE, MAX_SIDE));
    }
    png.format = PNG_FORMAT_RGB;
    Image image{png.width, png.height, {}};
    image.rgb.resize(PNG_IMAGE_SIZE(png));
    const png_color black{0, 0, 0};
    if (!png_image_finish_read(&png, &black, image.rgb.data(), 0, nullptr))
        throw PngError("damaged PNG: " + printable(png.message));
    return image;
}

Image read_png(const std::filesystem::path& path) {
    const std::string bytes = read_whole_file(path, MAX_FILE_BYTES);
    try {
        return decode_png(bytes);
    } catch (const PngError& error) {
        throw PngError(printable(path.string()) + ": " + error.what());
    }
}

void write_png(const std::filesystem::path& path, const Image& image) {
    const auto bytes = encode_png(image);
    write_whole_file(path, bytes.data(), bytes.size());
}

std::size_t differing_pixels(const Image& a, const Image& b) {
    require_one_size(a, b);
    if (a.rgb == b.rgb) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) count += differs_at(a, b, i);
    return count;
}

Image difference_image(const Image& a, const Image& b) {
    require_one_size(a, b);
    Image out = b;
    for (std::size_t i = 0; i < b.rgb.size(); i += 3) {
        const unsigned sum = b.rgb[i] + b.rgb[i + 1] + b.rgb[i + 2];
        const auto grey = static_cast<std::uint8_t>(sum / 9);  // a third of the mean
        std::fill_n(&out.rgb[i], 3, grey);
        if (!differs_at(a, b, i)) continue;
        out.rgb[i] = 255;
        out.rgb[i + 1] = out.rgb[i + 2] = 0;
    }
    return out;
}

}  // namespace sim
