// Descriptions of components: any Tcl is run or refused, and reaches nothing of the machine.
#include <map>
#include <set>
#include <string>

#include "sim/project/qsys/component.h"
#include "sim/project/settings.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

void try_hw_tcl(std::string_view input) {
    using namespace sim::project::qsys;
    const std::map<std::string, std::string> parameters{{"WIDTH", "8"}, {"mode", "fast"}};
    try {
        const Component component = read_component(path_in_memory(input), parameters, "one");
        std::set<std::string> names;
        for (const Interface& i : component.interfaces) {
            must(names.insert(i.name).second, "an interface has a name of its own");
            for (const Port& port : i.ports)
                must(port.width <= 4096, "a port is not wider than can be simulated");
        }
    } catch (const sim::project::ProjectError& error) {
        must_be_a_line(error.what());
    }
}

}  // namespace fuzz
