#include "sim/suite/grades.h"

#include <map>
#include <set>

#include <fmt/format.h>

namespace sim::suite {

namespace {

std::string cell(std::string text) {
    if (!text.empty() && std::string{"=+-@\t\r"}.find(text[0]) != std::string::npos)
        text.insert(0, "'");
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

std::string to_csv(const Results& results) {
    std::map<std::string, std::map<std::string, const Result*>> rows;  // hand-in, scenario
    std::map<std::string, unsigned> points;                            // of a scenario
    for (const std::string& name : results.suite) {
        const std::size_t slash = name.find('/');
        const std::string scenario = name.substr(slash + 1);
        const Result* result = results.find(name);
        rows[name.substr(0, slash)][scenario] = result;
        points.try_emplace(scenario, 0);
        if (result) points[scenario] = result->points;
    }
    std::string text = "hand-in,points,of";
    unsigned most = 0;
    for (const auto& [scenario, value] : points) {
        text += "," + cell(scenario);
        most += value;
    }
    text += ",remarks\r\n";
    for (const auto& [hand_in, row] : rows) {
        unsigned sum = 0;
        std::string cells, remarks;
        for (const auto& [scenario, value] : points) {
            const auto found = row.find(scenario);
            const Result* result = found == row.end() ? nullptr : found->second;
            const unsigned got = result && result->passed() ? result->points : 0;
            sum += got;
            cells += fmt::format(",{}", got);
            if (result && result->passed()) continue;
            remarks += (remarks.empty() ? "" : "; ") + scenario + ": " +
                       (result ? first_failure(*result) : "has no result");
        }
        text += fmt::format("{},{},{}{},{}\r\n", cell(hand_in), sum, most, cells, cell(remarks));
    }
    return text;
}

}  // namespace sim::suite
