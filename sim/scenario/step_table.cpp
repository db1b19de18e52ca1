// step_table.cpp - one list of the lists in steps/ and parts/
#include "sim/scenario/step_table.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "sim/board/usb_ports.h"
#include "sim/scenario/part_table.h"

namespace sim {

// step_families.def has a line for each file of steps/, made by CMake.
namespace steps {
#define FAMILY(name) std::vector<StepForm> name();
#include "step_families.def"
#undef FAMILY
}  // namespace steps

namespace {

using namespace value_types;

const ValueType VERSION{"1, the version of the format", R"({"type": "integer", "const": 1})",
                        whole_number("", 1, 1).read};
const ValueType SEED = whole_number("a whole number from 0 to 18446744073709551615", 0,
                                    std::numeric_limits<std::uint64_t>::max());
const ValueType STEPS{"a list of steps", "", nullptr};  // reader.cpp reads these lists
const ValueType PARTS{"a list of parts", "", nullptr};
const ValueType CPU = word("native or arm", {"native", "arm"});
const ValueType MEMORY = word("mapped or bridge", {"mapped", "bridge"});
const ValueType RATE{"8000 or 48000", R"({"enum": [8000, 48000]})",
                     [](const YamlNode& node) -> Reading {
                         if (is_plain(node) && node.text == "8000") return std::uint64_t{8'000};
                         if (is_plain(node) && node.text == "48000") return std::uint64_t{48'000};
                         return std::nullopt;
                     }};
const ValueType POINTS = whole_number("a whole number from 0 to 1000000", 0, 1'000'000);
const ValueType VISIBILITY = word("visible, hidden, after-due-date or after-published",
                                  {"visible", "hidden", "after-due-date", "after-published"});
const ValueType PS2 = [] {
    ValueType type = word("keyboard, mouse or nothing", {"keyboard", "mouse", "nothing"});
    type.list_of = "device";
    type.at_most = 2;
    return type;
}();

const ValueType USB = [] {
    ValueType type = word("keyboard, mouse, gamepad, snes-gamepad or nothing",
                          {"keyboard", "mouse", "gamepad", "snes-gamepad", "nothing"});
    type.list_of = "device";
    type.several = {"at most two gamepads in a list", {2, 3}, UsbPlugs::GAMEPADS};
    type.at_most = 4;
    return type;
}();

}  // namespace

const std::vector<StepForm>& step_forms() {
    static const std::vector<StepForm> FORMS = [] {
        std::vector<StepForm> all;
        for (auto* family : {
#define FAMILY(name) &steps::name,
#include "step_families.def"
#undef FAMILY
             }) {
            std::vector<StepForm> forms = family();
            std::move(forms.begin(), forms.end(), std::back_inserter(all));
        }
        const std::vector<StepForm>& on_parts = steps_on_parts();
        std::copy(on_parts.begin(), on_parts.end(), std::back_inserter(all));
        return all;
    }();
    return FORMS;
}

const std::vector<Field>& file_fields() {
    static const std::vector<Field> FIELDS = {
        {"name", LINE, Need::REQUIRED, "", "What the scenario shows, in a line; for reports."},
        {"version", VERSION, Need::REQUIRED, "", "Version of this format: 1."},
        {"seed", SEED, Need::OPTIONAL, "1", "Seed of the contact bounce; same seed, same run."},
        {"duration", SOME_TIME, Need::OPTIONAL, "",
         "Simulated time at which the run ends. Without it the run ends with the last step."},
        {"program", FILE_NAME, Need::OPTIONAL, "",
         "The ELF to run, relative to the scenario file, unless the command line names another."},
        {"project", PATH, Need::OPTIONAL, "",
         "A Quartus project (.qsf, .qpf) or a folder of Verilog, relative to the scenario file, as "
         "--project; `program` runs on its processor, if it has one."},
        {"board", LINE, Need::OPTIONAL, "",
         "The board that the project is for or whose computer runs the program, as --board, unless "
         "that is given: DE1-SoC, DE10-Lite, DE10-Nano, DE10-Standard, or one of your own."},
        {"cpu", CPU, Need::OPTIONAL, "",
         "As --cpu, unless that is given: the firmware compiled for this machine, or the "
         "processor's model. Without it arm where there is a program."},
        {"fpga-memory", MEMORY, Need::OPTIONAL, "", "As --fpga-memory, unless that is given."},
        {"audio-rate", RATE, Need::OPTIONAL, "", "As --audio-rate, unless that is given."},
        {"points", POINTS, Need::OPTIONAL, "1", "What the scenario counts in de1sim test."},
        {"visibility", VISIBILITY, Need::OPTIONAL, "visible",
         "When Gradescope shows its result to who handed in."},
        {"ps2", PS2, Need::OPTIONAL, "",
         "What is in the first PS/2 port, or a list: in the first and in the second. Without it a "
         "keyboard and a mouse."},
        {"usb", USB, Need::OPTIONAL, "",
         "What is in the USB host ports from the beginning, for a Linux program, or a list in the "
         "order of their ports: at most two of them gamepads, of the same kind or not. Without it "
         "a keyboard and a mouse. gamepad is 0079:0006 with two sticks, snes-gamepad 0079:0011 "
         "with a d-pad and eight buttons. Libraries have an order of their own: libusb's list "
         "begins with the last port."},
        {"parts", PARTS, Need::OPTIONAL, "", "What hangs on the pins of the headers."},
        {"steps", STEPS, Need::OPTIONAL, "", "What happens, in order."},
    };
    return FIELDS;
}

}  // namespace sim
