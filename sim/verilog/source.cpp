#include "sim/verilog/source.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "sim/verilog/items.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

namespace {

using Kind = Token::Kind;

bool is_name(const Token& token) { return token.kind == Kind::NAME && !is_keyword(token.text); }

class Reader {
public:
    explicit Reader(std::string_view text) : tokens_{tokens_of(text).all} {}

    SourceText run() {
        for (at_ = 0; at_ < tokens_.size(); ++at_) {
            const Token& token = tokens_[at_];
            if (token.is("module") || token.is("macromodule") || token.is("package") ||
                token.is("interface"))
                begin(token);
            else if (token.is("endmodule") || token.is("endpackage") || token.is("endinterface"))
                module_ = nullptr;
            else if (token.is("::") && at_ > 0)
                source_.packages.emplace(tokens_[at_ - 1].text);
            else if (module_)
                in_module(token);
        }
        return std::move(source_);
    }

private:
    const Token* peek(std::size_t ahead = 1) const {
        return at_ + ahead < tokens_.size() ? &tokens_[at_ + ahead] : nullptr;
    }

    void begin(const Token& token) {
        const Token* name = peek();
        if (name && (name->is("automatic") || name->is("static"))) name = peek(2);
        if (!name || name->kind != Kind::NAME) return;
        source_.modules.push_back(
            {std::string{name->text}, name->line, {}, {}, token.is("package")});
        module_ = &source_.modules.back();
        at_ = static_cast<std::size_t>(name - tokens_.data());
        header();
    }

    // The names in the parentheses after the module's name and its parameters.
    void header() {
        std::size_t i = at_ + 1;
        while (i < tokens_.size() && !tokens_[i].is("(") && !tokens_[i].is(";")) ++i;
        int depth = 0;
        bool parameters = i > 0 && i < tokens_.size() && tokens_[i - 1].is("#");
        for (; i + 1 < tokens_.size() && !tokens_[i].is(";"); ++i) {
            depth += tokens_[i].is("(") - tokens_[i].is(")");
            if (depth == 0 && !std::exchange(parameters, false)) return;
            const Token& next = tokens_[i + 1];
            if (depth == 1 && !parameters && is_name(tokens_[i]) &&
                (next.is(",") || next.is(")") || next.is("=")))
                module_->header.emplace_back(tokens_[i].text);
        }
    }

    void in_module(const Token& token) {
        if (token.is("input") || token.is("output") || token.is("inout")) {
            ports();
        } else if (token.is("parameter")) {
            parameters();
        } else if (is_name(token)) {
            const Token* next = peek();
            if (!next) return;
            if (items_.unnamed_instance(at_)) {
                module_->wants.emplace(token.text);
            } else if (next->is("#")) {
                module_->wants.emplace(token.text);
                skip_parameters();
            } else if (is_name(*next) && peek(2) && (peek(2)->is("(") || peek(2)->is("["))) {
                module_->wants.emplace(token.text);
                ++at_;
            }
        }
    }

    // To the name of an instance after #( ... ), or to what there is else.
    void skip_parameters() {
        const std::size_t i = closing(tokens_, at_ + 2);
        at_ = i + 1 < tokens_.size() && is_name(tokens_[i + 1]) ? i + 1 : i;
    }

    void parameters() {
        int depth = 0;
        for (std::size_t i = at_ + 1; i + 1 < tokens_.size() && !tokens_[i].is(";"); ++i) {
            const Token& token = tokens_[i];
            depth += token.is("[") + token.is("(") + token.is("{");
            depth -= token.is("]") + token.is(")") + token.is("}");
            if (depth < 0 || token.is("parameter") || token.is("localparam")) return;
            if (depth != 0 || !is_name(token) || !tokens_[i + 1].is("=")) continue;
            module_->parameters.emplace_back(token.text);
            module_->defaults.emplace(token.text, text_up_to(i + 2, {",", ")", ";"}));
        }
    }

    // From token `i` to one of `ends` outside of brackets, with blanks between.
    std::string text_up_to(std::size_t i, std::initializer_list<const char*> ends) const {
        std::string text;
        for (int depth = 0; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (depth == 0 && std::any_of(ends.begin(), ends.end(),
                                          [&](const char* end) { return token.is(end); }))
                break;
            depth += token.is("[") + token.is("(") + token.is("{");
            depth -= token.is("]") + token.is(")") + token.is("}");
            (text += text.empty() ? "" : " ") += token.text;
        }
        return text;
    }

    // The names of one declaration, up to what ends it.
    void ports() {
        const Token& direction = tokens_[at_];
        std::string range;
        int depth = 0;
        for (std::size_t i = at_ + 1; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (depth == 0 && token.is("[") && range.empty()) range = text_up_to(i + 1, {"]"});
            if (token.is("[") || token.is("(") || token.is("{")) ++depth;
            if (token.is("]") || token.is("}")) --depth;
            if (token.is(")") && --depth < 0) break;
            if (token.is(";") || token.is("input") || token.is("output") || token.is("inout"))
                break;
            if (depth == 0 && is_name(token) && !token.is("logic") && i + 1 < tokens_.size() &&
                !is_name(tokens_[i + 1]))
                declare(token, direction, range);
        }
    }

    void declare(const Token& name, const Token& direction, const std::string& range) {
        module_->ports.emplace_back(name.text);
        if (!range.empty()) module_->ranges.emplace(name.text, range);
        if (direction.is("output")) module_->outputs.emplace(name.text);
        if (direction.is("inout")) module_->inouts.emplace(name.text);
    }

    const std::vector<Token> tokens_;
    const Items items_{tokens_};
    std::size_t at_ = 0;
    SourceText source_;
    ModuleText* module_ = nullptr;
};

}  // namespace

SourceText scan(std::string_view text) { return Reader{text}.run(); }

}  // namespace sim::project
