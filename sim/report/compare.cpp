#include "sim/report/compare.h"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "sim/report/tap.h"
#include "sim/text/printable.h"

namespace sim {

namespace {

struct Compared {
    bool passed = false;
    std::vector<Check> checks;
};

Compared read(std::string_view text, const std::string& name) {
    Compared report;
    try {
        const nlohmann::json json = nlohmann::json::parse(text);
        report.passed = json.at("passed").get<bool>();
        for (const auto& check : json.at("checks"))
            report.checks.push_back({check.at("name"), check.at("met"), check.at("detail")});
    } catch (const nlohmann::json::exception& error) {
        throw std::runtime_error(
            printable(name) + ": expected a report with checks, got: " + printable(error.what()));
    }
    return report;
}

const Check* find(const Compared& report, const std::string& name) {
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [&](const Check& check) { return check.name == name; });
    return found == report.checks.end() ? nullptr : &*found;
}

std::string result_text(const Check* check) {
    if (!check) return "no such check";
    return (check->met ? "met: " : "not met: ") + check->detail;
}

}  // namespace

std::vector<std::string> differences(std::string_view a, const std::string& name_a,
                                     std::string_view b, const std::string& name_b) {
    const Compared first = read(a, name_a), second = read(b, name_b);
    std::vector<std::string> lines;
    const auto compare = [&](const std::string& name) {
        const Check *one = find(first, name), *other = find(second, name);
        if (result_text(one) == result_text(other)) return;
        lines.push_back(printable(name) + "\n  " + printable(name_a) + ": " +
                        printable(result_text(one)) + "\n  " + printable(name_b) + ": " +
                        printable(result_text(other)));
    };
    for (const Check& check : first.checks) compare(check.name);
    for (const Check& check : second.checks)
        if (!find(first, check.name)) compare(check.name);
    if (lines.empty() && first.passed != second.passed)
        lines.push_back("passed\n  " + printable(name_a) + ": " + (first.passed ? "yes" : "no") +
                        "\n  " + printable(name_b) + ": " + (second.passed ? "yes" : "no"));
    return lines;
}

}  // namespace sim
