// text_checks.h - what Quartus says of the text of one file, before it is elaborated.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim/verilog/items.h"
#include "sim/verilog/quartus/message.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

struct TextChecks {
    Messages errors;  // 10122, 10170, 10200, 10219, 10239, and those of syntax.h
    // What counts where the module is in the design, and not in a test bench beside it.
    struct OfModule {
        std::string module;
        bool is_error;
        Message message;
    };
    std::vector<OfModule> of_modules;
    Messages warnings;  // 10175, 10222, 10268, 10273, 10281
    // Assignments whose value has 32 bits, since a number in it has no size: the line of
    // the sign, and the variable.
    std::set<std::pair<unsigned, std::string>> of_32_bits;
};

// `name` is the file's in messages.  `system_verilog`: loops need no `generate` in it.
TextChecks check_text(const std::vector<Token>& tokens, const Items& items, const std::string& name,
                      bool system_verilog);

}  // namespace sim::project
