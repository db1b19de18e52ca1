#include "sim/suite/cases.h"

#include <fnmatch.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/yaml_tree.h"
#include "sim/text/printable.h"

namespace sim::suite {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t MAX_FILE_BYTES = 1u << 20;
constexpr double LEAST_S = 0.2;  // to start a run

bool has_key(const YamlNode& map, const char* name) {
    return std::any_of(map.keys.begin(), map.keys.end(),
                       [name](const YamlNode& key) { return key.text == name; });
}

// Other YAML files are somebody else's; what is wrong with a scenario its run will say.
bool looks_like_a_scenario(const fs::path& file) {
    try {
        const YamlNode root = parse_yaml(read_whole_file(file, MAX_FILE_BYTES));
        return root.kind == YamlNode::Kind::MAP &&
               (has_key(root, "steps") || (has_key(root, "name") && has_key(root, "version")));
    } catch (const IoError&) {
        return false;
    } catch (const Refusal&) {
        return true;
    }
}

double simulated_s(const Scenario& scenario) {
    if (scenario.duration) return static_cast<double>(scenario.duration->ps) * 1e-12;
    std::uint64_t ps = 0;
    for (const ScenarioStep& step : scenario.steps) ps += step.step->least().ps;
    return static_cast<double>(ps) * 1e-12;
}

Case case_of(const fs::path& file, const std::string& name) {
    Case one{file, name, LEAST_S};
    try {
        const Scenario scenario = parse_scenario(read_whole_file(file, MAX_FILE_BYTES), file);
        one.expected_s += simulated_s(scenario);
        one.points = scenario.points;
        one.visibility = scenario.visibility;
    } catch (const std::runtime_error&) {
        // Its run will say what is wrong with it.
    }
    return one;
}

void search(const fs::path& folder, std::vector<fs::path>& found) {
    std::error_code error;
    if (fs::exists(folder / "report.json", error)) return;
    std::vector<fs::path> entries;
    for (const auto& entry : fs::directory_iterator(folder, error)) entries.push_back(entry.path());
    if (error)
        throw std::runtime_error{printable(folder.string()) + ": cannot read: " + error.message()};
    for (const fs::path& entry : entries) {
        if (entry.filename().string().front() == '.') continue;
        if (fs::is_directory(entry, error))
            search(entry, found);
        else if (entry.extension() == ".yaml" && looks_like_a_scenario(entry))
            found.push_back(entry);
    }
}

// "sw/examples/pong/pong"; "../" and a leading "/" go, since it becomes a folder's name.
std::string name_of(const fs::path& file) {
    std::string name;
    for (const fs::path& part : fs::path{file}.replace_extension("").lexically_normal()) {
        if (part == "/" || part == ".." || part == ".") continue;
        name += (name.empty() ? "" : "/") + part.string();
    }
    return name;
}

}  // namespace

std::vector<Case> find_cases(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code error;
        const std::size_t before = files.size();
        if (fs::is_directory(path, error))
            search(path, files);
        else if (fs::is_regular_file(path, error))
            files.push_back(path);
        else
            throw std::runtime_error{printable(path.string()) +
                                     ": expected a scenario or a folder of them, got nothing"};
        if (files.size() == before)
            throw std::runtime_error{printable(path.string()) +
                                     ": expected scenarios (.yaml) in this folder, got none"};
    }
    std::vector<Case> cases;
    std::set<fs::path> seen;
    std::map<std::string, unsigned> names;
    for (const fs::path& file : files) {
        if (!seen.insert(fs::weakly_canonical(file)).second) continue;
        std::string name = name_of(file);
        if (const unsigned before = names[name]++) name += fmt::format("~{}", before + 1);
        cases.push_back(case_of(file, name));
    }
    std::sort(cases.begin(), cases.end(),
              [](const Case& a, const Case& b) { return a.name < b.name; });
    return cases;
}

std::vector<Case> filtered(std::vector<Case> cases, const std::string& text) {
    const bool pattern = text.find_first_of("*?[") != std::string::npos;
    const auto misses = [&](const Case& one) {
        return pattern ? fnmatch(text.c_str(), one.name.c_str(), 0) != 0
                       : one.name.find(text) == std::string::npos;
    };
    cases.erase(std::remove_if(cases.begin(), cases.end(), misses), cases.end());
    return cases;
}

void use_times(std::vector<Case>& cases, const std::map<std::string, double>& times_s) {
    for (Case& one : cases)
        if (const auto time = times_s.find(one.name); time != times_s.end())
            one.expected_s = time->second;
}

void sort_by_time(std::vector<Case>& cases) {
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) {
        return a.expected_s != b.expected_s ? a.expected_s > b.expected_s : a.name < b.name;
    });
}

std::vector<Case> shard(std::vector<Case> cases, unsigned number, unsigned count) {
    sort_by_time(cases);
    std::vector<double> loads_s(count);
    std::vector<Case> mine;
    for (Case& one : cases) {
        const auto least = std::min_element(loads_s.begin(), loads_s.end());
        *least += one.expected_s;
        if (least - loads_s.begin() == static_cast<std::ptrdiff_t>(number) - 1)
            mine.push_back(std::move(one));
    }
    return mine;
}

}  // namespace sim::suite
