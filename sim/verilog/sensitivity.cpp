#include "sim/verilog/sensitivity.h"

#include <algorithm>

#include "sim/verilog/items.h"

namespace sim::project {

namespace {

constexpr char LIST_OPEN[] = "`ifdef DE1SIM_LISTS ", LIST_CLOSE[] = " `else * `endif ";

}  // namespace

void complete_lists(const Tokens& tokens, Edits& edits) {
    const std::vector<Token>& all = tokens.all;
    for (std::size_t i = 0; i + 3 < all.size(); ++i) {
        if (!all[i].is("always") || !all[i + 1].is("@")) continue;
        const std::size_t first = i + 2;
        if (all[first].kind == Token::Kind::NAME) {  // @a
            edits.before[first] += std::string{"("} + LIST_OPEN;
            edits.after[first] += std::string{LIST_CLOSE} + ")";
            continue;
        }
        if (!all[first].is("(")) continue;
        const std::size_t end = closing(all, first);
        const auto is_other = [](const Token& t) {
            return t.is("posedge") || t.is("negedge") || t.is("edge") || t.is("*") || t.is("*)");
        };
        if (end == first + 1 || all[end].line != all[first].line ||
            std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first),
                        all.begin() + static_cast<std::ptrdiff_t>(end) + 1, is_other))
            continue;
        edits.after[first] += LIST_OPEN;
        edits.before[end] += LIST_CLOSE;
    }
}

}  // namespace sim::project
