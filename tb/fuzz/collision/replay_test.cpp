// replay_test.cpp - the fuzzer's inputs by the ordinary compiler: those kept, and seeded new ones.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "tb/fuzz/collision/world.h"

namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(FuzzedWorlds, KeptAreRefusedOrHandledAlikeByAllAlgorithms) {
    unsigned files = 0;
    for (const auto& entry : std::filesystem::directory_iterator{FUZZ_SEEDS}) {
        SCOPED_TRACE(entry.path());
        std::ifstream file{entry.path(), std::ios::binary};
        const Bytes bytes{std::istreambuf_iterator<char>{file}, {}};
        fuzz::try_world(bytes.data(), bytes.size());
        ++files;
    }
    EXPECT_GT(files, 0u);
}

TEST(FuzzedWorlds, AreHandledAlikeByAllAlgorithms) {
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random{seed};
        Bytes bytes(random() % 1000);
        const unsigned mask = seed % 4 == 0 ? 0xff : seed % 4 == 1 ? 0x1f : 0x0f;
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() & mask);
        fuzz::try_world(bytes.data(), bytes.size());
    }
}

}  // namespace
