#include "sim/verilog/parameter_types.h"

#include <string>

#include <fmt/format.h>

namespace sim::project {

namespace {

class HeaderReader {
public:
    HeaderReader(const std::vector<Token>& tokens, Edits& edits) : tokens_{tokens}, edits_{edits} {}

    void run() {
        for (std::size_t i = 0; i < tokens_.size(); ++i)
            if (tokens_[i].is("module") || tokens_[i].is("macromodule")) header(i + 1);
    }

private:
    bool is(std::size_t i, std::string_view text) const {
        return i < tokens_.size() && tokens_[i].is(text);
    }

    // From the module's name on; packages may be imported before #(.
    void header(std::size_t i) {
        while (i < tokens_.size() && !is(i, "#") && !is(i, "(") && !is(i, ";")) {
            const bool import = is(i, "import");
            while (import && i < tokens_.size() && !is(i, ";")) ++i;
            ++i;
        }
        if (!is(i, "#") || !is(i + 1, "(")) return;
        type_.clear();
        for (i += 2; i < tokens_.size() && !is(i, ")"); i = after(i)) parameter(i);
    }

    // Of the parameter that begins at `begin`: what comes after its comma, or its end.
    std::size_t after(std::size_t begin) const {
        int depth = 0;
        for (std::size_t i = begin; i < tokens_.size(); ++i) {
            if (depth == 0 && is(i, ",")) return i + 1;
            if (depth == 0 && is(i, ")")) return i;
            depth += is(i, "(") + is(i, "[") + is(i, "{") - is(i, ")") - is(i, "]") - is(i, "}");
        }
        return tokens_.size();
    }

    void parameter(std::size_t begin) {
        std::size_t name = begin;
        int depth = 0;
        for (std::size_t i = begin; i < tokens_.size() && !is(i, "="); ++i) {
            if (depth == 0 && (is(i, ",") || is(i, ")"))) break;
            depth += is(i, "(") + is(i, "[") - is(i, ")") - is(i, "]");
            if (depth == 0 && tokens_[i].kind == Token::Kind::NAME) name = i;
        }
        const bool has_word = is(begin, "parameter") || is(begin, "localparam");
        if (has_word) word_ = tokens_[begin].text;
        if (name > begin) {
            type_.clear();
            for (std::size_t i = begin + has_word; i < name; ++i) {
                const bool apart = is(i, "[") || tokens_[i - 1].kind == Token::Kind::NAME;
                if (!type_.empty() && apart && !is(i, "::")) type_ += " ";
                type_ += tokens_[i].text;
            }
        } else if (!type_.empty()) {
            edits_.before[name] += fmt::format("{} {} ", word_, type_);
            edits_.notes[name] =
                fmt::format("repeated the type of parameter {}: {}", tokens_[name].text, type_);
        }
    }

    const std::vector<Token>& tokens_;
    Edits& edits_;
    std::string_view word_ = "parameter";
    std::string type_;
};

}  // namespace

void repeat_parameter_types(const std::vector<Token>& tokens, Edits& edits) {
    HeaderReader{tokens, edits}.run();
}

}  // namespace sim::project
