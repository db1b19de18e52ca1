// agenda_test.cpp - what the board will do, in the order of time
#include "sim/pins/agenda.h"

#include <gmock/gmock.h>

#include <vector>

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class AgendaTest : public ::testing::Test {
protected:
    sim::Agenda agenda;
    std::vector<std::uint64_t> times;  // at which something was done

    sim::Agenda::Action note() {
        return [this] { times.push_back(agenda.now_ps()); };
    }
};

TEST_F(AgendaTest, CarriesOutEntriesInTheOrderOfTheirTimes) {
    for (const std::uint64_t time : {30, 10, 20, 40}) agenda.at(time, note());
    EXPECT_EQ(agenda.next_ps(), 10u);
    agenda.run_to(30);
    EXPECT_THAT(times, ElementsAre(10, 20, 30));
    EXPECT_EQ(agenda.next_ps(), 40u);
}

TEST_F(AgendaTest, RunsEntriesOfOneTimeInTheirOrder) {
    std::vector<int> order;
    for (int n = 0; n < 3; ++n) agenda.at(10, [&order, n] { order.push_back(n); });
    agenda.run_to(10);
    EXPECT_THAT(order, ElementsAre(0, 1, 2));
}

TEST_F(AgendaTest, CarriesOutWhatAnEntryEntersIfItIsDue) {
    agenda.at(10, [this] {
        agenda.at(20, note());
        agenda.at(21, note());
    });
    agenda.run_to(20);
    EXPECT_THAT(times, ElementsAre(20));
}

TEST_F(AgendaTest, RunsLateEntriesAtOnceAndKeepsTheTime) {
    agenda.run_to(100);
    agenda.at(50, note());
    agenda.run_to(100);
    EXPECT_THAT(times, ElementsAre(100));
}

TEST_F(AgendaTest, NotifiesOfEachOtherNextTime) {
    std::vector<std::uint64_t> reported;
    agenda.on_next([&](std::uint64_t next_ps) { reported.push_back(next_ps); });
    agenda.at(20, note());
    const auto entry = agenda.at(10, note());
    agenda.at(15, note());
    agenda.cancel(entry);
    agenda.run_to(15);
    constexpr auto never = sim::Agenda::NEVER;
    EXPECT_THAT(reported, ElementsAre(never, 20, 10, 15, 20));
}

TEST_F(AgendaTest, FiresATimerOnceAtTheLastTimeSet) {
    sim::PartTimer timer{agenda, note()};
    timer.set(10);
    timer.set(30);
    timer.set(20);
    agenda.run_to(100);
    EXPECT_THAT(times, ElementsAre(20));
    EXPECT_FALSE(timer.is_set());
}

TEST_F(AgendaTest, TimersThatAreCancelledOrGoneDoNothing) {
    {
        sim::PartTimer gone{agenda, note()};
        gone.set(10);
    }
    sim::PartTimer cancelled{agenda, note()};
    cancelled.set(10);
    cancelled.cancel();
    agenda.run_to(100);
    EXPECT_THAT(times, IsEmpty());
    EXPECT_EQ(agenda.next_ps(), sim::Agenda::NEVER);
}

TEST_F(AgendaTest, TimersMayBeSetAnewWhenTheyGoOff) {
    sim::PartTimer timer{agenda, [&] {
                             times.push_back(agenda.now_ps());
                             if (times.size() < 3) timer.set_in(10);
                         }};
    timer.set(10);
    agenda.run_to(100);
    EXPECT_THAT(times, ElementsAre(10, 20, 30));
}

}  // namespace
