#include "sim/project/power_up.h"

#include <string>
#include <vector>

#include "sim/project/settings.h"
#include "sim/report/whole_file.h"

namespace sim::project {

namespace {

namespace fs = std::filesystem;

// Where the body of this function begins and ends, in its definition; npos: it is not here.
struct Body {
    std::size_t begin = std::string::npos, end = 0;
};
Body body_of(const std::string& text, const std::string& function) {
    const std::size_t name =
        text.find("\nVL_ATTR_COLD void Vde1sim_chip___024root___" + function + "(");
    if (name == std::string::npos) return {};
    const std::size_t begin = text.find('{', name);
    if (begin > text.find(';', name)) return {};  // a declaration
    return {begin, text.find("\n}", begin)};
}

}  // namespace

void forget_edges_of_power_up(const fs::path& objects) {
    std::string remember;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{objects})
        if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    for (const fs::path& file : files) {
        const std::string text = text_of(file);
        const Body initial = body_of(text, "eval_initial");
        if (initial.begin == std::string::npos) continue;
        for (std::size_t at = initial.begin;
             (at = text.find("vlSelf->__Vtrigrprev__", at)) < initial.end;) {
            const std::size_t end = text.find(';', at) + 1;
            remember += "    " + text.substr(at, end - at) + "\n";
            at = end;
        }
    }
    for (const fs::path& file : files) {
        std::string text = text_of(file);
        const Body settle = body_of(text, "eval_settle");
        if (settle.begin == std::string::npos) continue;
        write_whole_file(file, text.insert(settle.end + 1, remember));
    }
}

}  // namespace sim::project
