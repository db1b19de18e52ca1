// step_table.cpp - the table
#include "sim/scenario/step_table.h"

namespace sim {

namespace {

using namespace value_types;

const std::vector<Field>& control_fields() {
    static const std::vector<Field> FIELDS = {
        {"keypad", KEYPAD, Need::OPTIONAL, "", "Keypad key, 0-9 or A-F, or a list of them."},
        {"key", KEY, Need::OPTIONAL, "", "Push button KEY0 to KEY3, or a list of numbers."},
        {"switch", SWITCH, Need::OPTIONAL, "", "Slide switch SW0 to SW9, or a list of numbers."},
    };
    return FIELDS;
}

std::vector<Field> controls_and(const Field& field) {
    std::vector<Field> fields = control_fields();
    fields.push_back(field);
    return fields;
}

Controls controls(const Values& v) {
    return {static_cast<std::uint16_t>(v.get<std::uint64_t>("keypad")),
            static_cast<std::uint8_t>(v.get<std::uint64_t>("key")),
            static_cast<std::uint16_t>(v.get<std::uint64_t>("switch"))};
}

Field timeout(const ValueType& type, const char* preset, const char* help) {
    return {"timeout", type, Need::OPTIONAL, preset, help};
}

const std::vector<const char*> ANY_CONTROL = {"keypad", "key", "switch"};
const char* const WAIT_HELP = "Longest wait in simulated time; then the run fails.";
const char* const POLL_HELP = "How long it may take until it is so.";

}  // namespace

const std::vector<Field>& file_fields() {
    static const std::vector<Field> FIELDS = {
        {"name", LINE, Need::REQUIRED, "", "What the scenario shows, in a line; for reports."},
        {"version", VERSION, Need::REQUIRED, "", "Version of this format: 1."},
        {"seed", SEED, Need::OPTIONAL, "1", "Seed of the contact bounce; same seed, same run."},
        {"duration", SOME_TIME, Need::OPTIONAL, "",
         "Simulated time at which the run ends. Without it the run ends with the last step."},
        {"program", LINE, Need::OPTIONAL, "",
         "The ELF to run, relative to the scenario file, unless the command line names another."},
        {"steps", STEPS, Need::OPTIONAL, "", "What happens, in order."},
    };
    return FIELDS;
}

const std::vector<StepForm>& step_forms() {
    static const std::vector<StepForm> FORMS = {
        {"delay",
         "Let simulated time pass.",
         Notation::BARE,
         {},
         {{"time", TIME, Need::REQUIRED, "", "How long."}},
         [](const Values& v) -> Action { return Delay{v.get<SimTime>("time")}; }},
        {"press", "Hold controls for a while and let go; the next step comes after that.",
         Notation::MAP, ANY_CONTROL,
         controls_and({"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}),
         [](const Values& v) -> Action {
             return Press{controls(v), v.get<SimTime>("for")};
         }},
        {"hold",
         "Begin to hold controls and go on to the next step, for chords that overlap in time.",
         Notation::MAP, ANY_CONTROL, control_fields(),
         [](const Values& v) -> Action { return Hold{controls(v)}; }},
        {"release", "Let go of controls that are held.", Notation::MAP, ANY_CONTROL,
         control_fields(), [](const Values& v) -> Action { return Release{controls(v)}; }},
        {"type-serial",
         "Type a text at the terminal of the JTAG UART and go on; a character takes 1 ms.",
         Notation::BARE,
         {},
         {{"text", TEXT, Need::REQUIRED, "", "The text."}},
         [](const Values& v) -> Action { return TypeSerial{v.get<std::string>("text")}; }},
        {"set-voltage",
         "Apply a voltage to an input of the AD converter and go on; all begin at 0 V.",
         Notation::MAP,
         {},
         {{"channel", CHANNEL, Need::REQUIRED, "", "The input, CH0 to CH7."},
          {"volts", VOLTS, Need::REQUIRED, "", "Against ground."}},
         [](const Values& v) -> Action {
             return SetVoltage{static_cast<unsigned>(v.get<std::uint64_t>("channel")),
                               v.get<double>("volts")};
         }},
        {"type-keys",
         "Type a text on the PS/2 keyboard and go on; a key takes 40 ms.",
         Notation::BARE,
         {},
         {{"text", KEYS_TEXT, Need::REQUIRED, "", "The text."}},
         [](const Values& v) -> Action { return TypeKeys{v.get<std::string>("text")}; }},
        {"wait-frame",
         "Wait for a frame on the monitor.",
         Notation::BOTH,
         {},
         {{"frame", FRAME, Need::REQUIRED, "",
           "The n-th frame since power-on (1 is the first), next: the next frame, next-swap: the "
           "next frame with a new picture."},
          timeout(SOME_TIME, "10s", WAIT_HELP)},
         [](const Values& v) -> Action {
             WaitFrame step = v.get<WaitFrame>("frame");
             step.timeout = v.get<SimTime>("timeout");
             return step;
         }},
        {"wait-serial",
         "Wait until the firmware has printed a text; the next wait-serial looks behind it.",
         Notation::BOTH,
         {},
         {{"text", TEXT, Need::REQUIRED, "", "The text."}, timeout(SOME_TIME, "10s", WAIT_HELP)},
         [](const Values& v) -> Action {
             return WaitSerial{v.get<std::string>("text"), v.get<SimTime>("timeout")};
         }},
        {"expect-frame",
         "Compare the picture on the monitor with a PNG of 640 x 480 pixels.",
         Notation::MAP,
         {},
         {{"equals", LINE, Need::REQUIRED, "", "The PNG, relative to the scenario file."},
          {"differing-pixels", PIXELS, Need::OPTIONAL, "0", "At most so many pixels may differ."}},
         [](const Values& v) -> Action {
             return ExpectFrame{v.get<std::string>("equals"),
                                v.get<std::uint64_t>("differing-pixels")};
         }},
        {"expect-tone",
         "Listen for a tone at the line output.",
         Notation::MAP,
         {},
         {{"hz", HERTZ, Need::REQUIRED, "", "Its frequency in hertz."},
          {"within", PERCENT, Need::OPTIONAL, "3%", "How far the frequency may be off."},
          {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long the tone lasts at least."},
          timeout(TIME, "1s", "How long it may take until the tone begins.")},
         [](const Values& v) -> Action {
             return ExpectTone{v.get<double>("hz"), v.get<double>("within"), v.get<SimTime>("for"),
                               v.get<SimTime>("timeout")};
         }},
        {"expect-silence",
         "Listen to the line output and hear nothing.",
         Notation::MAP,
         {},
         {{"for", SOME_TIME, Need::REQUIRED, "", "How long."}},
         [](const Values& v) -> Action { return ExpectSilence{v.get<SimTime>("for")}; }},
        {"expect-leds",
         "Look at the ten red LEDs.",
         Notation::BOTH,
         {},
         {{"equals", LEDS, Need::REQUIRED, "",
           "Ten characters 0 or 1 in quotes, LEDR9 first, or the number they make."},
          timeout(TIME, "0s", POLL_HELP)},
         [](const Values& v) -> Action {
             return ExpectLeds{static_cast<std::uint16_t>(v.get<std::uint64_t>("equals")),
                               v.get<SimTime>("timeout")};
         }},
        {"expect-hex",
         "Read the six seven-segment digits.",
         Notation::BOTH,
         {},
         {{"equals", HEX, Need::REQUIRED, "",
           "Six characters in quotes, HEX5 first: 0-9 A-F H L P U n o r t u y - _ and blank. "
           "6, 7 and 9 count in both of their usual forms."},
          timeout(TIME, "0s", POLL_HELP)},
         [](const Values& v) -> Action {
             return ExpectHex{v.get<std::string>("equals"), v.get<SimTime>("timeout")};
         }},
        {"take-screenshot",
         "Save the picture on the monitor as PNG.",
         Notation::MAP,
         {},
         {{"save-to", PNG_NAME, Need::REQUIRED, "",
           "File name, relative to the output folder and inside it."}},
         [](const Values& v) -> Action { return TakeScreenshot{v.get<std::string>("save-to")}; }},
    };
    return FORMS;
}

}  // namespace sim
