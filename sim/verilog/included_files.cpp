#include "sim/verilog/included_files.h"

#include <regex>
#include <set>

#include "sim/verilog/file_finder.h"
#include "sim/verilog/project_error.h"
#include "sim/verilog/synthesised.h"

namespace sim::project {

namespace fs = std::filesystem;

std::vector<IncludedFile> included_files(const std::vector<std::string>& texts,
                                         const std::vector<fs::path>& folders,
                                         const std::vector<std::string>& macros) {
    static const std::regex DIRECTIVE{"`include[ \t]*\"([^\"\n]+)\""};
    std::vector<IncludedFile> found;
    std::set<std::string> seen;
    const auto look_in = [&](const std::string& text) {
        for (std::sregex_iterator at{text.begin(), text.end(), DIRECTIVE}, end; at != end; ++at) {
            const std::string name = (*at)[1];
            if (!seen.insert(name).second) continue;
            for (const fs::path& folder : folders) {
                const fs::path path = folder / name;
                std::error_code error;
                if (!fs::is_regular_file(path, error)) continue;
                std::string whole = text_of(path);
                std::string read = as_synthesised(whole, macros);
                found.push_back({name, path, std::move(whole), std::move(read)});
                break;
            }
        }
    };
    for (const std::string& text : texts) look_in(text);
    for (std::size_t n = 0; n < found.size(); ++n) look_in(std::string{found[n].synthesised});
    return found;
}

}  // namespace sim::project
