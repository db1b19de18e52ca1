// tap.cpp - TAP 13 (testanything.org)
#include "sim/report/tap.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace sim {

namespace {

bool take(std::string_view& text, std::string_view word) {
    if (text.substr(0, word.size()) != word) return false;
    text.remove_prefix(word.size());
    return true;
}

void take_blanks(std::string_view& text) {
    while (take(text, " ")) {
    }
}

std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "TODO ..." or "SKIP ...", in any case, behind the "#".
bool excuses(std::string_view directive) {
    take_blanks(directive);
    std::string word{directive.substr(0, 4)};
    for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return word == "TODO" || word == "SKIP";
}

// "not ok 3 - name: detail # directive"; number and dash may be missing.
std::optional<Check> result(std::string_view line, std::size_t number) {
    Check check;
    check.met = !take(line, "not ");
    if (!take(line, "ok") || (!line.empty() && line[0] != ' ')) return std::nullopt;
    take_blanks(line);
    while (!line.empty() && is_digit(line[0])) line.remove_prefix(1);
    take_blanks(line);
    if (take(line, "-")) take_blanks(line);
    const std::size_t hash = line.find('#');
    if (hash != line.npos && excuses(line.substr(hash + 1))) {
        check.met = true;
        line = line.substr(0, hash);
    }
    while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
    const std::size_t colon = line.find(": ");
    check.name = line.substr(0, colon);
    if (colon != line.npos) check.detail = line.substr(colon + 2);
    if (check.name.empty()) check.name = "check " + std::to_string(number);
    return check;
}

std::optional<std::size_t> plan(std::string_view line) {
    std::size_t checks = 0;
    if (!take(line, "1..")) return std::nullopt;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), checks);
    if (error != std::errc{}) return std::nullopt;
    return checks;
}

}  // namespace

std::vector<Check> tap_checks(std::string_view console) {
    while (take_line(console) != "TAP version 13")
        if (console.empty()) return {};

    std::vector<Check> checks;
    std::optional<std::size_t> planned;
    while (!console.empty()) {
        std::string_view line = take_line(console);
        if (take(line, "Bail out!")) {
            take_blanks(line);
            checks.push_back({"bail out", false, std::string{line}});
            return checks;
        }
        if (const auto count = plan(line)) planned = count;
        if (auto check = result(line, checks.size() + 1)) checks.push_back(*std::move(check));
    }
    if (planned && checks.size() != *planned)
        checks.push_back({"the plan", false,
                          std::to_string(*planned) + " checks were promised, " +
                              std::to_string(checks.size()) + " made"});
    return checks;
}

}  // namespace sim
