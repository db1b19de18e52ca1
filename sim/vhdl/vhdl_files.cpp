#include "sim/vhdl/vhdl_files.h"

#include <optional>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/verilog/project_error.h"
#include "sim/vhdl/vhdl_choices.h"
#include "sim/vhdl/vhdl_dialect.h"
#include "sim/vhdl/vhdl_memories.h"
#include "sim/vhdl/vhdl_tokens.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// "a.vhd:14:9: choice is not locally static"
struct GhdlMessage {
    std::string name;
    unsigned line, column;
    std::string what;
};
std::optional<GhdlMessage> message_in(const std::string& line) {
    static const std::regex PLACE{"^(.+?):([0-9]{1,9}):([0-9]{1,9}): ?(error: ?)?(.*)$"};
    std::smatch m;
    if (!std::regex_match(line, m, PLACE)) return {};
    const auto number = [&m](std::size_t n) { return static_cast<unsigned>(std::stoul(m[n])); };
    return GhdlMessage{m[1], number(2), number(3), m[5]};
}

// As GHDL counts, from 1, with tabs to the next eighth.
unsigned column_of(const Token& token, const std::string& text) {
    const std::size_t at = static_cast<std::size_t>(token.text.data() - text.data());
    unsigned column = 1;
    for (std::size_t i = text.rfind('\n', at) + 1; i < at; ++i)
        column = text[i] == '\t' ? (column + 7) / 8 * 8 + 1 : column + 1;
    return column;
}

// Of a statement that is written with conditions, or that has some: not in what it does then.
bool is_in_condition(const std::string& text, unsigned line, unsigned column) {
    const Tokens tokens = vhdl_tokens(text);
    const std::vector<std::string> low = in_lower_case(tokens.all);
    bool is_in = false;
    for (std::size_t i = 0; i < low.size(); ++i) {
        const Token& token = tokens.all[i];
        if (token.line > line || (token.line == line && column_of(token, text) > column)) break;
        if (low[i] == "if" || low[i] == "elsif" || low[i] == "when") is_in = true;
        if (low[i] == "then" || low[i] == "else" || low[i] == ";") is_in = false;
    }
    return is_in;
}

}  // namespace

std::string VhdlFiles::name(const fs::path& file) const {
    return file.lexically_relative(folder_).string();
}

std::string VhdlFiles::word(const fs::path& path) {
    auto found = files_.find(path);
    if (found == files_.end()) {
        const std::string text = text_of(path), own_name = name(path);
        const std::string read = with_initial_words(
            as_ghdl_takes_it(text), [&](const std::string& file, unsigned line, unsigned width) {
                return words_(file, fmt::format("{}:{}", own_name, line), width);
            });
        found = files_.emplace(path, File{own_name, read, {}, {}}).first;
        if (read != text) write(found->second);
    }
    const File& file = found->second;
    return file.copy.empty() ? file.name : file.copy.string();
}

void VhdlFiles::write(File& file) {
    if (file.copy.empty()) {
        const fs::path folder = copies_ / std::to_string(files_.size());
        fs::create_directories(folder);
        file.copy = folder / fs::path{file.name}.filename();
    }
    write_whole_file(file.copy, file.text);
}

std::string VhdlFiles::in_own_names(std::string output) const {
    for (const auto& [path, file] : files_) {
        if (file.copy.empty()) continue;
        const std::string copy = file.copy.string();
        for (std::size_t at = 0; (at = output.find(copy, at)) != std::string::npos;)
            output.replace(at, copy.size(), file.name);
    }
    return with_own_names(output);
}

bool VhdlFiles::rewrite_choices(const std::string& output) {
    std::map<std::string, std::map<unsigned, std::string>> refused;  // by file and line
    std::map<std::string, std::set<unsigned>> incomplete;
    std::istringstream lines{output};
    for (std::string line; std::getline(lines, line);) {
        const auto message = message_in(line);
        if (!message) continue;
        const bool is_incomplete = message->what.rfind("missing choice(s)", 0) == 0,
                   is_static = message->what.rfind("choice ", 0) != 0 ||
                               message->what.find("locally static") == std::string::npos;
        if (is_static && !is_incomplete) continue;
        refused[message->name].emplace(message->line, line);
        if (is_incomplete) incomplete[message->name].insert(message->line);
    }
    bool is_new = false;
    for (auto& [path, file] : files_) {
        const auto found = refused.find(file.name);
        if (found == refused.end()) continue;
        const std::set<unsigned>& missing = incomplete[file.name];
        std::set<unsigned> numbers;
        for (const auto& [number, line] : found->second)
            if (!missing.count(number)) numbers.insert(number);
        const auto rewritten = choices_as_conditions(file.text, numbers, missing);
        if (!rewritten) continue;
        file.text = rewritten->text;
        for (const unsigned line : rewritten->lines) {
            auto cause = found->second.upper_bound(line);
            if (cause != found->second.begin()) --cause;
            file.causes.emplace(line, cause->second);
        }
        write(file);
        is_new = true;
    }
    return is_new;
}

std::string VhdlFiles::cause(const std::string& error) const {
    const auto message = message_in(error);
    if (!message) return error;
    for (const auto& [path, file] : files_) {
        const auto cause = file.causes.find(message->line);
        if (file.name != message->name || cause == file.causes.end()) continue;
        if (is_in_condition(file.text, message->line, message->column)) return cause->second;
        return fmt::format("{}:{}: {}", message->name, message->line,
                           message->what);  // without the column
    }
    return error;
}

}  // namespace sim::project
