// video_in_test.cpp - from the decoder's bytes to pixels in the memory, and the registers.
#include <algorithm>
#include <cmath>

#include "tb/rtl/video_in_bench.h"

namespace {

using namespace regmap;
using namespace tb;
using sim::Image;

constexpr unsigned WIDTH = 320, HEIGHT = 240, WORDS = WIDTH / 2 * HEIGHT;

// 720 x 480, no two neighbours alike.
std::shared_ptr<Image> noise() {
    auto image = std::make_shared<Image>(Image{720, 480, {}});
    std::uint32_t state = 1;
    for (unsigned i = 0; i < 3 * 720 * 480; ++i) {
        state = state * 1664525 + 1013904223;
        image->rgb.push_back(static_cast<std::uint8_t>(state >> 24));
    }
    return image;
}

struct Levels {
    int y, cb, cr;
};

// BT.601 of the pixel that is (x, y) in the picture of a field.
Levels levels(const Image& image, unsigned x, unsigned y, unsigned field) {
    const std::uint8_t* rgb = &image.rgb[3 * ((2 * y + field - 1) * 720 + 40 + 2 * x)];
    const double r = rgb[0] / 255.0, g = rgb[1] / 255.0, b = rgb[2] / 255.0;
    const double light = 0.299 * r + 0.587 * g + 0.114 * b;
    return {static_cast<int>(std::lround(16 + 219 * light)),
            static_cast<int>(std::lround(128 + 224 * (b - light) / 1.772)),
            static_cast<int>(std::lround(128 + 224 * (r - light) / 1.402))};
}

// Whether the bits of a colour are those of `level`, 0 to 255, which may be rounded by half a step.
bool near(double level, unsigned bits, unsigned width) {
    const double step = 256 >> width;
    const double clipped = std::clamp(level, 0.0, 255.0);
    return clipped >= bits * step - 1 && clipped < (bits + 1) * step + 1;
}

testing::AssertionResult is_colour(unsigned pixel, const Levels& l) {
    const double y = 255.0 / 219 * (l.y - 16), cb = (l.cb - 128) / 224.0 * 255,
                 cr = (l.cr - 128) / 224.0 * 255;
    const double r = y + 1.402 * cr, b = y + 1.772 * cb,
                 g = y - (0.299 * 1.402 * cr + 0.114 * 1.772 * cb) / 0.587;
    if (near(r, pixel >> 11, 5) && near(g, pixel >> 5 & 63, 6) && near(b, pixel & 31, 5))
        return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << std::hex << pixel << std::dec << " for " << r << ", " << g << ", " << b;
}

TEST_F(VideoIn, HasItsDocumentedDefaults) {
    EXPECT_EQ(read(VIDEO_IN_BUFFER), 0xC8000000u);
    EXPECT_EQ(read(VIDEO_IN_BACK_BUFFER), 0xC8000000u);
    EXPECT_EQ(read(VIDEO_IN_RESOLUTION), 0x00F00140u);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F00u);
    EXPECT_EQ(read_edges(EDGE_DETECTION_CONTROL), 0u);
}

TEST_F(VideoIn, ReadsWhatWasWrittenInTheBitsThatCanBe) {
    write(VIDEO_IN_STATUS, 0xFFFFFFFF);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F04u);
    write(VIDEO_IN_BACK_BUFFER, 0x00123454);
    EXPECT_EQ(read(VIDEO_IN_BACK_BUFFER), 0xC0123454u);
    edges(true);
    EXPECT_EQ(read_edges(EDGE_DETECTION_CONTROL), 1u);
    EXPECT_EQ(read_edges(EDGE_DETECTION_CONTROL + 4), 0u);
    clock();
    EXPECT_EQ(dut.rdata_o, 0u);
}

TEST_F(VideoIn, WritesNothingUntilItIsEnabled) {
    field(1);
    EXPECT_EQ(writes, 0u);
    EXPECT_FALSE(dut.td_awake_o);
    EXPECT_FALSE(dut.awake_o);
}

TEST_F(VideoIn, ShowsColourBarsInTheirColours) {
    auto bars = std::make_shared<Image>(Image{720, 480, {}});
    for (unsigned i = 0; i < 720 * 480; ++i)
        for (const unsigned bit : {2, 4, 1})
            bars->rgb.push_back((7 - i % 720 / 90) & bit ? 191 : 0);
    chip.show(bars);
    write(VIDEO_IN_STATUS, ENABLE);
    field(1);
    ASSERT_EQ(writes, WORDS);
    for (unsigned y = 0; y < HEIGHT; ++y)
        for (unsigned x = 0; x < WIDTH; ++x)
            ASSERT_TRUE(is_colour(pixel(x, y), levels(*bars, x, y, 1))) << x << ", " << y;
}

TEST_F(VideoIn, TakesEachFieldForAPicture) {
    const auto image = noise();
    chip.show(image);
    write(VIDEO_IN_STATUS, ENABLE);
    for (const unsigned number : {1u, 2u}) {
        written.clear();
        field(number);
        ASSERT_EQ(written.size(), WORDS);
        for (unsigned y = 0; y < HEIGHT; ++y)
            for (unsigned x = 0; x < WIDTH; ++x)
                ASSERT_TRUE(is_colour(pixel(x, y), levels(*image, x, y, number)))
                    << x << ", " << y << " of field " << number;
    }
}

TEST_F(VideoIn, FindsTheEdges) {
    const auto image = noise();
    chip.show(image);
    edges(true);
    write(VIDEO_IN_STATUS, ENABLE);
    for (const unsigned number : {1u, 2u}) {  // a field's first rows know none of the one before
        writes = 0;
        field(number);
        ASSERT_EQ(writes, WORDS);
        for (int y = 0; y < int{HEIGHT}; ++y)
            for (int x = 0; x < int{WIDTH}; ++x) {
                int gx = 0, gy = 0;
                for (int i = -1; i <= 1 && x >= 2 && y >= 2; ++i)
                    for (int j = -1; j <= 1; ++j) {
                        const int light = levels(*image, x - 1 + j, y - 1 + i, number).y;
                        gx += j * (2 - i * i) * light;
                        gy += i * (2 - j * j) * light;
                    }
                const int edge = std::min((std::abs(gx) + std::abs(gy)) / 4, 255);
                ASSERT_TRUE(is_colour(pixel(x, y), {edge, 128, 128}))
                    << x << ", " << y << " of field " << number;
            }
    }
}

TEST_F(VideoIn, KeepsThePictureWhenItIsStopped) {
    chip.show(std::make_shared<Image>(Image{1, 1, {255, 255, 255}}));
    write(VIDEO_IN_STATUS, ENABLE);
    to_line(3);
    lines(100);
    write(VIDEO_IN_STATUS, 0);
    const std::uint64_t before = writes;
    EXPECT_GT(before, 70u * 160);
    lines(100);
    EXPECT_EQ(writes, before);
    EXPECT_FALSE(dut.td_awake_o);
    EXPECT_FALSE(dut.awake_o);
}

// The decoder's clock stands while it is stopped, but not before it has come to rest: what it has
// counted of a field's lines is no longer true when it goes on.
TEST_F(VideoIn, BeginsWithAWholePictureWhereverItWasStopped) {
    for (const unsigned stopped_after : {10u, 100u}) {
        write(VIDEO_IN_STATUS, ENABLE);
        to_line(3);
        lines(stopped_after);
        write(VIDEO_IN_STATUS, 0);
        lines(50);
        to_line(100);
        const std::uint64_t before = writes;
        write(VIDEO_IN_STATUS, ENABLE);
        lines(160);
        EXPECT_EQ(writes, before) << stopped_after;
        lines(270);
        EXPECT_EQ(writes, before + WORDS) << stopped_after;
    }
}

// If the first bytes of a code were kept while it is stopped, what comes when it goes on could
// complete them: a code of the other field, in the middle of this one.
TEST_F(VideoIn, ForgetsTheCodeInWhichItWasStopped) {
    for (unsigned place = 0; place < 40; ++place) {
        write(VIDEO_IN_STATUS, ENABLE);
        to_line(300);
        clock(230 + place);  // the code is 251 to 255 clocks after the line's beginning
        write(VIDEO_IN_STATUS, 0);
        clock(100);
        to_line(100);
        write(VIDEO_IN_STATUS, ENABLE);
        lines(25);
        ASSERT_EQ(writes, 0u) << place;
    }
}

TEST_F(VideoIn, ChangesTheBufferWhenTheNextPictureBegins) {
    write(VIDEO_IN_STATUS, ENABLE);
    write(VIDEO_IN_BACK_BUFFER, 0xC1000000);
    to_line(3);
    lines(100);
    write(VIDEO_IN_BUFFER, 0x12345678);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F05u);
    EXPECT_EQ(read(VIDEO_IN_BUFFER), 0xC8000000u);
    lines(161);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F05u) << "the picture is whole, the next is to come";
    EXPECT_EQ(written.size(), WORDS);
    written.clear();
    field(2);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F04u);
    EXPECT_EQ(read(VIDEO_IN_BUFFER), 0xC1000000u);
    EXPECT_EQ(read(VIDEO_IN_BACK_BUFFER), 0xC8000000u);
    EXPECT_EQ(written.size(), WORDS);
    EXPECT_EQ(written.begin()->first, 0xC1000000u);
    EXPECT_EQ(written.rbegin()->first, 0xC1000000u + (239 << 10) + 159 * 4);
}

TEST_F(VideoIn, WritesTheFirstPictureToTheRequestedBuffer) {
    write(VIDEO_IN_BACK_BUFFER, 0xC1000000);
    write(VIDEO_IN_BUFFER, 1);
    field(1);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F01u) << "nothing comes in";
    write(VIDEO_IN_STATUS, ENABLE);
    field(2);
    EXPECT_EQ(read(VIDEO_IN_STATUS), 0x08090F04u);
    EXPECT_EQ(written.size(), WORDS);
    EXPECT_EQ(written.begin()->first, 0xC1000000u);
}

TEST_F(VideoIn, LosesNothingWhileTheMemoryIsBusy) {
    const auto image = noise();
    chip.show(image);
    busy_for = 900, every = 1600;
    write(VIDEO_IN_STATUS, ENABLE);
    field(1);
    ASSERT_EQ(writes, WORDS);
    for (unsigned x = 0; x < WIDTH; ++x)
        ASSERT_TRUE(is_colour(pixel(x, 200), levels(*image, x, 200, 1))) << x;
}

TEST_F(VideoIn, TakesNoCodeWithAWrongBit) {
    write(VIDEO_IN_STATUS, ENABLE);
    for (damaged_byte = 0; damaged_byte < 4; ++damaged_byte)
        for (unsigned bit = 0; bit < 8; ++bit) {
            damage = static_cast<std::uint8_t>(1 << bit);
            to_line(3);
            lines(40);
            ASSERT_EQ(writes, 0u) << "byte " << damaged_byte << ", bit " << bit;
        }
}

}  // namespace
