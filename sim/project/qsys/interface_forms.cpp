#include "sim/project/qsys/interface_forms.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace sim::project::qsys {

void make_apb_avalon(std::vector<Interface>& interfaces) {
    static const std::map<std::string, const char*> ROLES{{"paddr", "address"},
                                                          {"psel", "chipselect"},
                                                          {"pwdata", "writedata"},
                                                          {"prdata", "readdata"},
                                                          {"pready", "waitrequest_n"}};
    for (Interface& apb : interfaces) {
        if (apb.type != "apb" || apb.is_start) continue;
        apb.type = "avalon";
        for (Port& port : apb.ports)
            if (const auto role = ROLES.find(port.role); role != ROLES.end())
                port.role = role->second;
        for (const auto& [name, value] : {std::pair{"addressUnits", "SYMBOLS"},
                                          {"setupTime", "1"},
                                          {"readWaitTime", "0"},
                                          {"writeWaitTime", "0"}})
            apb.properties[name] = value;
    }
}

void part_resets(std::vector<Interface>& interfaces) {
    std::vector<Interface> resets;
    for (Interface& clock : interfaces) {
        if (clock.type != "clock") continue;
        const auto reset = std::stable_partition(
            clock.ports.begin(), clock.ports.end(),
            [](const Port& port) { return port.role != "reset" && port.role != "reset_n"; });
        if (reset == clock.ports.end()) continue;
        resets.push_back({clock.name + "_reset",
                          "reset",
                          clock.is_start,
                          {{"associatedClock", clock.name}},
                          {reset, clock.ports.end()}});
        clock.ports.erase(reset, clock.ports.end());
        for (Interface& other : interfaces)
            if (other.property("associatedClock") == clock.name)
                other.properties.emplace("associatedReset", resets.back().name);
    }
    interfaces.insert(interfaces.end(), resets.begin(), resets.end());
}

}  // namespace sim::project::qsys
