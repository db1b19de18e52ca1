// picture_test.cpp - wait-frame, expect-frame, take-screenshot
#include "sim/files/png.h"
#include "tb/support/temp_folder.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class PictureSteps : public StepTest {
protected:
    // A frame each 10 ms, every third a new picture.
    void SetUp() override {
        board.meanwhile = [&] {
            if (board.now_ms() % 10 == 0) show_frame(board.now_ms() % 30 == 0);
        };
    }

    const TempFolder files;
    static constexpr std::size_t BYTES = 640 * 480 * 3;

    std::string expect_frame(const std::string& rest = "") {
        const std::string step = "expect-frame: {equals: golden.png" + rest + "}";
        const auto verdict =
            read_step(step, (files / "run.yaml").string()).step->play(board).value();
        return verdict.met ? "met" : verdict.detail;
    }
};

TEST_F(PictureSteps, WaitForAFrameByNumberOrNext) {
    EXPECT_EQ(finds("wait-frame: 2"), "met");
    EXPECT_EQ(board.now_ms(), 20u);
    EXPECT_EQ(finds("wait-frame: 2"), "met");
    EXPECT_EQ(board.now_ms(), 20u);
    EXPECT_EQ(finds("wait-frame: next"), "met");
    EXPECT_EQ(board.now_ms(), 30u);
    EXPECT_EQ(finds("wait-frame: {frame: next-swap}"), "met");
    EXPECT_EQ(board.now_ms(), 60u);
}

TEST_F(PictureSteps, GiveUpAfterTenSecondsUnlessTheySaySo) {
    EXPECT_EQ(finds("wait-frame: {frame: 7, timeout: 65ms}"),
              "6 frames shown, 2 of them new pictures");
    board.meanwhile = [] {};
    EXPECT_NE(finds("wait-frame: next"), "met");
    EXPECT_EQ(board.now_ms(), 10'065u);
}

TEST_F(PictureSteps, CompareWithThePictureBesideTheScenario) {
    sim::write_png(files / "golden.png", {640, 480, std::vector<std::uint8_t>(BYTES, 0x80)});
    show_frame(true, 0x808080);
    EXPECT_EQ(expect_frame(), "met");
    EXPECT_THAT(board.saved, IsEmpty());
}

TEST_F(PictureSteps, KeepWhatDiffers) {
    sim::Image golden{640, 480, std::vector<std::uint8_t>(BYTES)};
    golden.rgb[0] = golden.rgb[300] = 1;
    sim::write_png(files / "golden.png", golden);
    EXPECT_EQ(expect_frame(", differing-pixels: 2"), "met");
    EXPECT_EQ(expect_frame(", differing-pixels: 1"),
              "frame 0: 2 pixels differ; see out/mismatch/line4_golden_actual.png, "
              "out/mismatch/line4_golden_expected.png and "
              "out/mismatch/line4_golden_difference.png");
    ASSERT_EQ(board.saved.size(), 3u);
    EXPECT_EQ(board.saved[1].first, "out/mismatch/line4_golden_expected.png");
    EXPECT_EQ(board.saved[1].second, golden);
    board.disk_full = true;
    EXPECT_EQ(expect_frame(), "frame 0: 2 pixels differ");
}

TEST_F(PictureSteps, IgnoreWhatDiffersInsideARectangle) {
    sim::Image golden{640, 480, std::vector<std::uint8_t>(BYTES)};
    const auto light = [&](unsigned x, unsigned y) { golden.rgb[(y * 640 + x) * 3] = 1; };
    light(100, 50);
    light(109, 54);
    light(639, 479);
    sim::write_png(files / "golden.png", golden);
    EXPECT_EQ(expect_frame(", ignore: [10x5+100+50, 9x9+635+475]"), "met");
    EXPECT_THAT(expect_frame(", ignore: [10x5+100+50, 4x9+635+475]"), StartsWith("frame 0: 1 pix"));
    EXPECT_THAT(expect_frame(", ignore: 10x4+100+50"), StartsWith("frame 0: 2 pixels differ"));
    EXPECT_THAT(expect_frame(", ignore: 9x5+100+50"), StartsWith("frame 0: 2 pixels differ"));
    EXPECT_THAT(expect_frame(", ignore: 9x5+101+50"), StartsWith("frame 0: 2 pixels differ"));
    EXPECT_THAT(expect_frame(", ignore: 9x9+640+480"), StartsWith("frame 0: 3 pixels differ"));
    EXPECT_EQ(said("expect-frame: {equals: a.png, ignore: 9x9+1+2}"),
              "expect the picture a.png, outside 9x9+1+2");
}

TEST_F(PictureSteps, RenewADifferentGoldenOnRequest) {
    sim::write_png(files / "golden.png", {640, 480, std::vector<std::uint8_t>(BYTES, 0x80)});
    board.renews = true;
    const auto verdict =
        play(fmt::format("expect-frame: {{equals: \"{}\"}}", (files / "golden.png").string()));
    EXPECT_TRUE(verdict->met);
    EXPECT_THAT(verdict->detail, StartsWith("renewed: frame 0: 307200 pixels differ; see "));
    EXPECT_THAT(board.done, ElementsAre("renew golden.png"));
    show_frame(true, 0x808080);
    EXPECT_EQ(expect_frame(), "met");
    EXPECT_THAT(board.done, SizeIs(1));
}

TEST_F(PictureSteps, TakeAPictureOfAnySize) {
    sim::write_png(files / "golden.png", {800, 600, std::vector<std::uint8_t>(800 * 600 * 3, 7)});
    board.seen.frame({1, true, std::vector<std::uint32_t>(800 * 600, 0x070707), 800, 600});
    EXPECT_EQ(expect_frame(), "met");
    EXPECT_FALSE(play("take-screenshot: {save-to: a.png}"));
    EXPECT_EQ(board.saved.at(0).second.width, 800u);
}

TEST_F(PictureSteps, ReportBothSizesWhereTheyDiffer) {
    sim::write_png(files / "golden.png", {800, 600, std::vector<std::uint8_t>(800 * 600 * 3)});
    EXPECT_EQ(expect_frame(", differing-pixels: 1310720"),
              "frame 0: 640 x 480 pixels, but golden.png has 800 x 600; see "
              "out/mismatch/line4_golden_actual.png and out/mismatch/line4_golden_expected.png");
    EXPECT_EQ(board.saved.size(), 2u);
    board.disk_full = true;
    EXPECT_EQ(expect_frame(), "frame 0: 640 x 480 pixels, but golden.png has 800 x 600");
}

TEST_F(PictureSteps, AreNotMetWithoutTheirPicture) {
    EXPECT_THAT(expect_frame(), EndsWith("golden.png: is not there"));
}

TEST_F(PictureSteps, TakeAScreenshotIntoTheOutputFolder) {
    EXPECT_FALSE(play("take-screenshot: {save-to: shots/a.b.png}"));
    ASSERT_EQ(board.saved.size(), 1u);
    EXPECT_EQ(board.saved[0].first, "out/shots/a.b.png");
    EXPECT_EQ(board.saved[0].second.rgb, std::vector<std::uint8_t>(BYTES));
}

TEST_F(PictureSteps, DescribeThemselves) {
    EXPECT_EQ(said("wait-frame: 120"), "wait for frame 120 within 10s");
    EXPECT_EQ(said("wait-frame: {frame: next, timeout: 1s}"), "wait for the next frame within 1s");
    EXPECT_EQ(said("wait-frame: next-swap"), "wait for the next new picture within 10s");
    EXPECT_EQ(said("expect-frame: {equals: a/b.png, differing-pixels: 3}"),
              "expect the picture b.png but for 3 pixels");
    EXPECT_EQ(said("take-screenshot: {save-to: a.png}"), "take screenshot a.png");
}

}  // namespace
