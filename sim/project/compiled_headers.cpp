#include "sim/project/compiled_headers.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "sim/files/sha256.h"
#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/project/folder_lock.h"
#include "sim/project/settings.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

constexpr const char* HEADERS =
    "#include \"sim/verilated/triggers.h\"\n#include \"verilated_dpi.h\"\n#include <memory>\n";
constexpr const char* NOTES = ".notes";
constexpr std::size_t MAX_NOTES = 1 << 20;

std::string variable(const char* name) {
    const char* text = std::getenv(name);
    return text ? text : "";
}

// A file as it was read: if it is replaced, this line is another.  Empty: there is none.
std::string note_of(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error) return "";
    const auto time = fs::last_write_time(file, error).time_since_epoch().count();
    return error ? "" : fmt::format("{} {} {}\n", size, time, file.string());
}

std::string note_of_program(const std::string& name) {
    std::istringstream folders{variable("PATH")};
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::error_code error;
        const fs::path program = fs::canonical(fs::path{folder} / name, error);
        if (!error) return note_of(program);
    }
    return "";
}

// Those in "x.gch: /usr/include/a.h \", as -MD writes them: a backslash before a space that is in
// a name, or before the end of a line.
std::vector<fs::path> files_of_rule(const std::string& rule) {
    std::vector<fs::path> files;
    std::string name;
    for (std::size_t n = std::min(rule.size(), rule.find(": ") + 2); n < rule.size(); ++n) {
        const bool escaped = rule[n] == '\\' && n + 1 < rule.size();
        if (escaped) ++n;
        if (rule[n] == '\n' || (rule[n] == ' ' && !escaped)) {
            if (!name.empty()) files.emplace_back(std::exchange(name, {}));
        } else {
            name += rule[n];
        }
    }
    return files;
}

// Whether each of the noted files is as it was.
bool is_true(const fs::path& notes) {
    try {
        std::istringstream lines{read_whole_file(notes, MAX_NOTES)};
        bool any = false;
        for (std::string line; std::getline(lines, line); any = true) {
            std::istringstream words{line};
            std::string size, time, file;
            if (!(words >> size >> time) || !std::getline(words >> std::ws, file)) return false;
            if (note_of(file) != line + "\n") return false;
        }
        return any;
    } catch (const IoError&) {
        return false;
    }
}

// `header`.gch, beside it; the notes, which make it valid, come last.
bool precompile(const std::vector<std::string>& compiler, const fs::path& header,
                const fs::path& notes, const TimeLimit& limit) {
    const std::string name = header.filename().string();
    const fs::path made = header.string() + ".gch";
    write_whole_file(header, HEADERS);
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{header.parent_path()})
        if (const std::string kind = entry.path().extension(); kind == ".gch" || kind == NOTES)
            fs::remove(entry.path(), error);  // of other compilers: each is of 60 MB
    auto command = compiler;
    command.insert(command.end(), {"-x", "c++-header", name, "-o", "new", "-MD", "-MF", "rule"});
    if (run_command(command, header.parent_path(), limit.left_s()).code != 0) return false;
    std::string all;
    for (const fs::path& file :
         files_of_rule(read_whole_file(header.parent_path() / "rule", MAX_NOTES))) {
        const std::string note = note_of(header.parent_path() / file);  // itself, if it is absolute
        if (note.empty()) return false;
        all += note;
    }
    fs::rename(header.parent_path() / "new", made);
    write_whole_file(notes, all + note_of(made));
    return true;
}

}  // namespace

fs::path user_cache() {
    const std::string cache = variable("XDG_CACHE_HOME"), home = variable("HOME");
    if (!cache.empty()) return fs::path{cache} / "de1sim";
    return home.empty() ? fs::path{} : fs::path{home} / ".cache" / "de1sim";
}

std::vector<std::string> compiled_headers(const std::vector<std::string>& compiler,
                                          const TimeLimit& limit) {
    if (user_cache().empty()) return {};
    std::string key = note_of_program(compiler[0]);
    if (key.empty()) return {};
    for (const std::string& word : compiler) key += word + "\n";
    for (const char* name : {"CPATH", "CPLUS_INCLUDE_PATH"}) key += variable(name) + "\n";
    const fs::path folder = user_cache() / "headers";
    const fs::path header = folder / (sha256_hex(key.data(), key.size()).substr(0, 16) + ".h");
    const fs::path notes = header.string() + NOTES;
    try {
        fs::create_directories(folder);
        FolderLock lock;
        if (!is_true(notes)) lock.acquire(folder / "lock");
        if (!is_true(notes) && !precompile(compiler, header, notes, limit)) return {};
        return {"-include", header.string()};
    } catch (const std::exception&) {  // of a cache that cannot be written to
        return {};
    }
}

void forget_compiled_headers(const std::vector<std::string>& command) {
    std::error_code error;
    if (!command.empty()) fs::remove(command.back() + NOTES, error);
}

}  // namespace sim::project
