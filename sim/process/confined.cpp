#include "sim/process/confined.h"

#include <cstdlib>
#include <stdexcept>

#include "sim/process/run_command.h"

namespace sim {

namespace {

namespace fs = std::filesystem;

constexpr unsigned PROBE_S = 10;
constexpr std::uint64_t MOST_PROCESSES = 256;

// Where this program is installed, or built: there its data are links to its sources.
std::vector<fs::path> program_folders() {
    const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
    std::vector<fs::path> folders;
    for (const char* name : {"bin", "examples", "lib", "libexec", "share"})
        folders.push_back(prefix / name);
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator{prefix / "share" / "de1sim", error})
        if (entry.is_symlink()) folders.push_back(fs::canonical(entry.path()));
    return folders;
}

// /lib and its like are links into /usr, or folders.
void add_system(std::vector<std::string>& command) {
    const auto add = [&](std::initializer_list<std::string> more) {
        command.insert(command.end(), more);
    };
    add({"--ro-bind", "/usr", "/usr"});
    for (const char* folder : {"/bin", "/lib", "/lib64", "/sbin"}) {
        std::error_code error;
        if (fs::is_symlink(folder, error))
            add({"--symlink", fs::read_symlink(folder).string(), folder});
        else
            add({"--ro-bind-try", folder, folder});
    }
    for (const char* place : {"/opt", "/etc/alternatives", "/etc/ld.so.cache"})
        add({"--ro-bind-try", place, place});
    add({"--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev"});
}

}  // namespace

std::vector<std::string> confined(const std::vector<std::string>& command,
                                  const Confinement& confinement) {
    const std::string here = fs::current_path().string();
    const char* path = std::getenv("PATH");
    std::vector<std::string> all{"bwrap", "--unshare-all", "--die-with-parent", "--new-session",
                                 "--clearenv"};
    const auto add = [&](std::initializer_list<std::string> more) { all.insert(all.end(), more); };
    add({"--setenv", "PATH", path ? path : "/usr/bin:/bin", "--setenv", "HOME", "/tmp"});
    add({"--setenv", "LANG", "C.UTF-8"});
    add_system(all);
    const std::string size = std::to_string(confinement.file_bytes);
    const auto bind = [&](const char* option, const fs::path& folder) {
        const std::string name = fs::absolute(folder).lexically_normal().string();
        add({option, name, name});
    };
    add({"--size", size, "--tmpfs", "/tmp"});
    for (const fs::path& folder : program_folders()) bind("--ro-bind-try", folder);
    for (const fs::path& folder : confinement.readable) bind("--ro-bind-try", folder);
    if (const fs::path& cache = confinement.cache; !cache.empty()) {
        bind("--ro-bind", cache);
        add({"--setenv", "XDG_CACHE_HOME", cache.parent_path().string()});
    }
    for (const fs::path& folder : confinement.hidden)
        add({"--size", size, "--tmpfs", fs::absolute(folder).lexically_normal().string()});
    for (const fs::path& folder : confinement.writable) bind("--bind", folder);
    add({"--dir", here, "--chdir", here, "--", "prlimit", "--core=0"});
    add({"--data=" + std::to_string(confinement.memory_bytes), "--fsize=" + size});
    add({"--nproc=" + std::to_string(MOST_PROCESSES), "--"});
    all.insert(all.end(), command.begin(), command.end());
    return all;
}

void check_confinement() {
    constexpr std::uint64_t PROBE_BYTES = 1u << 30;
    const Outcome outcome =
        run_command(confined({"true"}, {{}, {}, {}, {}, PROBE_BYTES, PROBE_BYTES}), ".", PROBE_S);
    if (outcome.code == 0) return;
    const std::string cause = outcome.code == 127 && outcome.output.empty()
                                  ? "which is not installed (Debian's package bubblewrap)"
                                  : "which cannot do it here: " + outcome.last_line();
    throw std::runtime_error{"--hand-ins: hand-ins are run confined by bwrap, " + cause +
                             "; --unconfined runs them with all rights of yours"};
}

}  // namespace sim
