#include "sim/verilog/power_up.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "sim/verilog/items.h"

namespace sim::project {

namespace {

bool is_of_simulation(const Token& token) {
    static const std::set<std::string_view> FUNCTIONS{"$signed", "$unsigned", "$clog2", "$bits"};
    return token.text[0] == '$' && !FUNCTIONS.count(token.text);
}

// Finds the resets among the statements of one clocked block, which begins at `at`.
class Resets {
public:
    Resets(const std::vector<Token>& all, std::set<std::string_view> edges,
           std::vector<ResetStatement>& found)
        : all_{all}, edges_{std::move(edges)}, found_{found} {}

    void look(std::size_t at) {
        const std::size_t end = behind_statement(all_, at);
        if (end > all_.size() || end <= at) return;
        if (!is(at, "begin")) return statement(at, end - 1);
        for (at += is(at + 1, ":") ? 3 : 1; at + 1 < end;) {
            const std::size_t next = behind_statement(all_, at);
            if (next <= at) return;
            statement(at, end - 1);
            at = next;
        }
    }

private:
    bool is(std::size_t i, std::string_view text) const {
        return i < all_.size() && all_[i].is(text);
    }

    void statement(std::size_t at, std::size_t after) {
        if (!is(at, "if") || !is(at + 1, "(")) return;
        const std::size_t close = closing(all_, at + 1);
        const auto token = [&](std::size_t i) {
            return all_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (std::none_of(token(at + 2), token(close),
                         [&](const Token& name) { return edges_.count(name.text); }))
            return;
        const std::size_t begin = close + 1, end = behind_statement(all_, begin);
        if (end > all_.size()) return;
        const auto is_odd = [](const Token& one) {  // or in branches of an `ifdef
            return is_of_simulation(one) || one.gap.find('`') != std::string_view::npos;
        };
        if (std::none_of(token(begin), token(end), is_odd)) found_.push_back({after, begin, end});
    }

    const std::vector<Token>& all_;
    const std::set<std::string_view> edges_;
    std::vector<ResetStatement>& found_;
};

}  // namespace

std::vector<ResetStatement> reset_statements(const std::vector<Token>& all) {
    std::vector<ResetStatement> found;
    for (std::size_t i = 0; i + 3 < all.size(); ++i) {
        if (!(all[i].is("always") || all[i].is("always_ff")) || !all[i + 1].is("@") ||
            !all[i + 2].is("("))
            continue;
        const std::size_t close = closing(all, i + 2);
        std::set<std::string_view> edges;
        for (std::size_t at = i + 3; at < close; ++at)
            if (all[at].is("posedge") || all[at].is("negedge")) edges.insert(all[at + 1].text);
        if (edges.size() > 1) Resets{all, edges, found}.look(close + 1);
    }
    return found;
}

}  // namespace sim::project
