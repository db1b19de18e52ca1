// report.cpp - report.json and junit.xml
#include "sim/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/text/markup.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

constexpr std::size_t MAX_VIOLATIONS_PRINTED = 20;

std::string test_case(const std::string& classname, const std::string& name, double time_s) {
    return fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"",
                       escape_markup(classname), escape_markup(name), time_s);
}

std::string verdict(bool met, const std::string& detail) {
    if (met) return "/>\n";
    return fmt::format(
        ">\n      <failure message=\"{0}\">{0}</failure>\n"
        "    </testcase>\n",
        escape_markup(detail));
}

nlohmann::ordered_json spread_json(const RunReport::Spread& spread) {
    return {{"min", spread.least}, {"median", spread.median}, {"max", spread.most}};
}

nlohmann::ordered_json program_json(const RunReport::Program& program) {
    nlohmann::ordered_json json = {
        {"elf", program.elf},
        {"cpi", program.cpi},
        {"instructions", program.instructions},
        {"interrupts", program.interrupts},
        {"aborts", program.aborts},
        {"asleep_s", program.asleep_s},
        {"on_bus_s", program.on_bus_s},
        {"at",
         {{"pc", fmt::format("0x{:08X}", program.pc)},
          {"function", program.function},
          {"waiting_for", program.waiting}}},
    };
    if (program.frames.count > 0)
        json["frames"] = {{"count", program.frames.count},
                          {"instructions", spread_json(program.frames.instructions)},
                          {"busy_share", spread_json(program.frames.busy_share)},
                          {"bus_share", spread_json(program.frames.bus_share)}};
    if (program.exit_code) json["exit_code"] = *program.exit_code;
    if (!program.network.empty()) json["network"] = program.network;
    return json;
}

nlohmann::ordered_json shown_json(const std::vector<RunReport::Shown>& all) {
    using Json = nlohmann::ordered_json;
    Json json = Json::object();
    for (const RunReport::Shown& shown : all) {
        Json one = Json::object(), changes = Json::array();
        for (const auto& [name, value] : shown.at_end) one[name] = value;
        for (const auto& [time_s, fields] : shown.changes) {
            Json change = {{"time_s", time_s}};
            for (const auto& [name, value] : fields) change[name] = value;
            changes.push_back(std::move(change));
        }
        one["changes"] = {{"count", shown.changes.size() + shown.left_out},
                          {"first", std::move(changes)}};
        json[shown.name] = std::move(one);
    }
    return json;
}

// What a test most often looks at.
nlohmann::ordered_json final_json(const std::vector<RunReport::Shown>& all) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const RunReport::Shown& shown : all)
        if (shown.name == "ledr" || shown.name == "hex" || shown.name == "hps_led")
            json[shown.name] = shown.at_end.front().second;
    return json;
}

nlohmann::ordered_json parts_json(const RunReport& report) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const PartReport& part : report.parts) {
        if (!part.rows.empty()) json[part.name]["rows"] = part.rows;
        if (part.received)
            json[part.name] = {{"received", printable(*part.received)}, {"lost", part.lost}};
    }
    return json;
}

// The rows that have something in them, numbered from 0.
nlohmann::ordered_json characters_json(const std::vector<std::string>& rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t y = 0; y < rows.size(); ++y)
        if (!rows[y].empty()) json.push_back({{"row", y}, {"text", rows[y]}});
    return json;
}

// What went wrong with the run as a whole, apart from its expectations.
std::vector<std::string> run_errors(const RunReport& report) {
    std::vector<std::string> errors = report.faults;
    const bool faulted =
        report.end == RunEnd::FIRMWARE_FAULT || report.end == RunEnd::DESIGN_STOPPED;
    if (faulted && errors.empty()) errors.push_back(to_string(report.end));
    if (report.interrupted()) errors.push_back("the run was interrupted");
    return errors;
}

std::size_t failures(const RunReport& report) {
    const auto not_met = [](const auto& decided) { return !decided.met; };
    return static_cast<std::size_t>(
        std::count_if(report.expectations.begin(), report.expectations.end(), not_met) +
        std::count_if(report.checks.begin(), report.checks.end(), not_met));
}

}  // namespace

const char* to_string(RunEnd end) {
    switch (end) {
        case RunEnd::ALL_STEPS_DONE: return "all steps done";
        case RunEnd::DURATION_REACHED: return "duration reached";
        case RunEnd::PROGRAM_ENDED: return "the program ended";
        case RunEnd::INTERRUPTED: return "interrupted";
        case RunEnd::FIRMWARE_FAULT: return "firmware fault";
        case RunEnd::DESIGN_STOPPED: return "stopped by the design";
        case RunEnd::DESIGN_OSCILLATES: return "oscillation of the design";
        case RunEnd::INTERNAL_ERROR: return "internal error";
    }
    return "unknown";
}

bool RunReport::passed() const { return failures(*this) == 0 && run_errors(*this).empty(); }

std::string to_json(const RunReport& report) {
    using Json = nlohmann::ordered_json;
    Json expectations = Json::array();
    for (const auto& e : report.expectations)
        expectations.push_back({{"step", e.step},
                                {"line", e.line},
                                {"time_s", e.time_s},
                                {"met", e.met},
                                {"detail", e.detail}});
    const auto first = [](std::vector<std::string> violations) {
        violations.resize(std::min(violations.size(), MAX_VIOLATIONS_PRINTED));
        return violations;
    };
    const double frames_per_s =
        report.wall_s > 0 ? static_cast<double>(report.frames_shown) / report.wall_s : 0;

    Json pictures = Json::object();
    for (const auto& [number, sha256] : report.pictures) pictures[std::to_string(number)] = sha256;

    Json json = {
        {"format", REPORT_FORMAT},
        {"scenario", report.scenario},
        {"file", report.file},
        {"seed", report.seed},
        {"cpu", report.cpu},
        {"end", to_string(report.end)},
        {"interrupted", report.interrupted()},
        {"passed", report.passed()},
        {"simulated_s", report.simulated_s},
        {"frames",
         {{"shown", report.frames_shown},
          {"swapped", report.frames_swapped},
          {"last_sha256", report.last_frame_sha256},
          {"signal", report.signal},
          {"pictures", pictures}}},
        {"bus",
         {{"reads", report.bus.reads},
          {"writes", report.bus.writes},
          {"bursts", report.bus.bursts},
          {"errors", report.bus.errors}}},
        {"audio",
         {{"rate_hz", report.audio.rate_hz},
          {"samples", report.audio.samples},
          {"underruns", report.audio.underruns}}},
        {"key_events", report.key_events},
        {"final", final_json(report.shown)},
        {"shown", shown_json(report.shown)},
        {"parts", parts_json(report)},
        {"characters", characters_json(report.characters)},
        {"timing_violations",
         {{"count", report.timing_violation_count}, {"first", first(report.timing_violations)}}},
        {"sdram_violations",
         {{"count", report.sdram_violation_count}, {"first", first(report.sdram_violations)}}},
        {"expectations", expectations},
        {"faults", report.faults},
        {"log", {{"lines", report.log_lines}, {"first", report.log}}},
        {"wall", {{"seconds", report.wall_s}, {"frames_per_s", frames_per_s}}},
    };
    for (const Check& check : report.checks)
        json["checks"].push_back(
            {{"name", check.name}, {"met", check.met}, {"detail", check.detail}});
    if (report.program) json["program"] = program_json(*report.program);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_junit(const RunReport& report) {
    const std::string suite = report.scenario.empty() ? "de1sim" : report.scenario;
    const std::vector<std::string> errors = run_errors(report);
    const std::string counts =
        fmt::format("name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\"",
                    escape_markup(suite), report.expectations.size() + report.checks.size() + 1,
                    failures(report), errors.empty() ? 0 : 1, report.simulated_s);
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += "<testsuites " + counts + ">\n  <testsuite " + counts + ">\n";
    for (const auto& e : report.expectations) {
        out += test_case(suite, fmt::format("{}:{}: {}", report.file, e.line, e.step), e.time_s);
        out += verdict(e.met, e.detail);
    }
    for (const Check& check : report.checks) {
        out += test_case(suite, check.name, report.simulated_s);
        out += verdict(check.met, check.detail);
    }
    out += test_case(suite, "the run", report.simulated_s);
    if (errors.empty()) {
        out += "/>\n";
    } else {
        out += ">\n      <error message=\"" + escape_markup(errors.front()) + "\">";
        for (const auto& error : errors) out += escape_markup(error) + "\n";
        out += "</error>\n    </testcase>\n";
    }
    return out + "  </testsuite>\n</testsuites>\n";
}

}  // namespace sim
