// module_files.h - the files of a project, by the modules that they define.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/project/project.h"
#include "sim/verilog/file_finder.h"
#include "sim/verilog/source.h"

namespace sim::project {

// By the ending of its name; nothing: no source.
std::optional<SourceFile::Language> language_of(const std::filesystem::path& path);

class ModuleFiles {
public:
    struct Source {
        SourceFile file;
        SourceText text;
    };
    struct Definition {
        std::size_t source;  // a number for source()
        const ModuleText* module;
    };

    // `notes` gets what a person should know, a line each.
    // `macros` are those of the project, which stay where they are.
    ModuleFiles(const std::filesystem::path& folder, const std::vector<std::string>& macros,
                std::vector<std::string>& notes)
        : folder_{folder}, finder_{folder}, macros_{macros}, notes_{notes} {}

    const std::filesystem::path& folder() const { return folder_; }  // the project's
    const FileFinder& finder() const { return finder_; }
    // .v files that are found, not listed, are SystemVerilog, too.
    void take_verilog_as_system_verilog() { is_system_verilog_ = true; }
    // Its name as seen from the project's folder.
    std::string place(const std::filesystem::path& file) const;

    // Reads a file, unless it was added before or is one of Quartus' libraries for simulators.
    void add(const SourceFile& source);

    std::size_t size() const { return sources_.size(); }
    const Source& source(std::size_t n) const { return sources_[n]; }
    const std::map<std::string, Definition>& modules() const { return modules_; }
    bool is_vhdl(const Definition& d) const {
        return sources_[d.source].file.language == SourceFile::Language::VHDL;
    }
    const std::set<std::filesystem::path>& encrypted() const { return encrypted_; }

    // Null: no file defines it.  A file of the module's name is added if it is there though the
    // project does not list it.  `from_vhdl`: in any case, as VHDL has it.
    const Definition* definition(const std::string& name, bool from_vhdl = false);

    // ---- Of several files that define one module, the first that was added counts ----

    // Those definitions, by the module's name, in the order in which they were added.
    const std::map<std::string, std::vector<Definition>>& rivals() const { return rivals_; }
    // From now on the nearest to `user` does (nearest.h), which is noted.
    void choose_nearest(const std::string& module, const std::filesystem::path& user);
    // Whether it defines modules, but none that counts.
    bool is_passed_over(const Source& source) const;
    // In an order in which the first definition that a compiler reads is the one that counts.
    std::vector<std::size_t> in_order(std::set<std::size_t> sources) const;

private:
    const Definition* in_any_case(const std::string& name) const;

    const std::filesystem::path folder_;
    const FileFinder finder_;
    bool is_system_verilog_ = false;
    const std::vector<std::string>& macros_;
    std::vector<std::string>& notes_;
    std::deque<Source> sources_;  // whose modules stay where they are
    std::set<std::filesystem::path> known_, encrypted_;
    std::map<std::string, Definition> modules_;
    std::map<std::string, std::vector<Definition>> rivals_;  // of one name, in several files
};

}  // namespace sim::project
