// file_finder.h - the file that a project means by a path which need not be one here.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sim::project {

class FileFinder {
public:
    // Looks at the folder and those below once.  Hidden folders, and Quartus' own (db,
    // incremental_db, greybox_tmp, simulation, output_files), are left out; at most 20,000 files.
    explicit FileFinder(const std::filesystem::path& folder);

    // `name` as written: from `from` on, with / or \, in any case; else, as on the machine that it
    // is an absolute path of, by as much of its end as is found below the folder; at last by its
    // name alone.  `exact` says whether it was found at the place that the name says.
    struct Found {
        std::filesystem::path path;
        bool exact;
    };
    std::optional<Found> find(const std::string& name, const std::filesystem::path& from) const;

    // Files of this name, in any case.
    std::vector<std::filesystem::path> with_name(const std::string& name) const;
    // Verilog and VHDL whose name without its ending is this, in any case; those in `folder` first.
    std::vector<std::filesystem::path> with_stem(const std::string& stem) const;

    const std::vector<std::filesystem::path>& files() const { return files_; }

private:
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> files_;
    std::multimap<std::string, std::size_t> by_name_;  // in lower case
};

}  // namespace sim::project
