// reader.cpp - YAML tree to Scenario, driven by the forms of the steps
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/files/whole_file.h"
#include "sim/scenario/part_table.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_reader.h"
#include "sim/scenario/step_table.h"
#include "sim/scenario/yaml_tree.h"
#include "sim/text/printable.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using Path = std::filesystem::path;

constexpr std::size_t MAX_FILE_BYTES = 1u << 20;

template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
    std::vector<std::string> out;
    for (const auto& one : all) out.push_back(one.name);
    return out;
}

template <class Named>
const Named& find(const std::vector<Named>& all, const YamlNode& key, const std::string& kind) {
    for (const auto& one : all)
        if (key.text == one.name) return one;
    const std::string hint = did_you_mean(key.text, names(all));
    const std::string choice = hint.empty() ? ": " + list_of(names(all)) : "";
    refuse(key, kind + choice, describe(key) + hint);
}

Value preset_value(const Field& field) {
    YamlNode node;
    node.kind = YamlNode::Kind::SCALAR;
    node.text = field.preset;
    return read_value(field.type, node);
}

// `whole` names the map in messages; `at` is the place of messages about missing fields.
Values read_fields(Values values, const std::vector<Field>& fields, const YamlNode& map,
                   const YamlNode& at, const std::string& whole) {
    const std::string a_field = "a field of " + whole;
    for (std::size_t i = 0; i < map.keys.size(); ++i) {
        const Field& field = find(fields, map.keys[i], a_field);
        if (!field.type.read) continue;
        values.set(field.name, read_value(field.type, map.items[i]));
    }
    for (const Field& field : fields) {
        if (values.find(field.name)) continue;
        if (field.need == Need::REQUIRED)
            refuse(at, fmt::format("\"{}\" in {}", field.name, whole), "none");
        if (*field.preset) values.set(field.name, preset_value(field));
    }
    return values;
}

template <class AForm>
Values read_bare(Values values, const AForm& form, const YamlNode& value) {
    values.set(form.fields[0].name, read_value(form.fields[0].type, value));
    for (std::size_t i = 1; i < form.fields.size(); ++i)
        if (*form.fields[i].preset) values.set(form.fields[i].name, preset_value(form.fields[i]));
    return values;
}

template <class AForm>
Values read_values(const Path& folder, const AForm& form, const YamlNode& key,
                   const YamlNode& value) {
    const bool is_map = value.kind == YamlNode::Kind::MAP;
    if (form.notation == Notation::BARE || (form.notation == Notation::BOTH && !is_map))
        return read_bare({folder, key.line}, form, value);
    if (!is_map)
        refuse(value, fmt::format("a map with {} in {}", list_of(names(form.fields)), form.name),
               describe(value));
    Values values = read_fields({folder, key.line}, form.fields, value, key, form.name);
    const auto found = std::count_if(form.any_of.begin(), form.any_of.end(),
                                     [&](const char* name) { return values.find(name); });
    if (!form.any_of.empty() && (found == 0 || (form.only_one && found > 1)))
        refuse(
            key,
            fmt::format("{} in {}", list_of({form.any_of.begin(), form.any_of.end()}), form.name),
            found == 0 ? "none" : "more than one of them");
    return values;
}

// An item of a list: a map whose only key says which of the forms it has.
template <class AForm>
std::pair<const AForm&, Values> read_item(const Path& folder, const std::vector<AForm>& forms,
                                          const YamlNode& node, const std::string& kind,
                                          const std::string& example) {
    const std::string a_kind = "a " + kind,
                      expected = fmt::format("{} such as `{}`", a_kind, example);
    if (node.kind != YamlNode::Kind::MAP) refuse(node, expected, describe(node));
    if (node.keys.empty()) refuse(node, expected, "an empty map");
    const YamlNode& key = node.keys[0];
    const AForm& form = find(forms, key, a_kind);
    if (node.keys.size() > 1)
        refuse(node.keys[1], fmt::format("one {} in an item of the list", kind),
               describe(node.keys[1]) + " after " + describe(key) + " (is it to be indented?)");
    return {form, read_values(folder, form, key, node.items[0])};
}

ScenarioStep read_step(const Path& folder, const YamlNode& node) {
    const auto [form, values] = read_item(folder, step_forms(), node, "step", "delay: 500ms");
    auto step = form.make(values);
    std::string text = step->describe();
    const YamlNode& key = node.keys[0];
    return {key.line, key.column, std::move(text), std::move(step)};
}

PartPlan read_part(const Path& folder, const YamlNode& node) {
    const auto [form, values] =
        read_item(folder, part_forms(), node, "part", "keypad: GPIO_1[7:0]");
    PartPlan part = form.make(values);
    part.kind = form.name;
    part.name = values.get<std::string>("name", form.name);
    part.line = values.line();
    part.column = node.keys[0].column;
    return part;
}

template <class Read>
auto read_list(const Path& folder, const YamlNode& list, const std::string& kind, Read read) {
    if (list.kind != YamlNode::Kind::LIST)
        refuse(list, fmt::format("a list of {}s", kind), describe(list));
    if (list.items.empty()) refuse(list, fmt::format("one {} or more", kind), "an empty list");
    std::vector<decltype(read(folder, list))> all;
    for (const YamlNode& item : list.items) all.push_back(read(folder, item));
    return all;
}

// Refuses, with its place, the first byte that cannot be in a text.
void need_text(std::string_view text) {
    int line = 1, column = 1;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const auto c = next_utf8(text, at);
        if (!c || *c == 0)
            throw Refusal{line, column,
                          "expected text in UTF-8, got the byte " +
                              fmt::format("{:#04x}", text[begin] & 0xFF)};
        column = *c == '\n' ? 1 : column + static_cast<int>(at - begin);
        line += *c == '\n';
    }
}

Ps2Ports ps2_ports(const Numbers& devices) {
    return {static_cast<Ps2Plug>(devices.at(0)),
            devices.size() > 1 ? static_cast<Ps2Plug>(devices[1]) : Ps2Plug::NOTHING};
}

UsbPlugs usb_plugs(const Numbers& devices) {
    UsbPlugs plugs{{}};
    constexpr std::uint64_t NOTHING = 4;
    for (const std::uint64_t device : devices) {
        if (device == NOTHING) continue;
        const auto plug = static_cast<UsbPlug>(device);
        plugs.plug({plug, is_gamepad(plug) ? plugs.free_number() : 0});
    }
    return plugs;
}

Scenario read_scenario(std::string_view text, const Path& file) {
    if (text.size() > MAX_FILE_BYTES)
        throw Refusal{0, 0,
                      "expected at most 1 MiB, got " + std::to_string(text.size()) + " bytes"};
    need_text(text);
    const YamlNode root = parse_yaml(text);
    if (root.kind == YamlNode::Kind::NOTHING)
        throw Refusal{0, 0, "expected a scenario, got an empty file"};
    if (root.kind != YamlNode::Kind::MAP)
        refuse(root, "a map with name, version and steps", describe(root));

    const Path folder = file.parent_path();
    const Values values = read_fields({folder, root.line}, file_fields(), root, root, "a scenario");
    Scenario scenario;
    scenario.file = file;
    scenario.text = text;
    scenario.name = values.get<std::string>("name");
    scenario.seed = values.get<std::uint64_t>("seed");
    if (values.find("duration")) scenario.duration = values.get<SimTime>("duration");
    if (values.find("program")) scenario.program = values.path("program");
    if (values.find("project")) scenario.project = values.path("project");
    constexpr const char* CPUS[] = {"native", "arm"};
    if (values.find("cpu")) scenario.cpu = CPUS[values.number<std::size_t>("cpu")];
    if (values.find("fpga-memory"))
        scenario.memory_bridged = values.number<unsigned>("fpga-memory") == 1;
    if (values.find("audio-rate")) scenario.audio_rate = values.number<unsigned>("audio-rate");
    if (values.find("points")) scenario.points = values.number<unsigned>("points");
    constexpr const char* VISIBILITIES[] = {"visible", "hidden", "after_due_date",
                                            "after_published"};
    if (values.find("visibility"))
        scenario.visibility = VISIBILITIES[values.number<std::size_t>("visibility")];
    if (values.find("ps2")) scenario.ps2 = ps2_ports(values.list("ps2"));
    if (values.find("usb")) scenario.usb = usb_plugs(values.list("usb"));
    for (std::size_t i = 0; i < root.keys.size(); ++i) {
        if (root.keys[i].text == "steps")
            scenario.steps = read_list(folder, root.items[i], "step", read_step);
        if (root.keys[i].text == "board") {
            scenario.board_name = values.get<std::string>("board");
            scenario.board_line = root.items[i].line;
            scenario.board_column = root.items[i].column;
        }
        if (root.keys[i].text == "parts")
            scenario.parts = read_list(folder, root.items[i], "part", read_part);
    }
    check_parts(scenario.parts);
    if (scenario.steps.empty() && !scenario.duration)
        refuse(root, "\"steps\" or \"duration\" in a scenario", "none");
    check_steps(scenario);
    return scenario;
}

std::string place(const Path& file, int line, int column) {
    std::string out = printable(file.string()) + ":";
    if (line) out += fmt::format("{}:{}:", line, column);
    return out + " ";
}

}  // namespace

ScenarioError::ScenarioError(std::filesystem::path in_file, int in_line, int in_column,
                             std::string in_message)
    : std::runtime_error(place(in_file, in_line, in_column) + in_message),
      file(std::move(in_file)),
      line(in_line),
      column(in_column),
      message(std::move(in_message)) {}

Scenario parse_scenario(std::string_view text, const std::filesystem::path& file) {
    try {
        return read_scenario(text, file);
    } catch (const Refusal& refusal) {
        throw ScenarioError(file, refusal.line, refusal.column, refusal.message);
    }
}

void check_scenario(const Scenario& scenario) {
    try {
        check_steps(scenario);
    } catch (const Refusal& refusal) {
        throw ScenarioError(scenario.file, refusal.line, refusal.column, refusal.message);
    }
}

StepReader::StepReader(const Scenario& scenario) : scenario_{scenario}, checks_{scenario} {
    for (const ScenarioStep& step : scenario.steps) {
        checks_.step_ = &step;
        step.step->check(checks_);
    }
}

ScenarioStep StepReader::read(std::string_view text) {
    try {
        need_text(text);
        ScenarioStep step = read_step(scenario_.file.parent_path(), parse_yaml(text));
        step.line = ++number_;
        checks_.step_ = &step;
        step.step->check(checks_);
        step.step->load(Goldens::ARE_THERE);
        return step;
    } catch (const Refusal& refusal) {
        throw std::runtime_error{refusal.message};
    }
}

Scenario load_scenario(const std::filesystem::path& file, Goldens goldens) {
    std::string text;
    try {
        text = read_whole_file(file, MAX_FILE_BYTES);
    } catch (const IoError& error) {
        if (error.problem() == "is not there") throw ScenarioError(file, 0, 0, error.problem());
        throw ScenarioError(file, 0, 0, "expected a scenario file, got: " + error.problem());
    }
    Scenario scenario = parse_scenario(text, file);
    for (const ScenarioStep& step : scenario.steps) {
        try {
            step.step->load(goldens);
        } catch (const std::runtime_error& error) {
            throw ScenarioError(file, step.line, step.column, error.what());
        }
    }
    return scenario;
}

}  // namespace sim
