// ps2_mouse_test.cpp - the mouse at the Verilog port, as IBM's and Microsoft's documents have it.
#include "tb/sim/ps2_bench.h"

#include "sim/board/ps2_mouse.h"

namespace {

using sim::MouseButton;
using testing::ElementsAre;
using testing::IsEmpty;

class MouseModel : public tb::Ps2Bench<sim::Ps2Mouse> {
protected:
    void stream() {
        power_on();
        ASSERT_THAT(answers({0xF4}), ElementsAre(0xFA));
    }
    // The next packet, which comes within the 10 ms of 100 packets per second.
    Bytes packet() { return within_ms(14); }
};

TEST_F(MouseModel, SendsThatItsTestHasPassedAndWhatItIs) {
    EXPECT_THAT(within_ms(500), IsEmpty());
    EXPECT_THAT(within_ms(4), ElementsAre(0xAA, 0x00));
    EXPECT_THAT(answers({0xF2}), ElementsAre(0xFA, 0x00));
    EXPECT_THAT(answers({0xFF}), ElementsAre(0xFA));
    EXPECT_THAT(within_ms(500), ElementsAre(0xAA, 0x00));
}

TEST_F(MouseModel, IsSilentUntilItIsTurnedOn) {
    power_on();
    device.move(5, 5);
    EXPECT_THAT(packet(), IsEmpty());
    EXPECT_THAT(answers({0xF4}), ElementsAre(0xFA));
    EXPECT_THAT(packet(), IsEmpty());  // what it had counted is forgotten
    device.move(5, 5);
    EXPECT_THAT(packet(), ElementsAre(0x08, 5, 5));
    EXPECT_THAT(answers({0xF5}), ElementsAre(0xFA));
    device.move(5, 5);
    EXPECT_THAT(packet(), IsEmpty());
}

TEST_F(MouseModel, SendsNineBitsEachWay) {
    stream();
    device.move(1, -1);
    EXPECT_THAT(packet(), ElementsAre(0x28, 0x01, 0xFF));
    device.move(-200, 255);
    EXPECT_THAT(packet(), ElementsAre(0x18, 0x38, 0xFF));
    device.move(0, -255);
    EXPECT_THAT(packet(), ElementsAre(0x28, 0x00, 0x01));
    EXPECT_THAT(packet(), IsEmpty());
}

TEST_F(MouseModel, StopsCountingAt255AndFlagsIt) {
    stream();
    device.move(256, -300);
    EXPECT_THAT(packet(), ElementsAre(0x08 | 0x20 | 0x40 | 0x80, 0xFF, 0x01));
    device.move(1, 0);
    EXPECT_THAT(packet(), ElementsAre(0x08, 1, 0));
}

TEST_F(MouseModel, SendsItsButtonsWhenOneMoves) {
    stream();
    device.button(MouseButton::LEFT, true);
    EXPECT_THAT(packet(), ElementsAre(0x09, 0, 0));
    device.button(MouseButton::RIGHT, true);
    EXPECT_THAT(packet(), ElementsAre(0x0B, 0, 0));
    device.button(MouseButton::LEFT, false);
    device.button(MouseButton::MIDDLE, true);
    EXPECT_THAT(packet(), ElementsAre(0x0E, 0, 0));
}

TEST_F(MouseModel, SendsAsManyPacketsASecondAsItsRateSays) {
    stream();
    const auto packets = [&] {
        std::size_t bytes = 0;
        for (int ms = 0; ms < 1000; ++ms) {
            device.move(1, 0);
            run_ms(1);
            if (ms % 50 == 49) bytes += received().size();
        }
        return bytes / 3;
    };
    EXPECT_NEAR(static_cast<double>(packets()), 100, 1);
    EXPECT_THAT(answers({0xF3, 40}), ElementsAre(0xFA, 0xFA));
    EXPECT_NEAR(static_cast<double>(packets()), 40, 1);
    EXPECT_THAT(answers({0xF3, 50}), ElementsAre(0xFA, 0xFE));  // there is no such rate
}

TEST_F(MouseModel, CountsFinerOrCoarserByItsResolution) {
    stream();
    for (const auto& [resolution, counts] : {std::pair{0, 10}, {1, 20}, {2, 40}, {3, 80}}) {
        EXPECT_THAT(answers({0xE8, static_cast<std::uint8_t>(resolution)}),
                    ElementsAre(0xFA, 0xFA));
        for (int i = 0; i < 40; ++i) device.move(1, 0);  // 10 mm
        EXPECT_THAT(packet(), ElementsAre(0x08, counts, 0)) << resolution;
    }
    EXPECT_THAT(answers({0xE8, 4}), ElementsAre(0xFA, 0xFE));
}

TEST_F(MouseModel, ScalesTwoToOneByIbmsTable) {
    stream();
    EXPECT_THAT(answers({0xE7}), ElementsAre(0xFA));
    for (const auto& [counts, sent] :
         {std::pair{0, 0}, {1, 1}, {2, 1}, {3, 3}, {4, 6}, {5, 9}, {6, 12}, {100, 200}}) {
        device.button(MouseButton::LEFT, counts % 2);
        device.move(counts, 0);
        const Bytes bytes = packet();
        ASSERT_EQ(bytes.size(), 3u);
        EXPECT_EQ(bytes[1], sent);
    }
    device.move(-3, 4);
    EXPECT_THAT(packet(), ElementsAre(0x18, 0xFD, 6));
    device.move(4, 0);
    EXPECT_THAT(answers({0xEB}), ElementsAre(0xFA, 0x08, 4, 0));  // a packet asked for is not
    EXPECT_THAT(answers({0xE6}), ElementsAre(0xFA));
    device.move(4, 0);
    EXPECT_THAT(packet(), ElementsAre(0x08, 4, 0));
}

TEST_F(MouseModel, SpeaksOnlyWhenAskedInRemoteMode) {
    stream();
    EXPECT_THAT(answers({0xF0}), ElementsAre(0xFA));
    device.move(7, 0);
    EXPECT_THAT(packet(), IsEmpty());
    EXPECT_THAT(answers({0xEB}), ElementsAre(0xFA, 0x08, 7, 0));
    EXPECT_THAT(answers({0xEB}), ElementsAre(0xFA, 0x08, 0, 0));
    EXPECT_THAT(answers({0xEA}), ElementsAre(0xFA));
    device.move(7, 0);
    EXPECT_THAT(packet(), ElementsAre(0x08, 7, 0));
}

TEST_F(MouseModel, SendsItsStatus) {
    power_on();
    EXPECT_THAT(answers({0xE9}), ElementsAre(0xFA, 0x00, 2, 100));
    answers({0xF4, 0xE7, 0xF0, 0xE8, 3, 0xF3, 20});
    device.button(MouseButton::LEFT, true);
    EXPECT_THAT(answers({0xE9}), ElementsAre(0xFA, 0x74, 3, 20));
    device.button(MouseButton::LEFT, false);
    device.button(MouseButton::RIGHT, true);
    EXPECT_THAT(answers({0xE9}), ElementsAre(0xFA, 0x71, 3, 20));
    EXPECT_THAT(answers({0xF6, 0xE9}), ElementsAre(0xFA, 0xFA, 0x01, 2, 100));
}

TEST_F(MouseModel, HasAWheelWhenAskedBy200And100And80) {
    power_on();
    answers({0xF3, 200, 0xF3, 80, 0xF3, 100});
    EXPECT_THAT(answers({0xF2}), ElementsAre(0xFA, 0x00));
    answers({0xF3, 200, 0xF3, 100, 0xF3, 80});
    EXPECT_THAT(answers({0xF2}), ElementsAre(0xFA, 0x03));
    answers({0xF4});
    device.turn(1);
    EXPECT_THAT(within_ms(20), ElementsAre(0x08, 0, 0, 0x01));
    device.turn(-2);
    device.move(3, 0);
    EXPECT_THAT(within_ms(20), ElementsAre(0x08, 3, 0, 0xFE));
    device.turn(-20);
    EXPECT_THAT(within_ms(20), ElementsAre(0x08, 0, 0, 0xF8));
    answers({0xFF});
    run_ms(510);
    received();
    EXPECT_THAT(answers({0xF2}), ElementsAre(0xFA, 0x00));
}

TEST_F(MouseModel, SendsBackWhatItGetsInWrapMode) {
    stream();
    EXPECT_THAT(answers({0xEE}), ElementsAre(0xFA));
    device.move(1, 1);
    EXPECT_THAT(answers({0xF4, 0x55, 0xFE, 0xEE}), ElementsAre(0xF4, 0x55, 0xFE, 0xEE));
    EXPECT_THAT(answers({0xEC}), ElementsAre(0xFA));
    EXPECT_THAT(answers({0xF2}), ElementsAre(0xFA, 0x00));
}

TEST_F(MouseModel, RefusesAnUnknownCommandWithFeThenFc) {
    power_on();
    EXPECT_THAT(answers({0x12, 0x12, 0xF2, 0x12}), ElementsAre(0xFE, 0xFC, 0xFA, 0x00, 0xFE));
}

TEST_F(MouseModel, SendsItsLastPacketAgain) {
    stream();
    device.move(9, 8);
    EXPECT_THAT(packet(), ElementsAre(0x08, 9, 8));
    EXPECT_THAT(answers({0xFE}), ElementsAre(0x08, 9, 8));
    answers({0xF2});
    EXPECT_THAT(answers({0xFE}), ElementsAre(0xFA, 0x00));
}

}  // namespace
