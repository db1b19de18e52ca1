#include "sim/vhdl/vhdl_ports.h"

#include <map>

#include "sim/text/lower.h"
#include "sim/verilog/edits.h"
#include "sim/verilog/instances.h"

namespace sim::project {

std::string with_ports_of_entities(const std::string& verilog,
                                   const std::vector<GenericEntity>& entities) {
    if (entities.empty()) return verilog;
    const Tokens tokens = tokens_of(verilog);
    const std::vector<Token>& all = tokens.all;
    std::map<std::string_view, std::map<std::string, std::string>> ports;  // by the lower case
    for (const GenericEntity& entity : entities)
        for (const auto& port : entity.head.ports) ports[entity.name][lower(port.name)] = port.name;
    Edits edits;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const auto of = ports.find(all[i].text);
        if (of == ports.end() || !(all[i + 1].is("#") || all[i + 1].kind == Token::Kind::NAME))
            continue;
        const std::size_t end = find_outside(all, i, {";"});
        for (; i + 2 < end; ++i) {
            if (!all[i].is(".") || !all[i + 2].is("(")) continue;
            const auto port = of->second.find(lower(std::string{all[i + 1].text}));
            if (port == of->second.end() || port->second == all[i + 1].text) continue;
            edits.left_out.insert(i + 1);
            edits.before[i + 1] = port->second;
        }
    }
    return changed_text(tokens, edits);
}

}  // namespace sim::project
