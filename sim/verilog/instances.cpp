#include "sim/verilog/instances.h"

#include <algorithm>

namespace sim::project {

namespace {

void add_connections(const std::vector<Token>& tokens, std::size_t open, std::size_t close,
                     const ModuleText& module, std::vector<ConnectionText>& all) {
    std::size_t position = 0;
    for (std::size_t i = open + 1; i < close; ++position) {
        const std::size_t end = find_outside(tokens, i, {",", ")"});
        ConnectionText here{{}, i, end};
        if (tokens[i].is(".") && i + 3 < end && tokens[i + 2].is("(")) {
            here = {std::string{tokens[i + 1].text}, i + 3, end - 1};
        } else if (position < module.header.size()) {
            here.port = module.header[position];
        }
        if (here.first < here.last) all.push_back(std::move(here));
        i = end + 1;
    }
}

}  // namespace

std::size_t find_outside(const std::vector<Token>& tokens, std::size_t i,
                         std::initializer_list<std::string_view> ends) {
    for (int depth = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (depth == 0 && std::find(ends.begin(), ends.end(), token.text) != ends.end()) break;
        depth += token.is("(") || token.is("[") || token.is("{");
        depth -= token.is(")") || token.is("]") || token.is("}");
    }
    return i;
}

bool is_instance_name(const std::vector<Token>& tokens, std::size_t i) {
    if (i == 0) return false;
    const Token& before = tokens[i - 1];
    if (before.kind == Token::Kind::NAME) return !is_keyword(before.text);
    int depth = 0;
    for (std::size_t at = i; before.is(")") && at-- > 1;) {
        depth += tokens[at].is(")") - tokens[at].is("(");
        if (depth == 0) return tokens[at - 1].is("#");
    }
    return false;
}

// [#(...)] NAME [range] ( connections ), ... ;
std::vector<ConnectionText> connections_of(const std::vector<Token>& tokens, std::size_t at,
                                           const ModuleText& module) {
    std::vector<ConnectionText> all;
    if (is_instance_name(tokens, at)) return all;
    const std::size_t end = find_outside(tokens, at, {";"});
    if (end >= tokens.size()) return all;
    for (std::size_t open = find_outside(tokens, at + 1, {"(", ";"}); open < end;
         open = find_outside(tokens, open + 1, {"(", ";"})) {
        const std::size_t close = find_outside(tokens, open + 1, {")"});
        if (!tokens[open - 1].is("#")) add_connections(tokens, open, close, module, all);
        open = close;
    }
    return all;
}

}  // namespace sim::project
