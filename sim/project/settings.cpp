#include "sim/project/settings.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "sim/text/lower.h"
#include "sim/text/printable.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// Whether it is a script for Quartus' shell that makes a project: its assignments are those.
bool makes_project(const fs::path& script) {
    return text_of(script).find("project_new") != std::string::npos;
}

// The revision that a .qpf names first, which is the one that Quartus opens; or none.
std::string revision_of(const std::string& qpf) {
    std::istringstream lines{qpf};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t name = line.find_first_not_of(" \t"), open = line.find('"');
        if (name == line.npos || line.compare(name, 16, "PROJECT_REVISION") != 0) continue;
        const std::size_t close = open == line.npos ? open : line.find('"', open + 1);
        if (close != line.npos) return line.substr(open + 1, close - open - 1);
    }
    return "";
}

fs::path settings_of_revision(const fs::path& qpf) {
    const std::string named = revision_of(text_of(qpf));
    const fs::path qsf =
        qpf.parent_path() / ((named.empty() ? qpf.stem().string() : named) + ".qsf");
    std::error_code error;
    if (fs::is_regular_file(qsf, error)) return qsf;
    throw ProjectError{printable(fmt::format(
        "{}: there is no {} beside it, the settings of {}", qpf.string(), qsf.filename().string(),
        named.empty() ? "the project" : "the revision that it names"))};
}

}  // namespace

fs::path settings_at(const fs::path& place) {
    std::error_code error;
    if (fs::is_regular_file(place, error)) {
        const std::string ending = lower(place.extension().string());
        if (ending == ".qsf" || (ending == ".tcl" && makes_project(place))) return place;
        if (ending == ".qpf") return settings_of_revision(place);
        throw ProjectError{place.string() +
                           ": expected a .qsf, a .qpf, a .tcl that makes a project, or a folder"};
    }
    if (!fs::is_directory(place, error)) throw ProjectError{place.string() + ": is not there"};
    std::vector<fs::path> found, scripts, projects;
    for (const auto& entry : fs::directory_iterator{place, error}) {
        const std::string ending = lower(entry.path().extension().string());
        if (ending == ".qsf") found.push_back(entry.path());
        if (ending == ".qpf") projects.push_back(entry.path());
        if (ending == ".tcl" && makes_project(entry.path())) scripts.push_back(entry.path());
    }
    if (found.empty()) found = std::move(scripts);
    std::sort(found.begin(), found.end());
    if (found.size() > 1 && projects.size() == 1) return settings_of_revision(projects.front());
    if (found.size() > 1) {
        std::string names;
        for (const fs::path& f : found)
            names += (names.empty() ? "" : ", ") + f.filename().string();
        throw ProjectError{place.string() + ": has several projects, name one: " + names};
    }
    return found.empty() ? fs::path{} : found.front();
}

}  // namespace sim::project
