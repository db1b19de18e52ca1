#include "sim/verilog/inout_fits.h"

#include <fmt/format.h>

#include "sim/verilog/items.h"

namespace sim::project {

void fit_inouts(const std::vector<Token>& all, const std::vector<InoutFit>& fits, Edits& edits) {
    unsigned number = 0;
    for (const InoutFit& fit : fits)
        for (std::size_t i = 0; i + 3 < all.size(); ++i) {
            if (!all[i].is(".") || !all[i + 1].is(fit.port) || !all[i + 2].is("(")) continue;
            const std::size_t end = closing(all, i + 2);
            if (fit.line < all[i].line || fit.line > all[end].line || end == i + 3) continue;
            if (fit.connected > fit.bits) {
                edits.after[end - 1] += fmt::format("[{}:0]", fit.bits - 1);
                continue;
            }
            std::size_t begin = i;  // of the instance
            while (begin > 0 && !all[begin - 1].is(";") && !all[begin - 1].is("begin") &&
                   !all[begin - 1].is("end") && !all[begin - 1].is("generate"))
                --begin;
            const std::string open = fmt::format("de1sim_open_{}", ++number);
            edits.before[begin] +=
                fmt::format("wire [{}:0] {}; ", fit.bits - fit.connected - 1, open);
            edits.before[i + 3].insert(0, fmt::format("{{{}, ", open));
            edits.after[end - 1] += "}";
        }
}

}  // namespace sim::project
