// remote.cpp - press-remote: the infrared remote control
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>

#include "sim/board/nec_frame.h"
#include "sim/board/remote_control.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

Reading read_button(const YamlNode& node) {
    if (!remote_button(node.text)) return std::nullopt;
    return node.text;
}

const ValueType& button_type() {
    static const ValueType TYPE = [] {
        const std::vector<std::string> names = remote_buttons();
        std::vector<std::string> choices;
        for (const std::string& name : names) {
            choices.push_back('"' + name + '"');
            if (std::isdigit(name[0])) choices.push_back(name);
        }
        return ValueType{"a button of the remote control",
                         fmt::format(R"({{"enum": [{}]}})", fmt::join(choices, ", ")), read_button,
                         "", names};
    }();
    return TYPE;
}

class PressRemote : public Action {
public:
    explicit PressRemote(const Values& v) : button_{v.get<std::string>("button")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("IRDA_RXD", "the infrared receiver");
    }
    std::string describe() const override { return "press " + button_ + " on the remote control"; }
    void act(BoardControl& board) const override {
        auto& remote = board.part<RemoteControl>("remote control");
        board.act([&remote, code = remote_button(button_).value()] { remote.press(code); });
    }

private:
    std::string button_;
};

}  // namespace

namespace steps {

std::vector<StepForm> remote() {
    return {
        {"press-remote",
         "Press a button of the infrared remote control and go on; from one button to the next it "
         "takes 108 ms.",
         Notation::BARE,
         {},
         {{"button", button_type(), Need::REQUIRED, "",
           "0 to 9, a, b, c, power, menu, return, play, adjust-left, adjust-right, mute, "
           "channel-up, channel-down, volume-up, volume-down."}},
         make<PressRemote>},
    };
}

}  // namespace steps

}  // namespace sim
