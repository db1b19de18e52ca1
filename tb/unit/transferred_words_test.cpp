// The words that an instruction loads or stores one after the other.
#include "sim/cpu/transferred_words.h"

#include <gtest/gtest.h>

namespace {

using sim::is_exclusive;
using sim::transferred_words;

TEST(TransferredWords, OfArm) {
    EXPECT_EQ(transferred_words(0xE89001FE, false), 8u) << "ldm r0, {r1-r8}";
    EXPECT_EQ(transferred_words(0xE9204022, false), 3u) << "stmdb r0!, {r1, r5, lr}";
    EXPECT_EQ(transferred_words(0xE8BD8010, false), 2u) << "pop {r4, pc}";
    EXPECT_EQ(transferred_words(0xE1C020D0, false), 2u) << "ldrd r2, r3, [r0]";
    EXPECT_EQ(transferred_words(0xE18020F1, false), 2u) << "strd r2, r3, [r0, r1]";
    EXPECT_EQ(transferred_words(0xE1B02F9F, false), 2u) << "ldrexd r2, r3, [r0]";
    for (const std::uint32_t one :
         {0xE5901000, 0xE1C010B0, 0xE1D010F0, 0xE1D010D0, 0xE1001092, 0xE1901F9F, 0xEC510F02})
        EXPECT_EQ(transferred_words(one, false), 1u) << std::hex << one;
}

TEST(TransferredWords, OfVfpAndNeon) {
    EXPECT_EQ(transferred_words(0xEC900B20, false), 32u) << "vldm r0, {d0-d15}";
    EXPECT_EQ(transferred_words(0xED600A03, false), 3u) << "vstmdb r0!, {s1-s3}";
    EXPECT_EQ(transferred_words(0xED903B00, false), 2u) << "vldr d3, [r0]";
    EXPECT_EQ(transferred_words(0xEDD01A00, false), 1u) << "vldr s3, [r0]";
    EXPECT_EQ(transferred_words(0xF420028F, false), 8u) << "vld1.32 {d0-d3}, [r0]";
    EXPECT_EQ(transferred_words(0xF420070F, false), 2u) << "vld1.8 {d0}, [r0]";
    EXPECT_EQ(transferred_words(0xF400088F, false), 4u) << "vst2.32 {d0-d1}, [r0]";
    EXPECT_EQ(transferred_words(0xF420048F, false), 6u) << "vld3.32 {d0-d2}, [r0]";
    EXPECT_EQ(transferred_words(0xF4A00B8F, false), 4u) << "vld4.32 {d0[1]-d3[1]}, [r0]";
    EXPECT_EQ(transferred_words(0xF420080F, false), 1u) << "vld2.8 {d0-d1}, [r0]";
}

TEST(TransferredWords, OfThumb) {
    EXPECT_EQ(transferred_words(0xC80E, true), 3u) << "ldm r0!, {r1-r3}";
    EXPECT_EQ(transferred_words(0xB51E, true), 5u) << "push {r1-r4, lr}";
    EXPECT_EQ(transferred_words(0xBC01, true), 1u) << "pop {r0}";
    EXPECT_EQ(transferred_words(0xE89001FE, true), 8u) << "ldm.w r0, {r1-r8}";
    EXPECT_EQ(transferred_words(0xE92001FE, true), 8u) << "stmdb.w r0!, {r1-r8}";
    EXPECT_EQ(transferred_words(0xE9D02302, true), 2u) << "ldrd r2, r3, [r0, #8]";
    EXPECT_EQ(transferred_words(0xE8E02302, true), 2u) << "strd r2, r3, [r0], #8";
    EXPECT_EQ(transferred_words(0xE8D0237F, true), 2u) << "ldrexd r2, r3, [r0]";
    EXPECT_EQ(transferred_words(0xEC900B04, true), 4u) << "vldm r0, {d0-d1}";
    EXPECT_EQ(transferred_words(0xF9200A8F, true), 4u) << "vld1.32 {d0-d1}, [r0]";
    for (const std::uint32_t one :
         {0x6801u, 0xE7FEu, 0xE8502F00u, 0xE8D0F001u, 0xF8901005u, 0xF8D01005u, 0xE990C000u})
        EXPECT_EQ(transferred_words(one, true), 1u) << std::hex << one;
}

// Encodings as GNU as gives them.
TEST(TransferredWords, AreExclusiveInLdrexAndItsLike) {
    for (const std::uint32_t arm : {0xE1901F9Fu, 0xE1802F91u, 0xE1D01F9Fu, 0xE1C02F91u, 0xE1F01F9Fu,
                                    0xE1E02F91u, 0xE1B02F9Fu, 0xE1A01F92u})
        EXPECT_TRUE(is_exclusive(arm, false)) << std::hex << arm;
    for (const std::uint32_t thumb : {0xE8501F00u, 0xE8401200u, 0xE8D01F4Fu, 0xE8C01F42u,
                                      0xE8D01F5Fu, 0xE8C01F52u, 0xE8D0237Fu, 0xE8C02371u})
        EXPECT_TRUE(is_exclusive(thumb, true)) << std::hex << thumb;
    for (const std::uint32_t arm : {0xE5901000u, 0xE1D010B0u, 0xE1010092u, 0xF57FF01Fu})
        EXPECT_FALSE(is_exclusive(arm, false)) << std::hex << arm;
    for (const std::uint32_t thumb : {0x6801u, 0xE8D0F001u, 0xE9D02302u, 0xE8E02302u})
        EXPECT_FALSE(is_exclusive(thumb, true)) << std::hex << thumb;
}

}  // namespace
