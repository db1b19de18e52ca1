// vhdl_files.h - a design's files as GHDL reads them: copies of those that are written otherwise.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace sim::project {

// InitialWords of vhdl_memories.h for what stands at `place`, "a.vhd:12".
using InitialWordsAt = std::function<std::vector<std::string>(
    const std::string& file, const std::string& place, unsigned width)>;

class VhdlFiles {
public:
    // Names are from `folder` on; the copies go into `copies`.
    VhdlFiles(std::filesystem::path folder, std::filesystem::path copies, InitialWordsAt words)
        : folder_{std::move(folder)}, copies_{std::move(copies)}, words_{std::move(words)} {}

    // The file for GHDL's command: its name, or the path of its copy.
    std::string word(const std::filesystem::path& file);
    std::string name(const std::filesystem::path& file) const;

    // What GHDL printed, with the design's own names of files, entities and signals.
    std::string in_own_names(std::string output) const;

    // Choices that GHDL refuses in `output` are written otherwise from now on.  False: none is.
    bool rewrite_choices(const std::string& output);

    // "a.vhd:14:9: ..." of a condition that stands for a choice: why; else the error itself.
    std::string cause(const std::string& error) const;

private:
    struct File {
        std::string name, text;
        std::filesystem::path copy;              // empty: there is none
        std::map<unsigned, std::string> causes;  // by the line that is written otherwise
    };
    void write(File& file);

    const std::filesystem::path folder_, copies_;
    const InitialWordsAt words_;
    std::map<std::filesystem::path, File> files_;
};

}  // namespace sim::project
