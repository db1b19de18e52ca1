// Stores that wait in the processor to become one burst.
#include "sim/cpu/store_buffer.h"

#include <gtest/gtest.h>

namespace {

using sim::StoreBuffer;

TEST(StoreBuffer, KnowsOnlyThePageThatHasAnswered) {
    StoreBuffer buffer;
    EXPECT_FALSE(buffer.knows_page(0));
    buffer.answered(0xC0001004);
    EXPECT_TRUE(buffer.knows_page(0xC0001FFC));
    EXPECT_FALSE(buffer.knows_page(0xC0002000));
    buffer.forget_page();
    EXPECT_FALSE(buffer.knows_page(0xC0001004));
}

TEST(StoreBuffer, MakesOneBurstOfStoresAtRisingAddresses) {
    StoreBuffer buffer;
    buffer.add(0x38, 2, 0x1234);
    EXPECT_TRUE(buffer.continues(0x3A));
    EXPECT_FALSE(buffer.continues(0x3C));
    EXPECT_FALSE(buffer.is_full());
    buffer.add(0x3A, 2, 0x5678);
    buffer.add(0x3C, 4, 0x9ABCDEF0);
    EXPECT_TRUE(buffer.is_full());
    const StoreBuffer::Burst burst = buffer.remove();
    EXPECT_EQ(burst.address, 0x38u);
    ASSERT_EQ(burst.bytes, 8u);
    EXPECT_EQ(burst.data[0], 0x34);
    EXPECT_EQ(burst.data[3], 0x56);
    EXPECT_EQ(burst.data[7], 0x9A);
    EXPECT_TRUE(buffer.is_empty());
    EXPECT_TRUE(buffer.continues(0x1000));
}

}  // namespace
