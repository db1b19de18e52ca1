#include "sim/verilog/file_finder.h"
#include "sim/text/lower.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace sim::project {

namespace fs = std::filesystem;

FileFinder::FileFinder(const fs::path& folder) : folder_{folder} {
    static const std::set<std::string> NOT_THESE{"db", "incremental_db", "greybox_tmp",
                                                 "simulation", "output_files"};
    constexpr std::size_t MOST = 20'000;
    std::error_code error;
    fs::recursive_directory_iterator i{folder, fs::directory_options::skip_permission_denied,
                                       error};
    for (const fs::recursive_directory_iterator end; !error && i != end; i.increment(error)) {
        const std::string name = i->path().filename().string();
        std::error_code unreadable;
        if (i->is_directory(unreadable)) {
            if (name[0] == '.' || NOT_THESE.count(name)) i.disable_recursion_pending();
        } else if (i->is_regular_file(unreadable)) {
            files_.push_back(i->path());
            if (files_.size() == MOST) break;
        }
    }
    std::sort(files_.begin(), files_.end());
    std::stable_sort(files_.begin(), files_.end(), [](const fs::path& a, const fs::path& b) {
        return std::distance(a.begin(), a.end()) < std::distance(b.begin(), b.end());
    });
    for (std::size_t n = 0; n < files_.size(); ++n)
        by_name_.emplace(lower(files_[n].filename().string()), n);
}

std::optional<FileFinder::Found> FileFinder::find(const std::string& name,
                                                  const fs::path& from) const {
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    std::error_code error;
    const fs::path direct = (from / slashes).lexically_normal();
    if (fs::is_regular_file(direct, error)) return Found{direct, name == slashes};
    // How many parts of the path's end agree, in any case.
    std::vector<std::string> wanted;
    for (const fs::path& part : fs::path{lower(slashes)}.lexically_normal())
        wanted.push_back(part.string());
    if (wanted.empty()) return {};
    const auto [begin, end] = by_name_.equal_range(wanted.back());
    const fs::path* best = nullptr;
    std::size_t most = 0;
    for (auto i = begin; i != end; ++i) {
        std::vector<std::string> parts;
        for (const fs::path& part : files_[i->second]) parts.push_back(lower(part.string()));
        std::size_t same = 0;
        while (same < parts.size() && same < wanted.size() &&
               parts[parts.size() - 1 - same] == wanted[wanted.size() - 1 - same])
            ++same;
        if (same > most) {
            most = same;
            best = &files_[i->second];
        }
    }
    if (!best) return {};
    return Found{*best, false};
}

std::vector<fs::path> FileFinder::with_name(const std::string& name) const {
    std::vector<fs::path> found;
    const auto [begin, end] = by_name_.equal_range(lower(name));
    for (auto i = begin; i != end; ++i) found.push_back(files_[i->second]);
    return found;
}

std::vector<fs::path> FileFinder::with_stem(const std::string& stem) const {
    std::vector<fs::path> found;
    for (const char* ending : {".v", ".sv", ".vhd", ".vhdl"})
        for (fs::path& file : with_name(stem + ending)) found.push_back(std::move(file));
    return found;
}

}  // namespace sim::project
