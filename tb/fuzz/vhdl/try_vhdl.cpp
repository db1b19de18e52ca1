// What a VHDL file defines: no text is refused, and both views of its entities agree.
#include "sim/project/vhdl_source.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

void try_vhdl(std::string_view input) {
    for (const auto& module : sim::project::scan_vhdl(input).modules) {
        must(!module.name.empty(), "what is defined has a name");
        if (module.is_package) continue;
        const auto head = sim::project::entity_in(input, module.name);
        must(head.has_value(), "an entity has a head");
        for (const auto& port : head->ports) must(!port.name.empty(), "a port has a name");
        for (const auto& generic : head->generics)
            must(!generic.name.empty(), "a generic has a name");
    }
}

}  // namespace fuzz
