// header_test.cpp - one wire with every pair of drivers, and all 36 wires.
#include "sim/board/header.h"

#include <gtest/gtest.h>

namespace {

using sim::Header;
using sim::PinLevel;

TEST(Header, IsLowWhereAnybodyPullsLowAndElseHigh) {
    for (const bool enabled : {false, true})
        for (const bool fpga : {false, true})
            for (const PinLevel outside : {PinLevel::LOW, PinLevel::HIGH, PinLevel::RELEASED}) {
                Header header;
                header.fpga(fpga ? 1 : 0, enabled ? 1 : 0);
                header.hand(1, outside);
                const bool low = (enabled && !fpga) || outside == PinLevel::LOW;
                EXPECT_EQ(header.levels(), low ? 0xffffffffe : 0xfffffffff);
                EXPECT_EQ(header.driven(), enabled || outside != PinLevel::RELEASED ? 1u : 0u);
            }
}

TEST(Header, RemembersEachWireUntilTheNextCall) {
    Header header;
    header.hand(0xff, PinLevel::LOW);
    header.hand(0x0f, PinLevel::HIGH);
    header.hand(0x800000000, PinLevel::LOW);
    EXPECT_EQ(header.levels(), 0x7ffffff0fu);
    EXPECT_EQ(header.driven(), 0x8000000ffu);
    header.fpga(0, 0x100);
    header.hand(0xff, PinLevel::RELEASED);
    EXPECT_EQ(header.levels(), 0x7fffffeffu);
    EXPECT_EQ(header.driven(), 0x800000100u);
    header.fpga(0, 0);
    EXPECT_EQ(header.levels(), 0x7ffffffffu);
}

}  // namespace
