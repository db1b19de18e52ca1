#include "sim/project/settings.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "sim/text/lower.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// Whether it is a script for Quartus' shell that makes a project: its assignments are those.
bool makes_project(const fs::path& script) {
    return text_of(script).find("project_new") != std::string::npos;
}

}  // namespace

fs::path settings_at(const fs::path& place) {
    std::error_code error;
    if (fs::is_regular_file(place, error)) {
        const std::string ending = lower(place.extension().string());
        if (ending == ".qsf" || (ending == ".tcl" && makes_project(place))) return place;
        if (ending == ".qpf") {
            fs::path qsf = place;
            qsf.replace_extension(".qsf");
            if (fs::is_regular_file(qsf, error)) return qsf;
            throw ProjectError{place.string() + ": there is no " + qsf.filename().string() +
                               " beside it"};
        }
        throw ProjectError{place.string() +
                           ": expected a .qsf, a .qpf, a .tcl that makes a project, or a folder"};
    }
    if (!fs::is_directory(place, error)) throw ProjectError{place.string() + ": is not there"};
    std::vector<fs::path> found, scripts;
    for (const auto& entry : fs::directory_iterator{place, error}) {
        const std::string ending = lower(entry.path().extension().string());
        if (ending == ".qsf") found.push_back(entry.path());
        if (ending == ".tcl" && makes_project(entry.path())) scripts.push_back(entry.path());
    }
    if (found.empty()) found = std::move(scripts);
    std::sort(found.begin(), found.end());
    if (found.size() > 1) {
        std::string names;
        for (const fs::path& f : found)
            names += (names.empty() ? "" : ", ") + f.filename().string();
        throw ProjectError{place.string() + ": has several projects, name one: " + names};
    }
    return found.empty() ? fs::path{} : found.front();
}

}  // namespace sim::project
