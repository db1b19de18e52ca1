// keyboard.cpp - type-keys: the PS/2 keyboard
#include <algorithm>

#include "sim/board/scan_codes.h"
#include "sim/scenario/stage.h"
#include "sim/scenario/step_form.h"
#include "sim/scenario/words.h"

namespace sim {

namespace {

class TypeKeys : public Action {
public:
    explicit TypeKeys(const Values& v) : text_{v.get<std::string>("text")} {}

    std::string say() const override { return "type " + in_quotes(text_) + " on the keyboard"; }
    void act(Stage& stage) const override { stage.type_keys(text_); }

private:
    std::string text_;
};

Reading read_keys(const YamlNode& node) {
    if (!std::all_of(node.text.begin(), node.text.end(), [](char c) { return scan_code(c); }))
        return std::nullopt;
    return value_types::TEXT.read(node);
}

const ValueType KEYS_TEXT{"text of characters that a US keyboard has",
                          R"({"type": "string", "pattern": "^[\\t\\n -~]+$"})", read_keys};

}  // namespace

namespace steps {

std::vector<StepForm> keyboard() {
    return {
        {"type-keys",
         "Type a text on the PS/2 keyboard and go on; a key takes 40 ms.",
         Notation::BARE,
         {},
         {{"text", KEYS_TEXT, Need::REQUIRED, "", "The text."}},
         make<TypeKeys>},
    };
}

}  // namespace steps

}  // namespace sim
