// open_test.cpp - the chip as nextpnr-mistral would make it: no PLL, no processor, but a picture.
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "Vde1_soc_top.h"
#include "tb/support/random_registers.h"

namespace {

class OpenBitstream : public ::testing::Test {
protected:
    static void SetUpTestSuite() { tb::start_with_random_registers(); }

    // The shown pixels of the next whole frame, 0x00RRGGBB; as the ADV7123 takes them, at the
    // rising edge of VGA_CLK.
    std::vector<std::uint32_t> next_frame() {
        std::vector<std::uint32_t> pixels;
        bool begun = false, clk = false, vs = true;
        for (int half = 0; half < 4 * 2 * 525 * 800; ++half) {
            dut.CLOCK_50 = half & 1;
            dut.eval();
            const bool rises = dut.VGA_CLK && !clk;
            clk = dut.VGA_CLK;
            if (!rises) continue;
            if (vs && !dut.VGA_VS) {
                if (begun) return pixels;
                begun = true;
            }
            vs = dut.VGA_VS;
            if (begun && dut.VGA_BLANK_N)
                pixels.push_back(
                    static_cast<std::uint32_t>(dut.VGA_R << 16 | dut.VGA_G << 8 | dut.VGA_B));
        }
        return {};
    }

    Vde1_soc_top dut;
};

// The order of the EBU's colour bars.
TEST_F(OpenBitstream, ShowsColourBars) {
    const std::uint32_t bars[] = {0xFFFFFF, 0xFFFF00, 0x00FFFF, 0x00FF00,
                                  0xFF00FF, 0xFF0000, 0x0000FF, 0x000000};
    for (int frame = 0; frame < 3; ++frame) (void)next_frame();  // painting takes longer than one
    const std::vector<std::uint32_t> pixels = next_frame();
    ASSERT_EQ(pixels.size(), 640u * 480);
    for (unsigned y = 0; y < 480; ++y)
        for (unsigned x = 0; x < 640; ++x)
            ASSERT_EQ(pixels[y * 640 + x], bars[x / 80]) << "at " << x << ", " << y;
}

}  // namespace
