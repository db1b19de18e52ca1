#include "sim/suite/graders.h"

#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/files/whole_file.h"
#include "sim/page/html.h"
#include "sim/suite/junit.h"

namespace sim::suite {

std::string to_classroom(const Results& results) {
    using Json = nlohmann::ordered_json;
    Json tests = Json::array();
    unsigned most = 0;
    for (const Result& result : results.all) {
        most += result.points;
        Json message;
        if (!result.passed()) message = first_failure(result);
        tests.push_back({{"name", result.name},
                         {"status", result.passed() ? "pass" : "fail"},
                         {"score", result.passed() ? result.points : 0},
                         {"message", message}});
    }
    for (const std::string& name : results.missing)
        tests.push_back(
            {{"name", name}, {"status", "error"}, {"score", 0}, {"message", "has no result"}});
    const bool passed = results.exit_code() == 0;
    const Json json = {{"version", 1},
                       {"status", passed ? "pass" : "fail"},
                       {"max_score", most},
                       {"tests", tests}};
    return page::base64(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using page::escape;

constexpr std::size_t MAX_PICTURE_BYTES = 4u << 20;

// The golden picture of a failure and what there was, in the text itself.
std::string inlined_pictures(const fs::path& folder, const Result& result, const Failure& failure) {
    std::string out;
    for (const char* what : {"expected", "actual"})
        for (const fs::path& file : pictures_of(folder, result, failure, what)) {
            const std::string png = read_whole_file(folder / file, MAX_PICTURE_BYTES);
            out += fmt::format("<p>{0}:<br><img alt=\"{0}\" src=\"{1}\"></p>\n", what,
                               page::data_url({png.begin(), png.end()}));
        }
    return out;
}

std::string output_of(const fs::path& folder, const Result& result) {
    std::string out = "<p>" + escape(result.end) + "</p>\n";
    for (const Failure& failure : result.failures) {
        if (failure.met) continue;
        out += failure.line ? fmt::format("<p>line {}: {}<br>", failure.line, escape(failure.step))
                            : fmt::format("<p>{}<br>", escape(failure.step));
        out += escape(failure.detail) + "</p>\n" + inlined_pictures(folder, result, failure);
    }
    if (!result.passed() && result.failures.empty() && !result.said.empty())
        out += "<pre>" + escape_lines(result.said) + "</pre>\n";
    return out;
}

}  // namespace

std::string to_gradescope(const fs::path& folder, const Results& results) {
    Json tests = Json::array();
    double wall_s = 0;
    for (const Result& result : results.all) {
        wall_s += result.wall_s;
        tests.push_back({{"name", result.name},
                         {"score", result.passed() ? result.points : 0},
                         {"max_score", result.points},
                         {"status", result.passed() ? "passed" : "failed"},
                         {"output", output_of(folder, result)},
                         {"output_format", "html"},
                         {"visibility", result.visibility}});
    }
    for (const std::string& name : results.missing)
        tests.push_back({{"name", name}, {"status", "failed"}, {"output", "has no result"}});
    const Json json = {{"execution_time", wall_s}, {"tests", tests}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

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
