#include "sim/project/vhdl.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/project/command.h"
#include "sim/project/file_finder.h"
#include "sim/project/settings.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// Words and symbols in lower case but for names, without comments.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text.compare(i, 2, "--") == 0) {
            i = std::min(text.find('\n', i), text.size());
        } else if (in_word(text[i])) {
            const std::size_t begin = i;
            while (i < text.size() && in_word(text[i])) ++i;
            words.emplace_back(text.substr(begin, i - begin));
        } else {
            if (!std::isspace(static_cast<unsigned char>(text[i]))) words.emplace_back(1, text[i]);
            ++i;
        }
    }
    return words;
}

class VhdlScanner {
public:
    explicit VhdlScanner(std::string_view text) : words_{words_of(text)} {}

    SourceText run() {
        std::set<std::string> wants;  // of all architectures in the file
        for (std::size_t i = 0; i + 3 < words_.size(); ++i) {
            const bool ends = i > 0 && is(i - 1, "end");
            if (is(i, "entity") && is(i + 2, "is"))
                entity(i + 1);
            else if (is(i, "package") && !is(i + 1, "body") && is(i + 2, "is"))
                source_.modules.push_back({words_[i + 1], 0, {}, {}, true, {}, {}, {}});
            else if (is(i, "component") && !ends)
                wants.insert(words_[i + 1]);
            else if (is(i, "work") && words_[i + 1] == ".")
                wants.insert(words_[i + 2]);
        }
        for (ModuleText& module : source_.modules) module.wants = wants;
        return std::move(source_);
    }

private:
    bool is(std::size_t i, const char* word) const { return lower(words_[i]) == word; }

    // Up to its end: port ( a, b : in std_logic; ... ).
    void entity(std::size_t name) {
        source_.modules.push_back({words_[name], 0, {}, {}, false, {}, {}, {}});
        std::size_t i = name + 2;
        while (i < words_.size() && !is(i, "port") && !is(i, "end")) ++i;
        int depth = 0;
        bool names = true;
        for (++i; i < words_.size(); ++i) {
            depth += (words_[i] == "(") - (words_[i] == ")");
            if (depth <= 0) return;
            if (depth == 1 && words_[i] == ":") names = false;
            if (depth == 1 && words_[i] == ";") names = true;
            const char first = words_[i][0];
            if (names && std::isalpha(static_cast<unsigned char>(first)) && !is(i, "signal"))
                source_.modules.back().ports.push_back(words_[i]);
        }
    }

    const std::vector<std::string> words_;
    SourceText source_;
};

// GHDL's first error, or what it says instead: "top.vhd:14:2: no declaration for "x"".
std::string first_error(const std::string& said) {
    std::istringstream lines{said};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (first.empty()) first = line;
        const std::size_t colon = line.find(':');
        const bool has_place = colon != std::string::npos && colon + 1 < line.size() &&
                               std::isdigit(static_cast<unsigned char>(line[colon + 1]));
        if (has_place && line.find(":warning:") == std::string::npos) return line;
    }
    return "ghdl: " + first;
}

std::string run_ghdl(std::vector<std::string> words, const fs::path& folder,
                     const TimeLimit& limit) {
    words.insert(words.begin(), "ghdl");
    const Outcome outcome = run_command(words, folder, limit.left_s());
    if (outcome.code == 127)
        throw ProjectError{
            "the project has VHDL, for which ghdl is not installed: apt install ghdl"};
    if (outcome.code == TIMED_OUT)
        throw ProjectError{fmt::format(
            "the build has not ended in {} s (--build-limit): ghdl was at work", limit.seconds())};
    if (outcome.code != 0) throw ProjectError{first_error(outcome.output)};
    return outcome.output;
}

// Verilator sees an enable only in the expression that drives a pin, where GHDL has a chain of
// wires: those that have a z are put in the place of their names.
std::string with_enables(const std::string& module) {
    std::istringstream lines{module};
    std::vector<std::string> text;
    for (std::string line; std::getline(lines, line);) text.push_back(line);
    const auto is_name = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    const std::string assign = "  assign ";
    std::set<std::string> wires;
    for (const std::string& line : text)
        if (line.compare(0, 7, "  wire ") == 0)
            wires.insert(line.substr(line.rfind(' ') + 1, line.size() - line.rfind(' ') - 2));
    for (std::size_t from = 0; from < text.size(); ++from) {
        const std::string line = text[from];
        const std::size_t equals = line.find(" = "), end = line.find(';');
        if (line.compare(0, assign.size(), assign) != 0 || end == std::string::npos ||
            line.find("'bZ") > end)
            continue;
        const std::string name = line.substr(assign.size(), equals - assign.size());
        if (wires.count(name) == 0) continue;  // a port
        const std::string value = "(" + line.substr(equals + 3, end - equals - 3) + ")";
        bool used = false;
        for (std::string& other : text) {
            if (other.compare(0, assign.size(), assign) != 0) continue;
            for (std::size_t at = other.find(" = "); (at = other.find(name, at)) < other.find(';');
                 at += value.size()) {
                const std::size_t behind = at + name.size();
                if (is_name(other[at - 1]) || is_name(other[behind])) break;
                other.replace(at, name.size(), value);
                used = true;
            }
        }
        if (!used) continue;
        text[from].clear();
        from = static_cast<std::size_t>(-1);  // what uses it may itself be used before
    }
    std::string joined;
    for (const std::string& line : text) joined += line + "\n";
    return joined;
}

// The modules of what GHDL writes; its warnings come before the first one.
class VerilogText {
public:
    VerilogText(const VhdlDesign& design, const std::string& root, const std::string& text)
        : design_{design}, root_{root} {
        for (std::size_t at = text.compare(0, 7, "module ") == 0 ? 0 : next(text, 0);
             at != std::string::npos;) {
            const std::size_t end = text.find("\nendmodule\n", at);
            if (end == std::string::npos) break;
            take(text.substr(at, end + 11 - at));
            at = next(text, end);
        }
    }

    std::string without(std::set<std::string>& known) const {
        std::string text;
        for (const auto& [name, body] : modules_)
            if (known.insert(name).second) text += with_enables(renamed(body)) + "\n";
        return text;
    }

private:
    static std::size_t next(const std::string& text, std::size_t from) {
        const std::size_t at = text.find("\nmodule ", from);
        return at == std::string::npos ? at : at + 1;
    }

    // A component without an entity has nothing between its ports and its end.
    void take(std::string module) {
        std::string name = module.substr(7, module.find_first_of(" \n(", 7) - 7);
        if (lower(name) == lower(root_)) {  // as it is written where it is wanted
            module.replace(7, name.size(), root_);
            name = root_;
        }
        const std::size_t ports = module.find(");\n");
        if (ports == std::string::npos || module.compare(ports + 3, 9, "endmodule") != 0) {
            modules_.emplace_back(name, std::move(module));
            return;
        }
        const std::string in_verilog = design_.in_verilog(name);
        if (in_verilog.empty())
            throw ProjectError{fmt::format("component {}: no file defines it", name)};
        if (in_verilog != name) names_.emplace_back("\n  " + name + " ", "\n  " + in_verilog + " ");
    }

    std::string renamed(std::string body) const {
        for (const auto& [from, to] : names_)
            for (std::size_t at = 0; (at = body.find(from, at)) != std::string::npos;)
                body.replace(at, from.size(), to);
        return body;
    }

    const VhdlDesign& design_;
    const std::string root_;
    std::vector<std::pair<std::string, std::string>> modules_, names_;
};

}  // namespace

SourceText scan_vhdl(std::string_view text) { return VhdlScanner{text}.run(); }

std::vector<std::string> verilog_of(const VhdlDesign& design, const TimeLimit& limit) {
    std::error_code error;
    fs::remove_all(design.work, error);
    fs::create_directories(design.work);
    // As much as Quartus takes: the libraries of Synopsys, shared variables, undriven outputs.
    const std::vector<std::string> options{"--std=08", "-fsynopsys", "-frelaxed",
                                           "--workdir=" + design.work.string(),
                                           "-P" + design.work.string()};
    const auto words = [&options](std::vector<std::string> first,
                                  const std::vector<std::string>& last) {
        first.insert(first.end(), options.begin(), options.end());
        first.insert(first.end(), last.begin(), last.end());
        return first;
    };
    for (const auto& library : fs::directory_iterator{design.libraries})
        run_ghdl(
            words({"-a", "--work=" + library.path().stem().string()}, {library.path().string()}),
            design.folder, limit);
    std::vector<std::string> files;
    for (const fs::path& file : design.files)
        files.push_back(file.lexically_relative(design.folder).string());
    run_ghdl(words({"-i"}, files), design.folder, limit);
    std::set<std::string> known;
    std::vector<std::string> texts;
    for (const std::string& root : design.roots) {
        const std::string said =
            run_ghdl(words({"--synth", "--out=verilog"}, {root}), design.folder, limit);
        texts.push_back(VerilogText{design, root, said}.without(known));
    }
    return texts;
}

}  // namespace sim::project
