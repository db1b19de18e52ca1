// ps2_keyboard_test.cpp - the keyboard at the Verilog port: IBM's commands, Microsoft's scan codes.
#include "tb/sim/ps2_bench.h"

#include "sim/board/ps2_keyboard.h"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint16_t A = 0x1C, LEFT = 0xE06B;

class KeyboardModel : public tb::Ps2Bench<sim::Ps2Keyboard> {
protected:
    Bytes repeats(unsigned count) { return Bytes(count, A); }
};

TEST_F(KeyboardModel, PassesItsTestHalfASecondAfterPowerOn) {
    EXPECT_THAT(within_ms(500), IsEmpty());
    EXPECT_THAT(within_ms(2), ElementsAre(0xAA));
}

TEST_F(KeyboardModel, SendsMakeAndBreakCodes) {
    power_on();
    device.press(A);
    EXPECT_THAT(within_ms(5), ElementsAre(0x1C));
    device.release(A);
    EXPECT_THAT(within_ms(5), ElementsAre(0xF0, 0x1C));
    device.press(LEFT);
    EXPECT_THAT(within_ms(5), ElementsAre(0xE0, 0x6B));
    device.release(LEFT);
    EXPECT_THAT(within_ms(5), ElementsAre(0xE0, 0xF0, 0x6B));
}

TEST_F(KeyboardModel, RepeatsAfter500MillisecondsTenPointNineTimesASecond) {
    power_on();
    device.press(LEFT);
    EXPECT_THAT(within_ms(500), ElementsAre(0xE0, 0x6B));
    EXPECT_THAT(within_ms(5), ElementsAre(0xE0, 0x6B));
    EXPECT_EQ(within_ms(1000).size(), 2 * 10u);  // 11 periods are 1008 ms
    device.release(LEFT);
    EXPECT_THAT(within_ms(500), ElementsAre(0xE0, 0xF0, 0x6B));
}

TEST_F(KeyboardModel, RepeatsTheLastKeyUntilItsRelease) {
    power_on();
    device.press(A);
    run_ms(100);
    device.press(LEFT);
    received();
    EXPECT_THAT(within_ms(505), ElementsAre(0xE0, 0x6B, 0xE0, 0x6B));
    device.release(A);
    EXPECT_THAT(within_ms(95), ElementsAre(0xF0, 0x1C, 0xE0, 0x6B));
    device.release(LEFT);
    run_ms(5);
    received();
    EXPECT_THAT(within_ms(700), IsEmpty());
}

TEST_F(KeyboardModel, RepeatsAsTheHostHasAsked) {
    power_on();
    EXPECT_THAT(answers({0xF3, 0x00}), ElementsAre(0xFA, 0xFA));  // 250 ms, 30 per second
    device.press(A);
    EXPECT_EQ(within_ms(250), repeats(1));
    EXPECT_EQ(within_ms(1004), repeats(31));
    device.release(A);
    EXPECT_THAT(within_ms(5), ElementsAre(0xF0, 0x1C));
    EXPECT_THAT(answers({0xF3, 0x7F}), ElementsAre(0xFA, 0xFA));  // 1 s, 2 per second
    device.press(A);
    EXPECT_EQ(within_ms(1000), repeats(1));
    EXPECT_EQ(within_ms(1005), repeats(3));
    device.release(A);
    EXPECT_THAT(answers({0xF6}), ElementsAre(0xFA));
    device.press(A);
    EXPECT_EQ(within_ms(505), repeats(2));
}

TEST_F(KeyboardModel, NeitherBreaksNorRepeatsPause) {
    power_on();
    device.press(0xE177);
    EXPECT_THAT(within_ms(700), ElementsAre(0xE1, 0x14, 0x77, 0xE1, 0xF0, 0x14, 0xF0, 0x77));
    device.release(0xE177);
    EXPECT_THAT(within_ms(20), IsEmpty());
}

TEST_F(KeyboardModel, TypesKeysOfItsTestAfterwards) {
    device.type("aB");
    device.press(LEFT);
    run_ms(300);
    device.release(LEFT);
    EXPECT_THAT(within_ms(290), ElementsAre(0xAA, 0xE0, 0x6B, 0xE0, 0xF0, 0x6B, 0x1C, 0xF0, 0x1C,
                                            0x12, 0x32, 0xF0, 0x32, 0xF0, 0x12));
    EXPECT_THAT(answers({0xFF}), ElementsAre(0xFA));
    device.type("z");
    EXPECT_THAT(within_ms(530), ElementsAre(0xAA, 0x1A, 0xF0, 0x1A));
}

TEST_F(KeyboardModel, AnswersTheCommandsThatProgramsUse) {
    power_on();
    EXPECT_THAT(answers({0xED, 0x05}), ElementsAre(0xFA, 0xFA));
    EXPECT_EQ(device.lamps(), 5);
    EXPECT_THAT(answers({0xEE}), ElementsAre(0xEE));
    EXPECT_THAT(answers({0xFE}), ElementsAre(0xEE));
    EXPECT_THAT(answers({0xF0, 0x00}), ElementsAre(0xFA, 0xFA, 0x02));
    EXPECT_THAT(answers({0xF0, 0x02}), ElementsAre(0xFA, 0xFA));
    EXPECT_THAT(answers({0xF0, 0x03}), ElementsAre(0xFA, 0xFE));
    EXPECT_THAT(answers({0xF2}), ElementsAre(0xFA, 0xAB, 0x83));
    EXPECT_THAT(answers({0xE8}), ElementsAre(0xFE));
    EXPECT_THAT(answers({0xED, 0xF4}), ElementsAre(0xFA, 0xFA));  // a command, not lamps
    EXPECT_EQ(device.lamps(), 5);
    EXPECT_THAT(answers({0xFF}), ElementsAre(0xFA));
    EXPECT_THAT(within_ms(500), ElementsAre(0xAA));
    EXPECT_EQ(device.lamps(), 0);
}

TEST_F(KeyboardModel, SendsNothingWhileItIsOff) {
    power_on();
    EXPECT_THAT(answers({0xF5}), ElementsAre(0xFA));
    device.press(A);
    EXPECT_THAT(within_ms(700), IsEmpty());
    device.release(A);
    EXPECT_THAT(within_ms(5), IsEmpty());
    EXPECT_THAT(answers({0xF4}), ElementsAre(0xFA));
    device.type("a");
    EXPECT_THAT(within_ms(45), ElementsAre(0x1C, 0xF0, 0x1C));
}

TEST_F(KeyboardModel, LetsKeysWaitBetweenACommandAndItsSecondByte) {
    power_on();
    write(DATA, 0xED);
    run_ms(2);
    device.press(A);
    EXPECT_THAT(within_ms(5), ElementsAre(0xFA));
    EXPECT_THAT(answers({0x02}), ElementsAre(0xFA, 0x1C));
}

TEST_F(KeyboardModel, DropsRepeatsWhileTheHostInhibits) {
    power_on();
    device.host(true, false);
    device.press(A);
    run_ms(2000);
    device.host(false, false);
    EXPECT_EQ(within_ms(50), repeats(1));
}

TEST_F(KeyboardModel, IgnoresARequestWithoutALowClock) {
    power_on();
    const auto takes_after_us = [this](double held) {
        if (held > 0) {
            device.host(true, false);
            run_ms(held / 1000);
            device.host(true, true);
        }
        device.host(false, true);
        bool clocks_it_in = false;
        for (int i = 0; i < 1000; ++i, clock()) clocks_it_in |= device.clk_low();
        device.host(false, false);
        run_ms(5);
        return clocks_it_in;
    };
    EXPECT_FALSE(takes_after_us(0));
    EXPECT_FALSE(takes_after_us(20));
    EXPECT_TRUE(takes_after_us(60));
    EXPECT_FALSE(takes_after_us(0)) << "the hold was the other byte's";
    EXPECT_TRUE(takes_after_us(120));
    EXPECT_FALSE(takes_after_us(20));
}

TEST_F(KeyboardModel, TakesNoByteDuringItsTest) {
    run_ms(100);
    write(DATA, 0xF4);
    run_ms(20);
    EXPECT_TRUE(read(CONTROL) & ERROR);
}

}  // namespace
