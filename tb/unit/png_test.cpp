// png_test.cpp - pictures to PNG and back, and how they differ
#include "sim/files/png.h"

#include <gmock/gmock.h>

#include <random>

#include "sim/files/whole_file.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim;

// Each pixel of 320 x 240 doubled: thin diagonal crosses on black, as the firmware draws them.
Image crosses(unsigned count) {
    Image image{640, 480, std::vector<std::uint8_t>(640 * 480 * 3)};
    std::mt19937 random(1);
    const auto dot = [&](unsigned x, unsigned y, unsigned colour) {
        for (unsigned i = 0; i < 4; ++i)
            for (unsigned c = 0; c < 3; ++c)
                image.rgb[((2 * y + i / 2) * 640 + 2 * x + i % 2) * 3 + c] = colour >> 8 * c & 0xFF;
    };
    for (; count > 0; --count) {
        const unsigned x = random() % 304, y = random() % 224, colour = random();
        for (unsigned i = 0; i < 16; ++i) {
            dot(x + i, y + i, colour);
            dot(x + i, y + 15 - i, colour);
        }
    }
    return image;
}

Image noise(unsigned width, unsigned height) {
    Image image{width, height, {}};
    std::mt19937 random(1);
    while (image.rgb.size() < 3 * width * height)
        image.rgb.push_back(static_cast<std::uint8_t>(random()));
    return image;
}

std::string bytes_of_hex(const std::string& hex) {
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return bytes;
}

std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

std::string decode_error(const std::string& bytes) {
    try {
        decode_png(bytes);
    } catch (const PngError& error) {
        return error.what();
    }
    return "no error";
}

// Written by Python's zlib and struct, not by libpng.  Row two of FILTERED_RGB has the Up filter.
const char FILTERED_RGB[] =
    "89504e470d0a1a0a0000000d4948445200000002000000020802000000fdd49a73000000154944415478da63f8"
    "cfc0c0f09f81899189194803001721030653180f3a0000000049454e44ae426082";
const char PALETTE[] =
    "89504e470d0a1a0a0000000d4948445200000002000000010103000000ceecedc900000006504c54450a141e28"
    "323cd51bb4e90000000a4944415478da637000000042004184bf8e620000000049454e44ae426082";
const char ALPHA[] =
    "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a0000000f4944415478da6338"
    "9162f41f88190013dc03bc33870f420000000049454e44ae426082";
const char GREY_16[] =
    "89504e470d0a1a0a0000000d49484452000000010000000110000000006aee47160000000b4944415478da63f8"
    "ff1f00030001ff6f81abb60000000049454e44ae426082";

TEST(PngEncode, GivesAFullScreenToAReaderWithoutLibpng) {
    const TempFolder folder;
    const Image image = crosses(100);
    write_png(folder / "a.png", image);
    folder.put("a.rgb", text(image.rgb));
    EXPECT_EQ(
        output_of("cd " + folder.path().string() +
                  " && /usr/bin/python3 -c '\n"
                  "import struct, zlib\n"
                  "data = open(\"a.png\", \"rb\").read()\n"
                  "assert data[:8] == b\"\\x89PNG\\r\\n\\x1a\\n\"\n"
                  "at, chunks = 8, {}\n"
                  "while at < len(data):\n"
                  "    size, kind = struct.unpack(\">I4s\", data[at:at + 8])\n"
                  "    body = data[at + 8:at + 8 + size]\n"
                  "    assert data[at + 8 + size:at + 12 + size] == "
                  "struct.pack(\">I\", zlib.crc32(kind + body))\n"
                  "    chunks[kind] = chunks.get(kind, b\"\") + body\n"
                  "    at += 12 + size\n"
                  "assert chunks[b\"IHDR\"] == struct.pack(\">IIBBBBB\", 640, 480, 8, 2, 0, 0, 0)\n"
                  "raw = zlib.decompress(chunks[b\"IDAT\"])\n"
                  "rows = [raw[y * 1921:(y + 1) * 1921] for y in range(480)]\n"
                  "assert all(row[0] == 0 for row in rows)\n"
                  "assert b\"\".join(row[1:] for row in rows) == open(\"a.rgb\", \"rb\").read()\n"
                  "print(\"equal\")'"),
        "equal\n");
}

TEST(PngEncode, MakesAScreenOfThinLinesSmall) {
    EXPECT_LT(encode_png(crosses(100)).size(), 40'000u);
}

TEST(PngEncode, RefusesAnImageWhoseBytesDoNotMatchItsSize) {
    EXPECT_THROW(encode_png(Image{2, 2, std::vector<std::uint8_t>(11)}), std::invalid_argument);
    EXPECT_THROW(encode_png(Image{}), std::invalid_argument);
}

TEST(PngDecode, ReadsFilteredRowsOfAnotherWriter) {
    EXPECT_EQ(decode_png(bytes_of_hex(FILTERED_RGB)),
              (Image{2, 2, {255, 0, 0, 0, 255, 0, 0, 2, 3, 0, 255, 255}}));
}

TEST(PngDecode, ReadsPaletteAlphaAndSixteenBits) {
    EXPECT_EQ(decode_png(bytes_of_hex(PALETTE)), (Image{2, 1, {10, 20, 30, 40, 50, 60}}));
    EXPECT_EQ(decode_png(bytes_of_hex(ALPHA)), (Image{2, 1, {200, 100, 50, 0, 0, 0}}));
    EXPECT_EQ(decode_png(bytes_of_hex(GREY_16)), (Image{1, 1, {255, 255, 255}}));
}

TEST(PngDecode, RefusesWhatIsNotAPng) {
    EXPECT_EQ(decode_error(""), "not a PNG");
    EXPECT_EQ(decode_error("GIF89a, and more of it"), "not a PNG");
}

TEST(PngDecode, RefusesAPngThatIsCutShortAnywhere) {
    const std::string whole = text(encode_png(noise(16, 16)));
    ASSERT_EQ(decode_error(whole), "no error");
    for (std::size_t size = 8; size < whole.size(); ++size)
        ASSERT_THAT(decode_error(whole.substr(0, size)), testing::HasSubstr("cut short")) << size;
}

TEST(PngDecode, RefusesAPngWithADamagedByte) {
    const std::string whole = text(encode_png(noise(16, 16)));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        ASSERT_NE(decode_error(damaged), "no error") << at;
    }
}

TEST(PngDecode, RefusesAHugePictureWithoutAllocatingIt) {
    std::string wide = text(encode_png(Image{4097, 1, std::vector<std::uint8_t>(4097 * 3)}));
    EXPECT_EQ(decode_error(wide), "the PNG is too large: 4097 x 1 pixels, at most 4096 x 4096");
    const auto widest = text(encode_png(Image{4096, 1, std::vector<std::uint8_t>(4096 * 3)}));
    EXPECT_EQ(decode_error(widest), "no error");
}

TEST(PngRead, NamesTheFileInItsMessages) {
    const TempFolder folder;
    folder.put("a.png", "hello");
    try {
        read_png(folder / "a.png");
        FAIL();
    } catch (const PngError& error) {
        EXPECT_EQ(error.what(), (folder / "a.png").string() + ": not a PNG");
    }
    EXPECT_THROW(read_png(folder / "b.png"), IoError);
    EXPECT_THROW(read_png(folder.path()), IoError);
}

TEST(PngCompare, CountsPixelsNotBytes) {
    Image a{4, 1, std::vector<std::uint8_t>(12)}, b = a;
    EXPECT_EQ(differing_pixels(a, b), 0u);
    b.rgb[3] = b.rgb[4] = b.rgb[5] = 1;  // one pixel, three bytes
    b.rgb[11] = 255;
    EXPECT_EQ(differing_pixels(a, b), 2u);
}

TEST(PngCompare, ShowsTheDifferencesInRedOnDimmedGrey) {
    const Image a{3, 1, {0, 0, 0, 255, 255, 255, 90, 0, 0}},
        b{3, 1, {0, 0, 1, 255, 255, 255, 90, 0, 0}};
    EXPECT_EQ(difference_image(a, b), (Image{3, 1, {255, 0, 0, 85, 85, 85, 10, 10, 10}}));
}

TEST(PngCompare, RefusesImagesOfDifferentSize) {
    const Image a{2, 1, std::vector<std::uint8_t>(6)}, b{1, 2, std::vector<std::uint8_t>(6)};
    EXPECT_THROW(differing_pixels(a, b), std::invalid_argument);
    EXPECT_THROW(difference_image(a, b), std::invalid_argument);
}

}  // namespace
