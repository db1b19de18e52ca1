// What a VHDL file defines: no text is refused, and both views of its entities agree.  What is
// written otherwise for GHDL has as many lines.
#include <algorithm>
#include <set>

#include "sim/vhdl/vhdl_choices.h"
#include "sim/vhdl/vhdl_dialect.h"
#include "sim/vhdl/vhdl_memories.h"
#include "sim/vhdl/vhdl_source.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

auto lines_of(std::string_view text) { return std::count(text.begin(), text.end(), '\n'); }

void try_rewriting(const std::string& input) {
    const std::string read = sim::project::as_ghdl_takes_it(input);
    must(lines_of(read) == lines_of(input), "the dialect keeps lines");
    const std::string filled = sim::project::with_initial_words(
        read,
        [](const std::string&, unsigned, unsigned) { return std::vector<std::string>{"01"}; });
    must(lines_of(filled) == lines_of(input), "initial words keep lines");
    std::set<unsigned> all;
    for (unsigned line = 1; line <= lines_of(filled) + 1; ++line) all.insert(line);
    if (const auto rewritten = sim::project::choices_as_conditions(filled, all, all))
        must(lines_of(rewritten->text) == lines_of(input), "conditions keep lines");
}

}  // namespace

void try_vhdl(std::string_view input) {
    try_rewriting(std::string{input});
    const auto heads = sim::project::entities_in(input);
    auto head = heads.begin();
    for (const auto& module : sim::project::scan_vhdl(input).modules) {
        must(!module.name.empty(), "what is defined has a name");
        if (module.is_package) continue;
        must(head != heads.end() && head->name == module.name, "an entity has a head");
        must(head->ports.size() == module.ports.size(), "a head has the entity's ports");
        for (const auto& port : head->ports) must(!port.name.empty(), "a port has a name");
        for (const auto& generic : head->generics)
            must(!generic.name.empty(), "a generic has a name");
        ++head;
    }
    must(head == heads.end(), "a head is an entity's");
    if (!heads.empty())
        must(sim::project::entity_in(input, heads.back().name).has_value(), "an entity is found");
}

}  // namespace fuzz
