// The WM8731 model in each serial format: frames written down from the datasheet's figures.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tb/unit/wm8731_bench.h"

namespace {

using namespace tb;
using ::testing::IsEmpty;

struct Format {
    const char* name;
    unsigned r7;
    unsigned bits;
    bool left_level;  // of LRCK; DSP: unused
    // The bits of one frame, left and right of `bits` each, with 8 BCLKs to spare in a slot.
    std::function<std::string(const std::string& left, const std::string& right)> frame;
};

const std::string SPARE(8, '0'), SPARE7(7, '0');

std::string i2s(const std::string& l, const std::string& r) {
    return "0" + l + SPARE7 + "0" + r + SPARE7;
}
std::string left_justified(const std::string& l, const std::string& r) {
    return l + SPARE + r + SPARE;
}
std::string right_justified(const std::string& l, const std::string& r) {
    return SPARE + l + SPARE + r;
}
std::string dsp_a(const std::string& l, const std::string& r) {
    return "0" + l + r + SPARE + SPARE7;
}
std::string dsp_b(const std::string& l, const std::string& r) { return l + r + SPARE + SPARE; }

const Format FORMATS[] = {
    {"I2s16", I2S | BITS16, 16, false, i2s},
    {"I2s20", I2S | BITS20, 20, false, i2s},
    {"I2s24", I2S | BITS24, 24, false, i2s},
    {"I2s32", I2S | BITS32, 32, false, i2s},
    {"I2s24Lrp", I2S | BITS24 | LRP, 24, true, i2s},
    {"I2s24BclkInverted", I2S | BITS24 | BCLKINV, 24, false, i2s},
    {"Left16", LEFT | BITS16, 16, true, left_justified},
    {"Left20", LEFT | BITS20, 20, true, left_justified},
    {"Left24", LEFT | BITS24, 24, true, left_justified},
    {"Left32", LEFT | BITS32, 32, true, left_justified},
    {"Left24Lrp", LEFT | BITS24 | LRP, 24, false, left_justified},
    {"Left24BclkInverted", LEFT | BITS24 | BCLKINV, 24, true, left_justified},
    {"Right16", RIGHT | BITS16, 16, true, right_justified},
    {"Right20", RIGHT | BITS20, 20, true, right_justified},
    {"Right24", RIGHT | BITS24, 24, true, right_justified},
    {"Right32IsRight24", RIGHT | BITS32, 24, true, right_justified},
    {"Right24Lrp", RIGHT | BITS24 | LRP, 24, false, right_justified},
    {"DspA16", DSP | BITS16 | LRP, 16, true, dsp_a},
    {"DspA24", DSP | BITS24 | LRP, 24, true, dsp_a},
    {"DspA32", DSP | BITS32 | LRP, 32, true, dsp_a},
    {"DspB16", DSP | BITS16, 16, true, dsp_b},
    {"DspB20", DSP | BITS20, 20, true, dsp_b},
    {"DspB24BclkInverted", DSP | BITS24 | BCLKINV, 24, true, dsp_b},
    {"DspB32", DSP | BITS32, 32, true, dsp_b},
};
void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

class Wm8731Format : public Wm8731Bench, public ::testing::WithParamInterface<Format> {
protected:
    // LRCK is one BCLK long in the DSP modes, else half a frame.
    void frame(const std::string& bits) {
        const bool inverted = (GetParam().r7 & BCLKINV) != 0, dsp = (GetParam().r7 & 3) == DSP;
        const std::size_t half = dsp ? 1 : bits.size() / 2;
        slot(GetParam().left_level, bits.substr(0, half), inverted);
        slot(!GetParam().left_level, bits.substr(half), inverted);
    }
    std::uint32_t cut(std::uint32_t sample) const {
        const unsigned kept = std::min(GetParam().bits, 24u);
        return sample & ~0u << (32 - kept);
    }
};

INSTANTIATE_TEST_SUITE_P(All, Wm8731Format, ::testing::ValuesIn(FORMATS),
                         [](const auto& test) { return test.param.name; });

TEST_P(Wm8731Format, HearsWhatTheDatasheetsFigureSends) {
    const Format& f = GetParam();
    set_up(f.r7);
    const std::uint32_t samples[][2] = {{0x80000000, 0x7fffffff}, {0x12345678, 0x9abcdef0},
                                        {0xffffffff, 0x00000000}, {0x00000000, 0xffffffff},
                                        {0xa5a5a5a5, 0x5a5a5a5a}, {0x00000100, 0x00010000}};
    std::vector<Heard> sent;
    frame(f.frame(binary(0, f.bits), binary(0, f.bits)));  // it must see a frame begin
    frame(f.frame(binary(0, f.bits), binary(0, f.bits)));
    heard.clear();
    for (const auto& [left, right] : samples) {
        frame(f.frame(binary(left, f.bits), binary(right, f.bits)));
        sent.push_back({cut(left), cut(right)});
    }
    frame(f.frame(binary(0, f.bits), binary(0, f.bits)));
    frame(f.frame(binary(0, f.bits), binary(0, f.bits)));
    heard.erase(heard.begin());  // the zeros before
    heard.resize(sent.size());
    EXPECT_EQ(heard, sent);
    EXPECT_THAT(chip.errors(), IsEmpty());
}

TEST_P(Wm8731Format, SendsTheLineInAsTheDatasheetsFigureShows) {
    const Format& f = GetParam();
    set_up(f.r7);
    const std::string zeros = f.frame(binary(0, f.bits), binary(0, f.bits));
    for (int i = 0; i < 3; ++i) frame(zeros);
    for (const auto& [left, right] : {std::pair{0x12345678u, 0x9abcdef0u},
                                      {0x80000000u, 0x7fffff00u},
                                      {0xffffffffu, 0x00000000u}}) {
        line_in = {static_cast<std::int32_t>(left), static_cast<std::int32_t>(right)};
        adc_bits.clear();
        asked = 0;
        frame(zeros);
        EXPECT_EQ(adc_bits, f.frame(binary(cut(left), f.bits), binary(cut(right), f.bits)));
        EXPECT_EQ(asked, 1u);
    }
}

TEST_P(Wm8731Format, CountsASampleAFrameWhateverTheState) {
    const Format& f = GetParam();
    const std::string zeros = f.frame(binary(0, f.bits), binary(0, f.bits));
    set(7, f.r7);  // neither powered nor active
    for (int i = 0; i < 10; ++i) frame(zeros);
    const std::uint64_t before = chip.samples();
    EXPECT_GE(before, 8u);
    for (int i = 0; i < 10; ++i) frame(zeros);
    EXPECT_EQ(chip.samples(), before + 10);
    EXPECT_EQ(heard.size(), chip.samples());
}

}  // namespace
