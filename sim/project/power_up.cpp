#include "sim/project/power_up.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "sim/project/items.h"
#include "sim/project/settings.h"
#include "sim/report/whole_file.h"

namespace sim::project {

namespace {

namespace fs = std::filesystem;

// Where the body of this function begins and ends, in its definition; npos: it is not here.
struct Body {
    std::size_t begin = std::string::npos, end = 0;
};
Body body_of(const std::string& text, const std::string& function) {
    const std::size_t name =
        text.find("\nVL_ATTR_COLD void Vde1sim_chip___024root___" + function + "(");
    if (name == std::string::npos) return {};
    const std::size_t begin = text.find('{', name);
    if (begin > text.find(';', name)) return {};  // a declaration
    return {begin, text.find("\n}", begin)};
}

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

    void statement(std::size_t at, std::size_t behind) {
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
        if (std::none_of(token(begin), token(end), is_odd)) found_.push_back({behind, begin, end});
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

void forget_edges_of_power_up(const fs::path& objects) {
    std::string remember;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{objects})
        if (entry.path().extension() == ".cpp") files.push_back(entry.path());
    for (const fs::path& file : files) {
        const std::string text = text_of(file);
        const Body initial = body_of(text, "eval_initial");
        if (initial.begin == std::string::npos) continue;
        for (std::size_t at = initial.begin;
             (at = text.find("vlSelf->__Vtrigrprev__", at)) < initial.end;) {
            const std::size_t end = text.find(';', at) + 1;
            remember += "    " + text.substr(at, end - at) + "\n";
            at = end;
        }
    }
    for (const fs::path& file : files) {
        std::string text = text_of(file);
        const Body settle = body_of(text, "eval_settle");
        if (settle.begin == std::string::npos) continue;
        write_whole_file(file, text.insert(settle.end + 1, remember));
    }
}

}  // namespace sim::project
