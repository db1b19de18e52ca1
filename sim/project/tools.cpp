#include "sim/project/tools.h"

#include <sstream>

#include <unistd.h>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/project/compiled_headers.h"
#include "sim/project/settings.h"
#include "sim/project/verilator.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// Of C++ that is hardly optimised: with less of it, a compiler of its own takes longer to begin.
constexpr std::uintmax_t WORTH_A_PROCESS = 500'000;

fs::path program_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
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

bool has_empty_act(const fs::path& source, const std::string& model) {
    const std::string text = text_of(source);
    const std::string name = "\nvoid " + model + "___024root___eval_act(";
    const std::size_t begin = text.find('\n', text.find(name) + 1);
    if (text.find(name) == std::string::npos || begin == std::string::npos) return false;
    std::istringstream body{text.substr(begin + 1, text.find("\n}", begin) - begin)};
    for (std::string line; std::getline(body, line);)
        if (line.find("// Prevent unused") == std::string::npos &&
            line.find("vlSymsp VL_ATTR_UNUSED = ") == std::string::npos &&
            line.find("VL_DEBUG_IF(") == std::string::npos)
            return false;
    return true;
}

void compile_library(const fs::path& folder, const fs::path& objects, bool trace,
                     const Verilator& verilator, const TimeLimit& limit) {
    const fs::path data = data_folder();
    std::string fast, slow = "#pragma GCC optimize \"O0\"\n";  // what runs once
    std::uintmax_t slow_bytes = 0;
    std::string triggers;
    bool nothing_in_act = false;
    for (const auto& entry : fs::directory_iterator{objects}) {
        const std::string file = entry.path().filename().string();
        if (entry.path().extension() != ".cpp") continue;
        const bool is_slow = file.find("__Slow") != std::string::npos;
        if (triggers.empty()) triggers = function_for_triggers(entry.path());
        nothing_in_act |= !is_slow && has_empty_act(entry.path(), "Vde1sim_chip");
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
                                            "-I" + (verilator.include / "vltstd").string(),
                                            "-I" + (data / "project").string(),
                                            "-I" + (data / "runtime").string()};
    const auto compile = [&](const std::vector<std::string>& headers) {
        std::vector<std::vector<std::string>> commands;
        for (const char* name : {"fast", "slow"}) {
            if (name[0] == 's' && !apart) continue;
            auto& command = commands.emplace_back(compiler);
            command.insert(command.end(), headers.begin(), headers.end());
            command.insert(command.end(), {"-include", "sim/verilated/triggers.h", "-c", "-I.",
                                           "-I" + folder.string(), fmt::format("{}.cxx", name),
                                           "-o", fmt::format("{}.o", name)});
            command.push_back("-DDE1SIM_EVAL_TRIGGERS=" + triggers);
            if (nothing_in_act && verilator.version == "5.006")
                command.emplace_back("-DDE1SIM_NOTHING_IN_ACT");
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
    if (outcome.code != 0) throw ProjectError{error_of(outcome, "g++", limit)};
    std::vector<std::string> link{"g++", "-shared", "-o", "chip.so", "fast.o"};
    if (apart) link.emplace_back("slow.o");
    link.insert(link.end(), {runtime_library(verilator, limit).string(),
                             library("libinit_file.a").string(), "-pthread", LINK_OPTION, "-lz"});
    run_tool(link, objects, limit);
}

}  // namespace sim::project
