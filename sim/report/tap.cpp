// tap.cpp - TAP 13 (testanything.org)
#include "sim/report/tap.h"

#include <cctype>
#include <charconv>
#include <string_view>

namespace sim {

namespace {

bool skip(std::string_view& text, std::string_view word) {
    if (text.substr(0, word.size()) != word) return false;
    text.remove_prefix(word.size());
    return true;
}

void skip_blanks(std::string_view& text) {
    while (skip(text, " ")) {
    }
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "TODO ..." or "SKIP ...", in upper or lower case, after the "#".
bool excuses(std::string_view directive) {
    skip_blanks(directive);
    std::string word{directive.substr(0, 4)};
    for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return word == "TODO" || word == "SKIP";
}

// "not ok 3 - name: detail # directive"; number and dash may be missing.
std::optional<Check> result(std::string_view line, std::size_t number) {
    Check check;
    check.met = !skip(line, "not ");
    if (!skip(line, "ok") || (!line.empty() && line[0] != ' ')) return std::nullopt;
    skip_blanks(line);
    while (!line.empty() && is_digit(line[0])) line.remove_prefix(1);
    skip_blanks(line);
    if (skip(line, "-")) skip_blanks(line);
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
    if (!skip(line, "1..")) return std::nullopt;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), checks);
    if (error != std::errc{}) return std::nullopt;
    return checks;
}

}  // namespace

void TapReader::print(char character) {
    if (character == '\n')
        end_line();
    else if (line_.size() < LINE)
        line_ += character;
}

void TapReader::end_line() {
    std::string_view line = line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (state_ == State::BEFORE) {
        if (line == "TAP version 13") state_ = State::WITHIN;
    } else if (state_ == State::WITHIN) {
        if (skip(line, "Bail out!")) {
            skip_blanks(line);
            checks_.push_back({"bail out", false, std::string{line}});
            state_ = State::BEHIND;
        } else if (const auto count = plan(line)) {
            planned_ = count;
        } else if (auto check = result(line, made_ + 1)) {
            if (++made_ <= CHECKS) checks_.push_back(*std::move(check));
        }
    }
    line_.clear();
}

std::vector<Check> TapReader::checks() const {
    TapReader all = *this;
    all.end_line();
    if (all.state_ != State::WITHIN) return all.checks_;
    if (all.made_ > CHECKS)
        all.checks_.push_back({"the number of checks", false,
                               std::to_string(all.made_) + " were made, only the first " +
                                   std::to_string(CHECKS) + " are kept"});
    if (all.planned_ && all.made_ != *all.planned_)
        all.checks_.push_back({"the plan", false,
                               std::to_string(*all.planned_) + " checks were promised, " +
                                   std::to_string(all.made_) + " made"});
    return all.checks_;
}

}  // namespace sim
