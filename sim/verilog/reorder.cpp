#include "sim/verilog/reorder.h"

#include <algorithm>
#include <iterator>
#include <set>
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

// A declaration of nets or ports: "input signed [7:0]" and the names after it.
struct Declaration {
    std::size_t begin, end;  // its first token, and its semicolon
    std::string type;
    std::vector<std::string> names;
    bool plain = true;  // only names: neither values nor dimensions after them
};

class Reorderer {
public:
    Reorderer(const std::vector<Token>& tokens, const Items& items, Edits& edits)
        : tokens_{tokens}, items_{items}, edits_{edits} {}

    void run() {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (token.is("endmodule")) end_of_module();
            if (token.is("begin")) scopes_.push_back(++scope_);
            if (token.is("end") && scopes_.size() > 1) scopes_.pop_back();
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
                edits_.notes[port.begin] +=
                    fmt::format("{}{}", moved ? ", " : "moved before its net: port ", name);
                moved = true;
            }
            if (!moved) continue;
            drop(port.begin, port.end);
            if (!left.empty()) edits_.before[port.begin] = port.type + left + "; ";
        }
        ports_.clear();
        nets_.clear();
        drop_earlier_parameters();
    }

    // "u.W = 4", of one statement "defparam u.W = 4, v.W = 8;"
    struct Parameter {
        std::string name;
        std::size_t begin, end;  // its tokens
    };
    struct Defparam {
        std::size_t begin, end;  // the word, and its semicolon
        std::vector<Parameter> parameters;
    };

    void parameter(std::size_t begin) {
        Defparam all{begin, begin, {}};
        std::size_t i = begin + 1;
        while (i < tokens_.size() && !tokens_[i].is(";")) {
            Parameter p{std::to_string(scopes_.back()) + " ", i, i};
            bool in_name = true;
            for (int depth = 0; i < tokens_.size() && !tokens_[i].is(";"); ++i) {
                if (depth == 0 && tokens_[i].is(",")) break;
                depth += tokens_[i].is("(") + tokens_[i].is("[") + tokens_[i].is("{");
                depth -= tokens_[i].is(")") + tokens_[i].is("]") + tokens_[i].is("}");
                in_name = in_name && !tokens_[i].is("=");
                if (in_name) p.name += tokens_[i].text;
            }
            p.end = i;
            all.parameters.push_back(p);
            if (i < tokens_.size() && tokens_[i].is(",")) ++i;
        }
        all.end = i;
        defparams_.push_back(std::move(all));
    }

    // Of those of one parameter of one instance the last one counts.
    void drop_earlier_parameters() {
        std::set<std::string> later;
        for (auto statement = defparams_.rbegin(); statement != defparams_.rend(); ++statement) {
            std::string kept;
            bool drops = false;
            auto& all = statement->parameters;
            for (auto p = all.rbegin(); p != all.rend(); ++p) {
                if (!later.insert(p->name).second) {
                    drops = true;
                    edits_.notes[statement->begin] =
                        fmt::format("left out defparam {}, which is set again",
                                    p->name.substr(p->name.find(' ') + 1));
                    continue;
                }
                std::string text;
                for (std::size_t i = p->begin; i < p->end; ++i)
                    text += std::string{tokens_[i].text} + " ";
                kept = text + (kept.empty() ? "" : ", ") + kept;
            }
            if (!drops) continue;
            drop(statement->begin, statement->end);
            if (!kept.empty()) edits_.before[statement->begin] += "defparam " + kept + "; ";
        }
        defparams_.clear();
    }

    const std::vector<Token>& tokens_;
    const Items& items_;
    Edits& edits_;
    std::vector<Declaration> ports_, nets_;
    std::vector<Defparam> defparams_;
    std::vector<unsigned> scopes_{0};  // numbers of the blocks that are open
    unsigned scope_ = 0;
};

}  // namespace

void reorder(const std::vector<Token>& tokens, const Items& items, Edits& edits) {
    Reorderer{tokens, items, edits}.run();
}

}  // namespace sim::project
