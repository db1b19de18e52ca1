#include "sim/verilog/inout_fits.h"

#include <fmt/format.h>

#include "sim/verilog/items.h"

namespace sim::project {

namespace {

bool is_at(const ConnectionText& connection, const std::vector<Token>& all, const InoutFit& fit) {
    if (connection.port != fit.port) return false;
    const std::size_t first = connection.first;
    const bool has_name = first >= 3 && all[first - 1].is("(") && all[first - 3].is(".");
    return fit.line >= all[has_name ? first - 3 : first].line &&
           fit.line <= all[connection.last].line;
}

void fit_inout(const ConnectionText& connection, const InoutFit& fit, std::size_t instance,
               const std::vector<Token>& all, unsigned number, Edits& edits) {
    if (fit.connected > fit.bits) {
        edits.after[connection.last - 1] += fmt::format("[{}:0]", fit.bits - 1);
        return;
    }
    std::size_t begin = instance;  // of its statement
    while (begin > 0 && !all[begin - 1].is(";") && !all[begin - 1].is("begin") &&
           !all[begin - 1].is("end") && !all[begin - 1].is("generate"))
        --begin;
    const std::string open = fmt::format("de1sim_open_{}", number);
    edits.before[begin] += fmt::format("wire [{}:0] {}; ", fit.bits - fit.connected - 1, open);
    edits.before[connection.first].insert(0, fmt::format("{{{}, ", open));
    edits.after[connection.last - 1] += "}";
}

}  // namespace

void fit_inouts(const std::vector<Token>& all, const Modules& modules,
                const std::vector<InoutFit>& fits, Edits& edits) {
    if (fits.empty()) return;
    unsigned number = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto module = modules.find(all[i].text);
        if (module == modules.end() || (i > 0 && all[i - 1].is("module"))) continue;
        for (const ConnectionText& connection : connections_of(all, i, module->second))
            for (const InoutFit& fit : fits)
                if (is_at(connection, all, fit))
                    fit_inout(connection, fit, i, all, ++number, edits);
    }
}

}  // namespace sim::project
