// Quartus' settings: every text is read; assignments of plain words are read again as they were.
#include <algorithm>
#include <cctype>

#include "sim/project/settings.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

using sim::project::Assignment;

bool is_plain(const std::string& word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    });
}

}  // namespace

void try_qsf(std::string_view input) {
    const std::filesystem::path file = "/no/folder/p.qsf";
    const auto lines = static_cast<unsigned>(std::count(input.begin(), input.end(), '\n') + 1);
    std::vector<Assignment> plain;
    std::string text;
    try {
        for (const Assignment& a : sim::project::settings_in(input, file).assignments) {
            must(a.line >= 1 && a.line <= lines, "an assignment's line is in the file");
            if (!is_plain(a.name) || !is_plain(a.value) || !is_plain(a.to)) continue;
            plain.push_back(a);
            text += "set_instance_assignment -name " + a.name + " -to \"" + a.to + "\" {" +
                    a.value + "}\n";
        }
    } catch (const sim::project::ProjectError& error) {
        return must_be_a_line(error.what());
    }
    const std::vector<Assignment> again = sim::project::settings_in(text, file).assignments;
    must(again.size() == plain.size(), "all assignments that are written are read");
    for (std::size_t i = 0; i < plain.size(); ++i)
        must(again[i].name == plain[i].name && again[i].to == plain[i].to &&
                 again[i].value == plain[i].value && again[i].line == i + 1,
             "an assignment that is written is read as it was");
}

}  // namespace fuzz
