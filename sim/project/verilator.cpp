#include "sim/project/verilator.h"

#include <cstdio>

#include <fmt/format.h>

#include "sim/files/sha256.h"
#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/project/compiled_headers.h"
#include "sim/project/folder_lock.h"
#include "sim/project/settings.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

constexpr const char* RUNTIME = "libdesign_runtime.a";
constexpr const char* RUNTIME_SOURCES[] = {"analog.cpp",      "bridge.cpp",  "endings.cpp",
                                           "jtag.cpp",        "masters.cpp", "model.cpp",
                                           "peripherals.cpp", "plls.cpp"};
constexpr unsigned OLDEST_MAJOR = 5, OLDEST_MINOR = 6;

std::string version_of(const std::string& output) {
    const std::size_t begin = output.find(' ') + 1;
    return output.substr(begin, output.find(' ', begin) - begin);
}

bool is_too_old(const std::string& version) {
    unsigned major = 0, minor = 0;
    if (std::sscanf(version.c_str(), "%u.%u", &major, &minor) != 2) return true;
    return major < OLDEST_MAJOR || (major == OLDEST_MAJOR && minor < OLDEST_MINOR);
}

fs::path compile_runtime(const Verilator& verilator, const fs::path& folder,
                         const TimeLimit& limit) {
    const fs::path sources = data_folder() / "runtime", own = sources / "sim/project/runtime";
    std::vector<std::vector<std::string>> commands;
    std::vector<std::string> archive{"ar", "rcs", "new.a"};
    std::vector<fs::path> files;
    for (const char* name :
         {"verilated.cpp", "verilated_dpi.cpp", "verilated_threads.cpp", "verilated_fst_c.cpp"})
        files.push_back(verilator.include / name);
    for (const char* name : RUNTIME_SOURCES) files.push_back(own / name);
    for (const fs::path& source : files) {
        archive.push_back(source.stem().string() + ".o");
        commands.push_back(
            {"g++", "-std=c++17", "-O2", "-fPIC", "-w", "-DVL_TIME_CONTEXT", "-DVL_USER_FINISH",
             "-DVL_USER_STOP", "-DVL_USER_FATAL", "-DVL_USER_WARN", "-I" + sources.string(),
             "-I" + verilator.include.string(), "-I" + (verilator.include / "vltstd").string(),
             "-c", source.string(), "-o", archive.back()});
    }
    const std::vector<Outcome> outcomes = run_commands(commands, folder, limit.left_s());
    for (std::size_t n = 0; n < outcomes.size(); ++n)
        if (outcomes[n].code != 0) run_tool(commands[n], folder, limit);  // says why
    run_tool(archive, folder, limit);
    for (std::size_t n = 3; n < archive.size(); ++n) fs::remove(folder / archive[n]);
    return folder / "new.a";
}

}  // namespace

Verilator find_verilator(const TimeLimit& limit) {
    const std::string output = run_tool({"verilator", "--version"}, "/", limit);
    Verilator found{version_of(output), VERILATOR_INCLUDE};
    if (is_too_old(found.version))
        throw ProjectError{
            fmt::format("Verilator {} is installed, expected {}.{:03} or a later one",
                        found.version, OLDEST_MAJOR, OLDEST_MINOR)};
    std::error_code error;
    if (found.version == VERILATOR_VERSION && fs::exists(found.include, error)) return found;
    const std::string root = run_tool({"verilator", "--getenv", "VERILATOR_ROOT"}, "/", limit);
    found.include = fs::path{root.substr(0, root.find('\n'))} / "include";
    return found;
}

fs::path runtime_library(const Verilator& verilator, const TimeLimit& limit) {
    if (verilator.version == VERILATOR_VERSION) return library(RUNTIME);
    std::string key = verilator.version + verilator.include.string() +
                      text_of(data_folder() / "runtime/sim/pins/chip_wires.def");
    for (const char* name : RUNTIME_SOURCES)
        key += text_of(data_folder() / "runtime/sim/project/runtime" / name);
    const fs::path below = fs::path{"runtime"} / sha256_hex(key.data(), key.size()).substr(0, 16);
    fs::path folder = user_cache() / below;
    std::error_code error;
    if (!user_cache().empty() && fs::is_regular_file(folder / RUNTIME, error))
        return folder / RUNTIME;  // the cache may be read-only
    fs::create_directories(folder, error);
    if (user_cache().empty() || !is_writable(folder)) {
        folder = fs::temp_directory_path() / "de1sim" / below;
        fs::create_directories(folder);
    }
    const fs::path file = folder / RUNTIME;
    FolderLock lock;
    lock.acquire(folder / "lock");
    if (!fs::is_regular_file(file, error))
        fs::rename(compile_runtime(verilator, folder, limit), file);
    return file;
}

}  // namespace sim::project
