// Platform Designer's systems: any text is read or refused; one of plain words is read again as it
// was.
#include "sim/project/qsys/system.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include <fmt/format.h>

#include "sim/project/settings.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

using namespace sim::project::qsys;

bool is_plain(const std::string& word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    });
}

bool is_plain(const Instance& i) {
    return is_plain(i.name) && is_plain(i.kind) &&
           std::all_of(i.parameters.begin(), i.parameters.end(),
                       [](const auto& p) { return is_plain(p.first) && is_plain(p.second); });
}

// `system` as a file, of its plain instances and what is between them.
System plain_of(const System& system, std::string& text) {
    System plain{system.file, system.name, {}, {}, {}};
    std::set<std::string> known;
    text = "<system>\n";
    for (const Instance& i : system.instances) {
        if (!is_plain(i)) continue;
        known.insert(i.name);
        plain.instances.push_back(i);
        text += fmt::format("<module name=\"{}\" kind=\"{}\">\n", i.name, i.kind);
        for (const auto& [name, value] : i.parameters)
            text += fmt::format("<parameter name=\"{}\" value=\"{}\"/>\n", name, value);
        text += "</module>\n";
    }
    for (const Connection& c : system.connections) {
        if (c.kind != Connection::Kind::AVALON || !is_plain(c.start) || !is_plain(c.end) ||
            !known.count(instance_of(c.start)) || !known.count(instance_of(c.end)))
            continue;
        plain.connections.push_back(c);
        text += fmt::format(
            "<connection kind=\"avalon\" start=\"{}\" end=\"{}\">"
            "<parameter name=\"baseAddress\">{:#x}</parameter></connection>\n",
            c.start, c.end, c.base);
    }
    text += "</system>\n";
    return plain;
}

}  // namespace

void try_qsys(std::string_view input) {
    std::string text;
    System plain;
    try {
        const System system = system_in(std::string{input}, "/no/folder/s.qsys");
        std::set<std::string> names;
        for (const Instance& i : system.instances)
            must(!i.name.empty() && !i.kind.empty() && names.insert(i.name).second,
                 "a module has a kind, and a name of its own");
        for (const Connection& c : system.connections)
            must(names.count(instance_of(c.start)) && names.count(instance_of(c.end)),
                 "a connection is between modules that are there");
        plain = plain_of(system, text);
    } catch (const sim::project::ProjectError& error) {
        return must_be_a_line(error.what());
    }
    const System again = system_in(text, plain.file);
    must(again.instances.size() == plain.instances.size() &&
             again.connections.size() == plain.connections.size(),
         "all that is written is read");
    for (std::size_t n = 0; n < plain.instances.size(); ++n)
        must(again.instances[n].name == plain.instances[n].name &&
                 again.instances[n].kind == plain.instances[n].kind &&
                 again.instances[n].parameters == plain.instances[n].parameters,
             "a module that is written is read as it was");
    for (std::size_t n = 0; n < plain.connections.size(); ++n)
        must(again.connections[n].start == plain.connections[n].start &&
                 again.connections[n].end == plain.connections[n].end &&
                 again.connections[n].base == plain.connections[n].base,
             "a connection that is written is read as it was");
}

}  // namespace fuzz
