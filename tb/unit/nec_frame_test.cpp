// nec_frame.h: the frame of a button, against the protocol's times.
#include <gtest/gtest.h>

#include <numeric>

#include "sim/board/nec_frame.h"

namespace {

// The bits of a frame, the first one lowest.
std::uint32_t bits_of(const std::vector<std::uint32_t>& times) {
    std::uint32_t word = 0;
    for (std::size_t bit = 0; bit < 32; ++bit) {
        EXPECT_EQ(times.at(2 + 2 * bit), 562'500u);
        const std::uint32_t dark = times.at(3 + 2 * bit);
        EXPECT_TRUE(dark == 562'500 || dark == 1'687'500) << dark;
        if (dark > 1'000'000) word |= 1u << bit;
    }
    return word;
}

TEST(NecFrame, HasALead32BitsAndAnEnd) {
    const auto times = sim::nec_frame(0x05);
    ASSERT_EQ(times.size(), 67u);
    EXPECT_EQ(times[0], 9'000'000u);
    EXPECT_EQ(times[1], 4'500'000u);
    EXPECT_EQ(times[66], 562'500u);
}

TEST(NecFrame, SendsCustomCodeKeyCodeAndItsInverse) {
    EXPECT_EQ(bits_of(sim::nec_frame(0x05)), 0xfa056b86u);
    EXPECT_EQ(bits_of(sim::nec_frame(0x1a)), 0xe51a6b86u);
}

TEST(NecFrame, EndsBeforeTheNextForEveryButton) {
    for (const std::string& name : sim::remote_buttons()) {
        const auto times = sim::nec_frame(sim::remote_button(name).value());
        EXPECT_LT(std::accumulate(times.begin(), times.end(), 0ull), 108'000'000ull) << name;
    }
}

TEST(NecFrame, KnowsItsButtonsAndNoOthers) {
    EXPECT_EQ(sim::remote_buttons().size(), 24u);
    EXPECT_EQ(sim::remote_button("mute"), 0x0C);
    EXPECT_EQ(sim::remote_button("Mute"), std::nullopt);
    EXPECT_EQ(sim::remote_button(""), std::nullopt);
}

}  // namespace
