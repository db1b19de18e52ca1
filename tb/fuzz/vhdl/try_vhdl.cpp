// What a VHDL file defines: no text is refused, and both views of its entities agree.
#include "sim/vhdl/vhdl_source.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

void try_vhdl(std::string_view input) {
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
