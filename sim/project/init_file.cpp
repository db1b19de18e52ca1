// The search for a file, and the DPI functions of rtl/ip/de1sim_init.vh.

#include "sim/project/init_file.h"

#include <fmt/format.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/project/memory_image.h"
#include "sim/text/lower.h"

namespace sim::project {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

struct Search {
    InitFolders folders{".", {}};
    std::function<void(const std::string&)> missing;
    MemoryImage image{1, 0};
};

Search& search() {
    static Search only;
    return only;
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

// Verilator 5.006 loses a word at the very end of a file of $readmemh: then a copy in memory, with
// a line's end, for the process's life.
fs::path with_its_last_word(const fs::path& file) {
    std::ifstream in{file, std::ios::binary};
    std::string text{std::istreambuf_iterator<char>{in}, {}};
    if (text.empty() || !std::isxdigit(static_cast<unsigned char>(text.back()))) return file;
    const int copy = memfd_create(file.filename().c_str(), 0);
    text += '\n';
    if (copy < 0 || write(copy, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
        return file;
    return fmt::format("/proc/self/fd/{}", copy);
}

}  // namespace

std::optional<fs::path> find_init_file(std::string name, const InitFolders& folders) {
    std::replace(name.begin(), name.end(), '\\', '/');
    std::vector<fs::path> tried{folders.project / name};
    for (const fs::path& source : folders.sources) tried.push_back(source / name);
    for (const fs::path& path : tried) {
        if (is_file(path)) return path.lexically_normal();
    }
    const std::string last = fs::path(name).filename().string();
    std::vector<fs::path> alike;
    std::error_code ignored;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator at{folders.project, options, ignored}, end; at != end;
         at.increment(ignored)) {
        if (lower(at->path().filename().string()) == lower(last) && is_file(at->path())) {
            alike.push_back(at->path());
        }
    }
    if (alike.empty()) return {};
    const auto key = [&](const fs::path& path) {
        return std::make_pair(path.filename().string() != last, path);
    };
    return *std::min_element(alike.begin(), alike.end(),
                             [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

void set_init_folders(InitFolders folders, std::function<void(const std::string&)> missing) {
    search() = {std::move(folders), std::move(missing)};
}

}  // namespace sim::project

// ---- DPI ----

extern "C" int de1sim_init_file(const char* file, const char* memory, int width, int words) {
    using namespace sim::project;
    std::string name = file;
    const bool may_be_nowhere = !name.empty() && name.back() == '?';
    if (may_be_nowhere) name.pop_back();
    if (name.empty() || lower(name) == "unused" || lower(name) == "none") return 0;
    const auto found = find_init_file(name, search().folders);
    if (!found && may_be_nowhere) return 0;
    if (!found) {
        const std::string message = fmt::format(
            "{}: not found, neither from {} nor below it; expected as the initial words of {}",
            name, search().folders.project.string(), memory);
        if (!search().missing) throw std::runtime_error(message);
        search().missing(message);
        return 0;
    }
    search().image =
        read_memory_image(*found, static_cast<unsigned>(width), static_cast<std::size_t>(words));
    return 1;
}

extern "C" const char* de1sim_init_path(const char* file) {
    using namespace sim::project;
    static std::string path;
    const auto found = find_init_file(file, search().folders);
    path = found ? with_its_last_word(*found).string() : file;
    return path.c_str();
}

extern "C" int de1sim_init_part(int word, int part) {
    return static_cast<int>(sim::project::search().image.part(static_cast<std::size_t>(word),
                                                              static_cast<std::size_t>(part)));
}
