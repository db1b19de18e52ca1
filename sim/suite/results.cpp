#include "sim/suite/results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/files/whole_file.h"
#include "sim/report/exit_code.h"
#include "sim/suite/junit.h"
#include "sim/text/printable.h"

namespace sim::suite {

namespace {

using Json = nlohmann::ordered_json;

constexpr int FORMAT = 1;
constexpr std::size_t MAX_REPORT_BYTES = 64u << 20;

// As an int; a fraction, and a number that an int does not hold, are refused.
int integer(const Json& json) {
    const auto value = json.get<double>();
    const bool fits = value >= std::numeric_limits<int>::min() &&
                      value <= std::numeric_limits<int>::max() && value == std::trunc(value);
    if (!fits) throw Json::out_of_range::create(406, "expected a whole number of 32 bits", &json);
    return static_cast<int>(value);
}

// Counted from 1.
unsigned ordinal(const Json& json) {
    const int value = integer(json);
    if (value < 1) throw Json::out_of_range::create(406, "expected a number from 1", &json);
    return static_cast<unsigned>(value);
}

std::vector<Failure> failures_of(const Json& report) {
    constexpr const char* RENEWED = "renewed: ";
    std::vector<Failure> failures;
    for (const Json& e : report.at("expectations")) {
        const bool met = e.at("met").get<bool>();
        const auto detail = e.at("detail").get<std::string>();
        if (!met || detail.rfind(RENEWED, 0) == 0)
            failures.push_back(
                {integer(e.at("line")), e.at("step").get<std::string>(), detail, met});
    }
    for (const Json& fault : report.at("faults"))
        failures.push_back({0, "the run", fault.get<std::string>(), false});
    if (report.contains("checks"))
        for (const Json& check : report.at("checks"))
            if (!check.at("met").get<bool>())
                failures.push_back({0, check.at("name").get<std::string>(),
                                    check.at("detail").get<std::string>(), false});
    return failures;
}

Json json_of(const Result& result) {
    Json failures = Json::array();
    for (const Failure& f : result.failures)
        failures.push_back(
            {{"line", f.line}, {"step", f.step}, {"detail", f.detail}, {"met", f.met}});
    return {{"name", result.name},
            {"file", result.file},
            {"exit_code", result.exit_code},
            {"end", result.end},
            {"simulated_s", result.simulated_s},
            {"wall_s", result.wall_s},
            {"folder", result.folder},
            {"points", result.points},
            {"visibility", result.visibility},
            {"failures", failures},
            {"said", result.said}};
}

Result result_of(const Json& json) {
    Result result;
    json.at("name").get_to(result.name);
    json.at("file").get_to(result.file);
    result.exit_code = integer(json.at("exit_code"));
    json.at("end").get_to(result.end);
    json.at("simulated_s").get_to(result.simulated_s);
    json.at("wall_s").get_to(result.wall_s);
    json.at("folder").get_to(result.folder);
    json.at("said").get_to(result.said);
    const int points = integer(json.value("points", Json(1)));
    result.points = points < 0 ? 0 : static_cast<unsigned>(points);
    result.visibility = json.value("visibility", "visible");
    for (const Json& f : json.at("failures"))
        result.failures.push_back({integer(f.at("line")), f.at("step").get<std::string>(),
                                   f.at("detail").get<std::string>(), f.at("met").get<bool>()});
    return result;
}

}  // namespace

const Result* Results::find(const std::string& name) const {
    const auto found = std::lower_bound(
        all.begin(), all.end(), name,
        [](const Result& result, const std::string& value) { return result.name < value; });
    return found == all.end() || found->name != name ? nullptr : &*found;
}

void Results::put(Result result) {
    missing.erase(std::remove(missing.begin(), missing.end(), result.name), missing.end());
    const auto place = std::lower_bound(
        all.begin(), all.end(), result.name,
        [](const Result& other, const std::string& value) { return other.name < value; });
    if (place != all.end() && place->name == result.name)
        *place = std::move(result);
    else
        all.insert(place, std::move(result));
}

std::map<std::string, double> Results::times_s() const {
    std::map<std::string, double> times;
    for (const Result& result : all)
        if (result.exit_code >= 0) times[result.name] = result.wall_s;
    return times;
}

int Results::exit_code() const {
    int worst = missing.empty() ? PASSED : FAILED;
    for (const Result& result : all) {
        const int code = result.exit_code;
        const bool own = code == PASSED || code == WRONG_INPUT || code == INTERRUPTED;
        worst = std::max<int>(worst, own ? code : FAILED);
    }
    return worst;
}

std::string first_failure(const Result& result) {
    constexpr std::size_t LONGEST = 300;
    std::string text = result.end;
    for (const Failure& failure : result.failures) {
        if (failure.met) continue;
        text = failure.line ? fmt::format("line {}: ", failure.line) : "";
        text += failure.step + ": " + failure.detail;
        break;
    }
    return text.size() > LONGEST ? text.substr(0, LONGEST) + "..." : text;
}

Result read_run(const std::filesystem::path& folder) {
    try {
        return run_in(read_whole_file(folder / "report.json", MAX_REPORT_BYTES));
    } catch (const IoError&) {
        Result result;
        result.end = "no report";
        return result;
    }
}

Result run_in(std::string_view text) {
    Result result;
    try {
        const Json report = Json::parse(text);
        report.at("simulated_s").get_to(result.simulated_s);
        report.at("end").get_to(result.end);
        result.failures = failures_of(report);
    } catch (const nlohmann::json::exception&) {
        result.end = "no whole report";
    }
    return result;
}

Results read_results(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "results.json";
    return results_in(read_whole_file(file, MAX_REPORT_BYTES), file.string());
}

Results results_in(std::string_view text, const std::string& name) {
    Results results;
    try {
        const Json json = Json::parse(text);
        if (const int format = integer(json.at("format")); format != FORMAT)
            throw std::runtime_error{
                fmt::format("{}: expected format {}, got {}", printable(name), FORMAT, format)};
        for (const Json& one : json.at("scenarios")) results.put(result_of(one));
        json.at("missing").get_to(results.missing);
        json.at("suite").get_to(results.suite);
        results.shard = ordinal(json.at("shard").at("number"));
        results.shards = ordinal(json.at("shard").at("of"));
    } catch (const nlohmann::json::exception& error) {
        throw std::runtime_error{
            printable(name + ": expected the results of de1sim test, got: " + error.what())};
    }
    return results;
}

std::string to_json(const Results& results) {
    Json scenarios = Json::array();
    for (const Result& result : results.all) scenarios.push_back(json_of(result));
    const Json json = {{"format", FORMAT},
                       {"shard", {{"number", results.shard}, {"of", results.shards}}},
                       {"suite", results.suite},
                       {"missing", results.missing},
                       {"scenarios", scenarios}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_results(const std::filesystem::path& folder, const Results& results) {
    write_whole_file(folder / "results.json", to_json(results));
}

void write_junit(const std::filesystem::path& folder, const Results& results) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const Result& result : results.all) text += junit_suite(folder, result);
    for (const std::string& name : results.missing) {
        Result none;
        none.name = name;
        none.end = "has no result";
        none.folder = "runs/" + name + "/none";
        text += junit_suite(folder, none);
    }
    write_whole_file(folder / "junit.xml", text + "</testsuites>\n");
}

}  // namespace sim::suite
