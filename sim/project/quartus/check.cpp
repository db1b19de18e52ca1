#include "sim/project/quartus/check.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/project/quartus/blocks.h"
#include "sim/project/quartus/device.h"
#include "sim/project/quartus/drivers.h"
#include "sim/project/quartus/loops.h"
#include "sim/project/quartus/netlist.h"
#include "sim/project/quartus/pins.h"
#include "sim/project/settings.h"
#include "sim/verilog/file_finder.h"
#include "sim/verilog/quartus/words.h"

namespace sim::project {

namespace {

using Node = pugi::xml_node;

// The lines of the project's files.
class SourceTexts {
public:
    explicit SourceTexts(const std::filesystem::path& folder) : folder_{folder} {}

    std::string line(const std::string& file, unsigned line) {
        auto found = files_.find(file);
        if (found == files_.end()) {
            found = files_.emplace(file, std::vector<std::string>{}).first;
            try {
                std::istringstream in{text_of(folder_ / file)};
                for (std::string text; std::getline(in, text);) found->second.push_back(text);
            } catch (const ProjectError&) {  // of an included file, whose folder is not known here
            }
        }
        return line >= 1 && line <= found->second.size() ? found->second[line - 1] : "";
    }

private:
    const std::filesystem::path folder_;
    std::map<std::string, std::vector<std::string>> files_;
};

// Assignments of 32 bits, since a number without a size is in them, to fewer.
class WideAssignments {
public:
    WideAssignments(const CheckRequest& request, const Netlist& netlist)
        : request_{request}, netlist_{netlist} {}

    Messages run() {
        for (const auto& [key, module] : netlist_.modules())
            if (module.is_own) look(module.node);
        return std::move(messages_);
    }

private:
    void look(const Node& node) {
        for (const Node& child : node.children()) {
            const std::string_view kind = child.name();
            if (kind == "assign" || kind == "assigndly" || kind == "contassign")
                assignment(child);
            else
                look(child);
        }
    }
    void assignment(const Node& node) {
        const Place place = netlist_.place(node);
        const auto text = request_.texts.find(place.file);
        if (text == request_.texts.end()) return;
        const Node target = node.first_child().next_sibling();
        const unsigned width = netlist_.width(target);
        Node base = target;
        while (base && std::string_view{base.name()} != "varref") base = base.first_child();
        if (width >= 32 ||
            !text->second.of_32_bits.count({place.line, base.attribute("name").value()}))
            return;
        messages_.push_back(
            {10230, place.file, place.line,
             fmt::format("a value of 32 bits, for a number in it has no size, is cut to {}",
                         width)});
    }

    const CheckRequest& request_;
    const Netlist& netlist_;
    Messages messages_;
};

// An index outside of a range (10232) that is written there as a number; one that is computed may
// be in a branch that is never taken.
bool is_certain(const Message& message, const SourceLine& line_of_source) {
    if (message.number != 10232) return false;
    const std::string line = line_of_source(message.file, message.line);
    const std::string index = message.text.substr(0, message.text.find(' '));
    const auto has = [&](const char* before, const char* after) {
        return line.find(before + index + after) != std::string::npos;
    };
    return line.find('?') == std::string::npos && (has("[", "]") || has("[", ":") || has(":", "]"));
}

void append(Messages& all, Messages more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

// Each once, and one 10230 for a line.
void make_tidy(Messages& all) {
    std::stable_sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Message& a, const Message& b) {
                              return a == b || (a.number == 10230 && b.number == 10230 &&
                                                a.file == b.file && a.line == b.line);
                          }),
              all.end());
}

}  // namespace

Messages text_errors(const std::map<std::string, TextChecks>& texts) {
    Messages errors;
    for (const auto& [file, text] : texts) append(errors, text.errors);
    make_tidy(errors);
    return errors;
}

Checked check_design(const CheckRequest& request) {
    const Netlist netlist{request.tree_file};
    SourceTexts sources{request.project.folder};
    const SourceLine line = [&](const std::string& file, unsigned number) {
        return sources.line(file, number);
    };
    Checked checked;
    for (const auto& [file, text] : request.texts) append(checked.warnings, text.warnings);
    append(checked.errors, driver_errors(netlist));
    append(checked.errors, loop_errors(netlist, request.project.loop_limits));
    append(checked.errors, register_errors(netlist, request.project.board));
    append(checked.warnings, memory_warnings(netlist, request.project.board));
    append(checked.errors, pin_errors(request.project, request.ports));
    append(checked.warnings, pin_warnings(request.project, request.ports));
    for (Message& m : warnings_in_our_words(request.output))
        (is_certain(m, line) ? checked.errors : checked.warnings).push_back(std::move(m));
    append(checked.warnings, driver_warnings(netlist));
    append(checked.warnings, block_warnings(netlist, line));
    checked.self_reading = self_reading(netlist);
    append(checked.warnings, WideAssignments{request, netlist}.run());
    make_tidy(checked.errors);
    make_tidy(checked.warnings);
    // None of what de1sim has written for a Platform Designer system.
    checked.warnings.erase(
        std::remove_if(
            checked.warnings.begin(), checked.warnings.end(),
            [](const Message& m) { return std::filesystem::path{m.file}.extension() == ".qsys"; }),
        checked.warnings.end());
    return checked;
}

}  // namespace sim::project
