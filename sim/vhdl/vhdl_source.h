// vhdl_source.h - what a VHDL file defines and what it wants, found without analysing it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/verilog/source.h"

namespace sim::project {

// Entities, what they want (components, entities), and their ports.
SourceText scan_vhdl(std::string_view text);

struct EntityHead {
    struct Member {
        std::string name;
        std::vector<std::string> type;  // words in lower case: out std_logic_vector ( 3 downto 0 )
    };
    std::string name;
    std::vector<Member> generics, ports;
};
// All entities, in the order of the text.
std::vector<EntityHead> entities_in(std::string_view text);
// The entity of that name, in any case.
std::optional<EntityHead> entity_in(std::string_view text, const std::string& name);

}  // namespace sim::project
