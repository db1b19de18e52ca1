// camera.cpp - show-picture: what the camera at the video input sees
#include "sim/board/adv7180.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

using namespace value_types;

class ShowPicture : public Action {
public:
    explicit ShowPicture(const Values& v) : file_{v.path("file")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("TD_DATA[0]", "the video decoder");
    }
    std::string describe() const override {
        return "show the camera " + printable(file_.filename().string());
    }
    void load(Goldens) override {
        try {
            picture_ = std::make_shared<Image>(read_png(file_));
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(std::string{"expected a picture, got "} + error.what());
        }
    }
    void act(BoardControl& board) const override {
        auto& decoder = board.part<Adv7180>("video decoder");
        board.act([&decoder, picture = picture_] { decoder.show(picture); });
    }

private:
    std::filesystem::path file_;
    std::shared_ptr<const Image> picture_ = std::make_shared<Image>(Image{1, 1, {0, 0, 0}});
};

}  // namespace

namespace steps {

std::vector<StepForm> camera() {
    return {
        {"show-picture",
         "Show the camera at the video input a picture and go on; before the first one there is no "
         "camera.",
         Notation::BOTH,
         {},
         {{"file", FILE_NAME, Need::REQUIRED, "",
           "A PNG, relative to the scenario file; stretched to 720 x 480, of which programs get "
           "the "
           "middle 640."}},
         make<ShowPicture>},
    };
}

}  // namespace steps

}  // namespace sim
