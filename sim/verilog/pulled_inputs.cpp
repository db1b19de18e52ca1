#include "sim/verilog/pulled_inputs.h"

#include <algorithm>
#include <set>

#include "sim/verilog/instances.h"

namespace sim::project {

namespace {

struct Pull {
    std::size_t at;  // the token tri0 or tri1
    std::string module;
    std::vector<std::string> inputs;
};

// The names from token `i` on, which are separated by commas, after a range; `end`: what follows.
std::vector<std::string> names_from(const std::vector<Token>& tokens, std::size_t i,
                                    std::size_t& end) {
    std::vector<std::string> names;
    while (i < tokens.size() && tokens[i].is("[")) i = find_outside(tokens, i + 1, {"]"}) + 1;
    for (; i < tokens.size() && tokens[i].kind == Token::Kind::NAME; i += 2) {
        names.emplace_back(tokens[i].text);
        if (i + 1 >= tokens.size() || !tokens[i + 1].is(",")) {
            ++i;
            break;
        }
    }
    end = i;
    return names;
}

std::vector<Pull> pulls_of(const std::vector<Token>& tokens) {
    std::vector<Pull> all;
    std::string module;
    std::set<std::string> inputs;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        std::size_t end = 0;
        if (tokens[i].is("module")) {
            module = tokens[i + 1].text;
            inputs.clear();
        } else if (tokens[i].is("input")) {
            std::size_t first = i + 1;
            for (const char* type : {"wire", "tri0", "tri1", "signed"})
                first += first < tokens.size() && tokens[first].is(type);
            const std::vector<std::string> names = names_from(tokens, first, end);
            inputs.insert(names.begin(), names.end());
        } else if (tokens[i].is("tri0") || tokens[i].is("tri1")) {
            std::vector<std::string> names = names_from(tokens, i + 1, end);
            if (!names.empty() && std::all_of(names.begin(), names.end(),
                                              [&](const auto& n) { return inputs.count(n) > 0; }))
                all.push_back({i, module, std::move(names)});
        }
    }
    return all;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> pulled_up_inputs(
    const std::vector<Token>& tokens) {
    std::vector<std::pair<std::string, std::string>> all;
    for (const Pull& pull : pulls_of(tokens))
        if (tokens[pull.at].is("tri1"))
            for (const std::string& input : pull.inputs) all.emplace_back(pull.module, input);
    return all;
}

void make_pulled_inputs_wires(const std::vector<Token>& tokens, Edits& edits) {
    for (const Pull& pull : pulls_of(tokens)) {
        edits.left_out.insert(pull.at);
        edits.before[pull.at] += "wire";
    }
}

}  // namespace sim::project
