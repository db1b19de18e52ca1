#include "sim/project/reorder.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include <fmt/format.h>

namespace sim::project {

namespace {

bool is_direction(const Token& token) {
    return token.is("input") || token.is("output") || token.is("inout");
}
bool is_net(const Token& token) {
    static constexpr std::string_view WORDS[] = {"wire", "reg", "tri", "logic", "signed"};
    return std::find(std::begin(WORDS), std::end(WORDS), token.text) != std::end(WORDS);
}

// A declaration of nets or ports: "input signed [7:0]" and the names behind it.
struct Declaration {
    std::size_t begin, end;  // its first token, and its semicolon
    std::string type;
    std::vector<std::string> names;
    bool plain = true;  // only names: neither values nor dimensions behind them
};

class Reorderer {
public:
    Reorderer(const std::vector<Token>& tokens, const Items& items, Edits& edits)
        : tokens_{tokens}, items_{items}, edits_{edits} {}

    void run() {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (token.is("endmodule")) end_of_module();
            if (!items_.begins_item(i)) continue;
            if (token.is("defparam")) parameter(i);
            if (is_direction(token)) ports_.push_back(declaration(i));
            if (is_net(token)) nets_.push_back(declaration(i));
        }
    }

private:
    Declaration declaration(std::size_t begin) const {
        Declaration d{begin, begin, {}, {}};
        std::size_t i = begin;
        for (; i < tokens_.size() && (is_direction(tokens_[i]) || is_net(tokens_[i])); ++i)
            d.type += std::string{tokens_[i].text} + " ";
        if (i < tokens_.size() && tokens_[i].is("[")) {
            for (; i < tokens_.size() && !tokens_[i].is("]") && !tokens_[i].is(";"); ++i)
                d.type += std::string{tokens_[i].text} + " ";
            d.type += "] ";
            ++i;
        }
        for (; i < tokens_.size() && !tokens_[i].is(";"); ++i) {
            const Token& token = tokens_[i];
            if (token.kind == Token::Kind::NAME)
                d.names.emplace_back(token.text);
            else if (!token.is(","))
                d.plain = false;
        }
        d.end = i;
        return d;
    }

    void drop(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i <= end && i < tokens_.size(); ++i) edits_.left_out.insert(i);
    }

    // A port's direction goes before the first net declaration that has its name.
    void end_of_module() {
        for (const Declaration& port : ports_) {
            if (!port.plain) continue;
            std::string left;
            bool moved = false;
            for (const std::string& name : port.names) {
                const auto net =
                    std::find_if(nets_.begin(), nets_.end(), [&](const Declaration& d) {
                        return d.begin < port.begin &&
                               std::find(d.names.begin(), d.names.end(), name) != d.names.end();
                    });
                if (net == nets_.end()) {
                    left += (left.empty() ? "" : ", ") + name;
                    continue;
                }
                edits_.before[net->begin] += port.type + name + "; ";
                edits_.told[port.begin] +=
                    fmt::format("{}{}", moved ? ", " : "moved before its net: port ", name);
                moved = true;
            }
            if (!moved) continue;
            drop(port.begin, port.end);
            if (!left.empty()) edits_.before[port.begin] = port.type + left + "; ";
        }
        ports_.clear();
        nets_.clear();
        parameters_.clear();
    }

    void parameter(std::size_t begin) {
        std::string name;
        std::size_t i = begin + 1;
        for (; i < tokens_.size() && !tokens_[i].is("=") && !tokens_[i].is(";"); ++i)
            name += tokens_[i].text;
        while (i < tokens_.size() && !tokens_[i].is(";")) {
            if (tokens_[i].is(",")) return;  // several in one statement
            ++i;
        }
        if (const auto earlier = parameters_.find(name); earlier != parameters_.end()) {
            drop(earlier->second.first, earlier->second.second);
            edits_.told[earlier->second.first] =
                fmt::format("left out defparam {}, which is set again", name);
        }
        parameters_[name] = {begin, i};
    }

    const std::vector<Token>& tokens_;
    const Items& items_;
    Edits& edits_;
    std::vector<Declaration> ports_, nets_;
    std::map<std::string, std::pair<std::size_t, std::size_t>> parameters_;  // begin and semicolon
};

}  // namespace

void reorder(const std::vector<Token>& tokens, const Items& items, Edits& edits) {
    Reorderer{tokens, items, edits}.run();
}

}  // namespace sim::project
