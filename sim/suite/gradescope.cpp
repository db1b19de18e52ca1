#include "sim/suite/gradescope.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/files/whole_file.h"
#include "sim/page/html.h"
#include "sim/suite/junit.h"

namespace sim::suite {

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

}  // namespace sim::suite
