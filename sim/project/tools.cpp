#include "sim/project/tools.h"

#include <unistd.h>

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "sim/process/run_command.h"
#include "sim/project/compiled_headers.h"
#include "sim/project/quartus/words.h"
#include "sim/project/settings.h"
#include "sim/project/verilator.h"
#include "sim/report/whole_file.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// Of C++ that is hardly optimised: with less of it, a compiler of its own takes longer to begin.
constexpr std::uintmax_t WORTH_A_PROCESS = 500'000;
constexpr std::string_view BLANK = "\u00a0";  // one that does not end a word

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

constexpr const char* PACKAGES = "apt install verilator g++ zlib1g-dev (packages of Debian)";

// Verilator's first error, in a line: "pong.v:12: Quartus error 10170: syntax error ...".
std::string first_error(const Outcome& outcome, const std::string& tool, const TimeLimit& limit) {
    if (outcome.code == TIMED_OUT)
        return fmt::format("the build has not ended in {} s (--build-limit): {} was at work",
                           limit.seconds(), tool);
    if (outcome.code == 127) return tool + " is not installed: " + PACKAGES;
    for (const char* missing : {"zlib.h: No such file", "cannot find -lz"})
        if (outcome.output.find(missing) != std::string::npos)
            return std::string{"zlib's headers are not installed: "} + PACKAGES;
    std::istringstream lines{outcome.output};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t mark = line.find("%Error");
        if (mark != std::string::npos) {
            if (line.find("Exiting due to") != std::string::npos) continue;
            const std::size_t colon = line.find(": ", mark);
            if (colon == std::string::npos) return line;
            const auto behind =
                static_cast<std::size_t>(std::max<std::streamoff>(lines.tellg(), 0));
            return error_in_our_words(line.substr(colon + 2),
                                      std::string_view{outcome.output}.substr(behind));
        }
        if (first.empty() && line.find("error:") != std::string::npos) first = line;
    }
    return first.empty() ? fmt::format("{} ended with code {}: {}", tool, outcome.code,
                                       outcome.output.substr(0, 200))
                         : first;
}

// The model's function that looks for edges, which design.cpp calls once more at power-up, if it is
// in this file; else empty.
std::string function_for_triggers(const fs::path& source) {
    const std::string text = text_of(source);
    for (const char* name : {"___eval_triggers__act", "___eval_triggers_vec__act"}) {
        const std::string function = std::string{"Vde1sim_chip___024root"} + name;
        if (text.find("void " + function + "(") != std::string::npos) return function;
    }
    return {};
}

}  // namespace

std::string without_blanks(std::string name) {
    for (std::size_t at = 0; (at = name.find(' ', at)) != std::string::npos; at += BLANK.size())
        name.replace(at, 1, BLANK);
    return name;
}

std::string with_blanks(std::string text) {
    for (std::size_t at = 0; (at = text.find(BLANK, at)) != std::string::npos;)
        text.replace(at, BLANK.size(), " ");
    return text;
}

void link_to(const fs::path& folder, const fs::path& link) {
    std::error_code error;
    if (fs::read_symlink(link, error) == folder) return;
    fs::remove_all(link, error);  // of a copy that has the folder itself there
    fs::create_directory_symlink(folder, link);
}

std::string seen_from(const fs::path& folder, const fs::path& other, const std::string& link) {
    const fs::path wanted = fs::weakly_canonical(other);
    std::string up = "..";
    for (fs::path above = fs::weakly_canonical(folder).parent_path();; up += "/..") {
        if (above == wanted) return up;
        if (above == above.parent_path()) break;
        above = above.parent_path();
    }
    link_to(other, folder / link);
    return link;
}

bool is_writable(const fs::path& folder) { return access(folder.c_str(), W_OK) == 0; }

TimeLimit::TimeLimit(unsigned seconds)
    : seconds_{seconds}, end_{std::chrono::steady_clock::now() + std::chrono::seconds{seconds}} {}

unsigned TimeLimit::left_s() const {
    const auto left = end_ - std::chrono::steady_clock::now();
    return left.count() <= 0
               ? 0
               : static_cast<unsigned>(std::chrono::ceil<std::chrono::seconds>(left).count());
}

fs::path data_folder() { return (program_folder() / "../share/de1sim").lexically_normal(); }

fs::path library(const char* name) {
    return (program_folder() / ".." / LIBRARY_FOLDER / name).lexically_normal();
}

std::optional<fs::path> model_of(const std::string& module) {
    std::error_code error;
    for (const char* folder : {"rtl/ip", "rtl/ip/qsys"})
        if (const fs::path file = data_folder() / folder / (module + ".v");
            fs::is_regular_file(file, error))
            return file;
    return {};
}

std::string run_tool(const std::vector<std::string>& words, const fs::path& folder,
                     const TimeLimit& limit) {
    const Outcome outcome = run_command(words, folder, limit.left_s());
    if (outcome.code != 0) throw ProjectError{with_blanks(first_error(outcome, words[0], limit))};
    return outcome.output;
}

void compile_library(const fs::path& folder, const fs::path& objects, bool trace,
                     const Verilator& verilator, const TimeLimit& limit) {
    const fs::path data = data_folder();
    std::string fast, slow = "#pragma GCC optimize \"O0\"\n";  // what runs once
    std::uintmax_t slow_bytes = 0;
    std::string triggers;
    for (const auto& entry : fs::directory_iterator{objects}) {
        const std::string file = entry.path().filename().string();
        if (entry.path().extension() != ".cpp") continue;
        const bool is_slow = file.find("__Slow") != std::string::npos;
        if (triggers.empty()) triggers = function_for_triggers(entry.path());
        (is_slow ? slow : fast) += fmt::format("#include \"{}\"\n", file);
        if (is_slow) slow_bytes += entry.file_size();
    }
    if (triggers.empty())
        throw ProjectError{fmt::format(
            "Verilator {} writes models of a form that is not known here, expected 5.006 to 5.050",
            verilator.version)};
    fast += "#include \"design.cpp\"\n";
    const bool apart = slow_bytes > WORTH_A_PROCESS;
    write_whole_file(objects / "fast.cxx", apart ? fast : fast + slow);
    write_whole_file(objects / "slow.cxx", apart ? slow : "");
    const std::vector<std::string> compiler{"g++",
                                            "-std=c++17",
                                            "-O2",
                                            "-fPIC",
                                            "-DVL_TIME_CONTEXT",
                                            "-w",
                                            "-fvisibility=hidden",  // so that it can be inlined
                                            "-I" + verilator.include.string(),
                                            "-I" + (verilator.include / "vltstd").string()};
    const auto compile = [&](const std::vector<std::string>& headers) {
        std::vector<std::vector<std::string>> commands;
        for (const char* name : {"fast", "slow"}) {
            if (name[0] == 's' && !apart) continue;
            auto& command = commands.emplace_back(compiler);
            command.insert(command.end(), headers.begin(), headers.end());
            command.insert(command.end(),
                           {"-c", "-I.", "-I" + folder.string(), "-I" + (data / "project").string(),
                            fmt::format("{}.cxx", name), "-o", fmt::format("{}.o", name)});
            command.push_back("-DDE1SIM_EVAL_TRIGGERS=" + triggers);
            if (trace) command.emplace_back("-DDE1SIM_TRACE");
        }
        for (const Outcome& one : run_commands(commands, objects, limit.left_s()))
            if (one.code != 0) return one;
        return Outcome{0, {}};
    };
    const auto headers = compiled_headers(compiler, limit);
    Outcome outcome = compile(headers);
    if (outcome.code != 0 && !headers.empty()) {
        forget_compiled_headers(headers);
        outcome = compile({});
    }
    if (outcome.code != 0) throw ProjectError{first_error(outcome, "g++", limit)};
    std::vector<std::string> link{"g++", "-shared", "-o", "chip.so", "fast.o"};
    if (apart) link.emplace_back("slow.o");
    link.insert(link.end(), {runtime_library(verilator, limit).string(),
                             library("libinit_file.a").string(), "-pthread", LINK_OPTION, "-lz"});
    run_tool(link, objects, limit);
}

}  // namespace sim::project
