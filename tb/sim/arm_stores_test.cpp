// Stores to Normal memory on the bridge are merged, and stay in order, by arm/stores.S.
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using namespace tb::arm;
using ::testing::ElementsAre;
using ::testing::Pair;

class Stores : public tb::ArmTest {
protected:
    // Where they began and how long they were.
    std::vector<std::pair<unsigned, std::size_t>> bursts() const {
        std::vector<std::pair<unsigned, std::size_t>> all;
        for (const auto& store : system->bridge.stores)
            all.emplace_back(store.offset, store.bytes.size());
        return all;
    }
    std::vector<std::uint8_t> bytes() const {
        std::vector<std::uint8_t> all;
        for (const auto& store : system->bridge.stores)
            all.insert(all.end(), store.bytes.begin(), store.bytes.end());
        return all;
    }
};

TEST_F(Stores, InARowGoAsBurstsOfSixteenWords) {
    run_to_end("test_stores_in_a_row");
    EXPECT_THAT(bursts(),
                ElementsAre(Pair(0x28, 4), Pair(0x2C, 20), Pair(0x40, 64), Pair(0x80, 32)));
    std::vector<std::uint8_t> words;
    for (std::uint8_t i = 1; i <= 30; ++i) words.insert(words.end(), {i, 0, 0, 0});
    EXPECT_EQ(bytes(), words);
}

TEST_F(Stores, OfAllSizesAreJoined) {
    run_to_end("test_stores_of_all_sizes");
    EXPECT_THAT(bursts(), ElementsAre(Pair(0, 4), Pair(4, 28)));
    const std::vector<std::uint8_t> all = bytes();
    EXPECT_THAT((std::vector<std::uint8_t>{all.begin() + 4, all.begin() + 9}),
                ElementsAre(0x44, 0x44, 0x44, 0x33, 0x55));
}

TEST_F(Stores, StayInTheProgramsOrder) {
    run_to_end("test_stores_in_order");
    EXPECT_THAT(bursts(), ElementsAre(Pair(0, 4), Pair(4, 8), Pair(0x100, 8), Pair(12, 4),
                                      Pair(16, 4), Pair(20, 4)));
    ASSERT_EQ(system->probe.writes.size(), 1u);
    EXPECT_GT(system->probe.writes[0].second, system->bridge.stores[2].at);
    EXPECT_LT(system->probe.writes[0].second, system->bridge.stores[3].at);
}

TEST_F(Stores, ToDeviceMemoryGoOneByOne) {
    run_to_end("test_stores_to_a_device");
    EXPECT_THAT(bursts(), ElementsAre(Pair(0x100000, 4), Pair(0x100004, 4), Pair(0x100008, 4),
                                      Pair(0x10000C, 4)));
}

TEST_F(Stores, WithTheMmuOffGoOneByOne) {
    run_to_end("test_stores_with_the_mmu_off");
    EXPECT_THAT(bursts(), ElementsAre(Pair(0, 4), Pair(4, 4), Pair(8, 4), Pair(12, 4)));
}

TEST_F(Stores, ThatNobodyAnswersAreAbortedWhereTheyAre) {
    load("test_stores_to_nobody");
    run_ms(5);
    EXPECT_THAT(bursts(), ElementsAre(Pair(0x7FF0, 4), Pair(0x7FF4, 12)));
    EXPECT_EQ(record().vector, 4u);
    EXPECT_EQ(record().address, 0xC0008000u);
    EXPECT_EQ(record().link, address_of("fill") + 4 + 8);
}

TEST_F(Stores, ArriveThoughTheProgramOnlyComputesAfterThem) {
    load("test_stores_and_computes");
    run_ms(1);
    ASSERT_THAT(bursts(), ElementsAre(Pair(0, 4), Pair(4, 4)));
    const auto& stores = system->bridge.stores;
    EXPECT_LE(stores[1].at - stores[0].at, sc_core::sc_time(100.2, sc_core::SC_US));
}

}  // namespace
