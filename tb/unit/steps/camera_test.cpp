// camera_test.cpp - show-picture
#include "tb/support/temp_folder.h"
#include "tb/unit/scenario_errors.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::EndsWith;

class CameraSteps : public StepTest {
protected:
    const TempFolder files;

    sim::Scenario load(const std::string& step) {
        files.put("run.yaml", "name: a\nversion: 1\nsteps:\n- " + step);
        return sim::load_scenario(files / "run.yaml");
    }
};

TEST_F(CameraSteps, ShowAPictureBesideTheScenario) {
    sim::write_png(files / "a.png", {3, 2, std::vector<std::uint8_t>(18, 7)});
    // The luma of a pixel in the middle of the first field.
    const auto luma = [this] {
        return board.decoder.data(100 * sim::Adv7180::LINE_CLOCKS + 276 + 701);
    };
    const unsigned without_camera = luma();
    for (const char* step : {"show-picture: a.png", "show-picture: {file: a.png}"}) {
        board.decoder.show(nullptr);
        board.decoder.data(0);
        EXPECT_EQ(luma(), without_camera);
        load(step).steps.at(0).step->play(board);
        board.decoder.data(0);
        EXPECT_EQ(luma(), 22) << "nearly black";
    }
    EXPECT_EQ(said("show-picture: b/a.png"), "show the camera a.png");
}

TEST_F(CameraSteps, RefuseAFileThatIsNoPicture) {
    files.put("b.png", "words");
    try {
        load("show-picture: b.png");
        FAIL();
    } catch (const sim::ScenarioError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("run.yaml:4:3: expected a picture, got " +
                                                     (files / "b.png").string()));
    }
}

}  // namespace
