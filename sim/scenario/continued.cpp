#include "sim/scenario/continued.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "sim/scenario/part_table.h"
#include "sim/scenario/step_table.h"
#include "sim/scenario/yaml_tree.h"

namespace sim {

namespace {

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

// Reads the same between brackets without quotes.
bool is_simple(const std::string& text) {
    const auto allowed = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '_' || c == '.' || c == '%' || c == '/' || c == '-' || c == ' ';
    };
    return !text.empty() && text[0] != '-' && text[0] != '%' &&
           std::all_of(text.begin(), text.end(), allowed);
}

class Writer {
public:
    Writer(std::filesystem::path from, std::filesystem::path to)
        : from_{std::move(from)}, to_{std::move(to)} {}

    std::string value(const YamlNode& node) const {
        switch (node.kind) {
            case YamlNode::Kind::NOTHING: return "null";
            case YamlNode::Kind::SCALAR: {
                const bool plain = !node.quoted && (!is_text(node) || is_simple(node.text));
                return plain ? node.text : quoted(node.text);
            }
            case YamlNode::Kind::LIST: {
                std::vector<std::string> items;
                for (const YamlNode& item : node.items) items.push_back(value(item));
                return fmt::format("[{}]", fmt::join(items, ", "));
            }
            case YamlNode::Kind::MAP: break;
        }
        return map(node, [this](const std::string&, const YamlNode& item) { return value(item); });
    }

    // The value of a field, whose files are moved.
    std::string value(const Field& field, const YamlNode& node) const {
        const std::filesystem::path path{node.text};
        if (!field.type.is_path || path.is_absolute()) return value(node);
        return quoted(
            std::filesystem::proximate(std::filesystem::absolute(from_ / path), to_).string());
    }
    std::string value(const std::vector<Field>& fields, const std::string& name,
                      const YamlNode& node) const {
        for (const Field& field : fields)
            if (field.name == name) return value(field, node);
        return value(node);
    }

    template <class AForm>
    std::string item(const std::vector<AForm>& forms, const YamlNode& node) const {
        return map(node, [&](const std::string& name, const YamlNode& of) {
            const auto form = std::find_if(forms.begin(), forms.end(),
                                           [&](const AForm& one) { return one.name == name; });
            if (of.kind != YamlNode::Kind::MAP) return value(form->fields[0], of);
            return map(of, [&](const std::string& field, const YamlNode& its) {
                return value(form->fields, field, its);
            });
        });
    }

private:
    template <class Write>
    static std::string map(const YamlNode& node, Write write) {
        std::vector<std::string> items;
        for (std::size_t i = 0; i < node.keys.size(); ++i)
            items.push_back(node.keys[i].text + ": " + write(node.keys[i].text, node.items[i]));
        return fmt::format("{{{}}}", fmt::join(items, ", "));
    }

    const std::filesystem::path from_, to_;
};

}  // namespace

std::string continued(const Scenario& scenario, std::uint64_t seed,
                      const std::filesystem::path& folder, const std::vector<std::string>& steps) {
    const YamlNode root = parse_yaml(scenario.text);
    const Writer writer{scenario.file.parent_path(), folder};
    std::string text, duration, all_steps;
    for (std::size_t i = 0; i < root.keys.size(); ++i) {
        const std::string& name = root.keys[i].text;
        const YamlNode& node = root.items[i];
        if (name == "seed") continue;
        if (name == "duration") {
            duration = fmt::format("duration: {}\n", writer.value(node));
        } else if (name == "steps") {
            for (const YamlNode& step : node.items)
                all_steps += "  - " + writer.item(step_forms(), step) + "\n";
        } else if (name == "parts") {
            text += "parts:\n";
            for (const YamlNode& part : node.items)
                text += "  - " + writer.item(part_forms(), part) + "\n";
        } else {
            text += fmt::format("{}: {}\n", name, writer.value(file_fields(), name, node));
        }
    }
    for (const std::string& step : steps) all_steps += "  - " + step + "\n";
    text += fmt::format("seed: {}\n", seed);
    return text + (all_steps.empty() ? duration : "steps:\n" + all_steps);
}

}  // namespace sim
