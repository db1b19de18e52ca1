#include "sim/verilog/edits.h"

#include <algorithm>

namespace sim::project {

std::string changed_text(const Tokens& tokens, const Edits& edits) {
    std::string text;
    for (std::size_t i = 0; i < tokens.all.size(); ++i) {
        text += tokens.all[i].gap;
        if (const auto here = edits.before.find(i); here != edits.before.end())
            text += here->second;
        const std::string_view token = tokens.all[i].text;
        if (edits.left_out.count(i))
            text.append(static_cast<std::size_t>(std::count(token.begin(), token.end(), '\n')),
                        '\n');
        else
            text += token;
        if (const auto here = edits.after.find(i); here != edits.after.end()) text += here->second;
    }
    return text += tokens.tail;
}

}  // namespace sim::project
