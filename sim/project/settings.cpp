#include "sim/project/settings.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "sim/project/file_finder.h"

namespace sim::project {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    constexpr std::uintmax_t MOST = 64u << 20;
    std::error_code error;
    if (fs::is_directory(file, error))
        throw ProjectError{file.string() + ": is a folder, expected a file"};
    const auto size = fs::file_size(file, error);
    if (!error && size > MOST)
        throw ProjectError{file.string() + ": larger than 64 MB, expected a source file"};
    std::ifstream in{file, std::ios::binary};
    if (!in) throw ProjectError{file.string() + ": " + std::strerror(errno)};
    return {std::istreambuf_iterator<char>{in}, {}};
}

namespace {

struct Command {
    std::vector<std::string> words;
    unsigned line;
};

// A word in [brackets] is kept with them: what the command would give is not known here.
class TclReader {
public:
    explicit TclReader(std::string_view text) : text_{text} {}

    std::vector<Command> commands() {
        std::vector<Command> all;
        while (at_ < text_.size()) {
            skip_blanks();
            Command command{{}, line_};
            if (peek() == '#') {
                while (at_ < text_.size() && peek() != '\n') ++at_;
            } else {
                while (at_ < text_.size() && peek() != '\n' && peek() != ';') {
                    command.words.push_back(word());
                    skip_blanks();
                }
            }
            next();
            if (!command.words.empty()) all.push_back(std::move(command));
        }
        return all;
    }

private:
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    char next() {
        if (at_ >= text_.size()) return '\0';
        line_ += text_[at_] == '\n';
        return text_[at_++];
    }
    bool continued() const {  // a backslash at the line's end
        if (peek() != '\\') return false;
        if (text_.compare(at_, 2, "\\\n") == 0) return true;
        return text_.compare(at_, 3, "\\\r\n") == 0;
    }
    void skip_blanks() {
        for (;;) {
            if (continued())
                while (next() != '\n') {
                }
            else if (peek() == ' ' || peek() == '\t' || peek() == '\r')
                next();
            else
                return;
        }
    }
    std::string word() {
        std::string word;
        if (peek() == '"') {
            next();
            while (at_ < text_.size() && peek() != '"' && peek() != '\n') word += next();
            if (peek() == '"') next();
            return word;
        }
        if (peek() == '{' || peek() == '[') {
            const char open = peek(), close = open == '{' ? '}' : ']';
            int depth = 0;
            do {
                const char c = next();
                depth += (c == open) - (c == close);
                word += c;
            } while (depth > 0 && at_ < text_.size());
            return open == '{' ? word.substr(1, word.size() - 2) : word;
        }
        int depth = 0;  // of brackets in the word: SW[3]
        const auto ends = [&](char c) {
            return c == '\n' || (depth <= 0 && (c == ' ' || c == '\t' || c == '\r' || c == ';'));
        };
        while (at_ < text_.size() && !ends(peek()) && !continued()) {
            depth += (peek() == '[') - (peek() == ']');
            word += next();
        }
        return word;
    }

    const std::string_view text_;
    std::size_t at_ = 0;
    unsigned line_ = 1;
};

// [file join $::quartus(qip_path) "pll.v"] -> pll.v
bool joined_to_qip(std::string& value) {
    if (value.compare(0, 10, "[file join") != 0) return false;
    const std::size_t variable = value.find("quartus(qip_path)");
    if (variable == std::string::npos) return false;
    std::string rest = value.substr(variable + 17);
    rest.erase(std::remove_if(rest.begin(), rest.end(),
                              [](char c) { return c == '"' || c == ']' || c == '}'; }),
               rest.end());
    const std::size_t begin = rest.find_first_not_of(" \t");
    const std::size_t end = rest.find_last_not_of(" \t");
    value = begin == std::string::npos ? "" : rest.substr(begin, end - begin + 1);
    return true;
}

// All values of its name and target, unless it has one itself.
void remove(std::vector<Assignment>& all, const Assignment& which) {
    const auto same = [&](const Assignment& a) {
        return a.name == which.name && a.to == which.to &&
               (which.value.empty() || a.value == which.value);
    };
    all.erase(std::remove_if(all.begin(), all.end(), same), all.end());
}

// `sourced`: how many files so far.
void read_into(std::vector<Assignment>& all, std::string_view text, const fs::path& file,
               unsigned depth, unsigned& sourced) {
    constexpr unsigned DEEPEST = 8, MOST = 1'000;
    for (const Command& command : TclReader{text}.commands()) {
        const auto& words = command.words;
        if (words[0] == "source" && words.size() > 1 && depth < DEEPEST) {
            std::error_code error;
            const fs::path other = file.parent_path() / words.back();
            if (!fs::is_regular_file(other, error)) continue;
            if (++sourced > MOST)
                throw ProjectError{
                    fmt::format("{}:{}: more than {} files are sourced; does one "
                                "source itself?",
                                file.string(), command.line, MOST)};
            read_into(all, text_of(other), other, depth + 1, sourced);
        }
        const bool parameter = words[0] == "set_parameter";
        const bool location = words[0] == "set_location_assignment";
        if (!parameter && !location && words[0] != "set_global_assignment" &&
            words[0] != "set_instance_assignment")
            continue;
        Assignment a{location ? "LOCATION" : "", "", "", file, command.line, false};
        bool disabled = false, removed = false;
        for (std::size_t i = 1; i < words.size(); ++i) {
            const std::string& word = words[i];
            if (word == "-to" && i + 1 < words.size())
                a.to = words[++i];
            else if (word == "-name" && i + 1 < words.size())
                a.name = words[++i];
            else if (word == "-disable")
                disabled = true;
            else if (word == "-remove")
                removed = true;
            else if (word.size() > 1 && word[0] == '-' && std::isalpha(word[1]) != 0 &&
                     i + 1 < words.size())
                ++i;  // -library x, -section_id y
            else if (a.value.empty())
                a.value = word;
        }
        a.in_qip_folder = joined_to_qip(a.value);
        a.to.erase(std::remove(a.to.begin(), a.to.end(), '\\'), a.to.end());  // KEY\[0\]
        if (parameter)  // whose -to names an instance
            a.to = std::exchange(a.name, a.to.empty() ? "PARAMETER" : "INSTANCE_PARAMETER");
        std::transform(a.name.begin(), a.name.end(), a.name.begin(), ::toupper);
        if (removed)
            remove(all, a);
        else if (!disabled)
            all.push_back(std::move(a));
    }
}

}  // namespace

fs::path settings_at(const fs::path& place) {
    std::error_code error;
    if (fs::is_regular_file(place, error)) {
        const std::string ending = lower(place.extension().string());
        if (ending == ".qsf") return place;
        if (ending == ".qpf") {
            fs::path qsf = place;
            qsf.replace_extension(".qsf");
            if (fs::is_regular_file(qsf, error)) return qsf;
            throw ProjectError{place.string() + ": there is no " + qsf.filename().string() +
                               " beside it"};
        }
        throw ProjectError{place.string() + ": expected a .qsf, a .qpf or a folder"};
    }
    if (!fs::is_directory(place, error)) throw ProjectError{place.string() + ": is not there"};
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator{place, error})
        if (lower(entry.path().extension().string()) == ".qsf") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    if (found.size() > 1) {
        std::string names;
        for (const fs::path& f : found)
            names += (names.empty() ? "" : ", ") + f.filename().string();
        throw ProjectError{place.string() + ": has several projects, name one: " + names};
    }
    return found.empty() ? fs::path{} : found.front();
}

std::vector<Assignment> read_settings(const fs::path& file) {
    return settings_in(text_of(file), file);
}

std::vector<Assignment> settings_in(std::string_view text, const fs::path& file) {
    std::vector<Assignment> all;
    unsigned sourced = 0;
    read_into(all, text, file, 0, sourced);
    return all;
}

}  // namespace sim::project
