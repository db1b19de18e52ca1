#include "sim/verilog/init_text.h"

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;

constexpr const char *SYSTEM_VERILOG = "`begin_keywords \"1800-2017\" ", *BACK = " `end_keywords ";

class InitText {
public:
    InitText(const std::vector<Token>& tokens, Edits& edits) : tokens_{tokens}, edits_{edits} {}

    std::vector<InitName> run() {
        for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (token.is("module")) module_ = tokens_[i + 1].text;
            if ((token.is("$readmemh") || token.is("$readmemb")) && tokens_[i + 1].is("("))
                readmem(i + 2);
            else if (token.is("ram_init_file") && tokens_[i + 1].is("="))
                attribute(i + 2);
            else if (token.is(";"))
                comment(i);
        }
        return std::move(names_);
    }

private:
    void note(const Token& token, std::string_view literal, std::string_view reader) {
        if (literal.size() > 2 && literal.front() == '"')
            names_.push_back({std::string{literal.substr(1, literal.size() - 2)}, token.line,
                              module_, std::string{reader}});
    }

    void readmem(std::size_t begin) {
        std::size_t end = begin;
        for (int depth = 0; end < tokens_.size(); ++end) {
            if (depth == 0 && tokens_[end].is(",")) break;
            depth += tokens_[end].is("(") || tokens_[end].is("{");
            depth -= tokens_[end].is(")") || tokens_[end].is("}");
            if (depth < 0) return;
        }
        if (end == tokens_.size()) return;
        if (end == begin + 1) note(tokens_[begin], tokens_[begin].text, tokens_[begin - 2].text);
        edits_.before[begin] +=
            fmt::format("{}de1sim_init::de1sim_init_path({}", SYSTEM_VERILOG, BACK);
        edits_.before[end] += ")";
    }

    // The declaration after the attributes among which the file's name is at `value`.
    void attribute(std::size_t value) {
        std::size_t i = value;
        while (i < tokens_.size() && !tokens_[i].is("*)")) ++i;
        while (i < tokens_.size() && !tokens_[i].is(";")) ++i;
        if (i < tokens_.size()) initialise(i, tokens_[value].text);
    }

    // A comment before the semicolon at `end`.
    void comment(std::size_t end) {
        const std::string_view gap = tokens_[end].gap;
        const std::size_t word = gap.find("ram_init_file");
        if (word == std::string_view::npos || gap.find("synthesis") > word) return;
        const std::size_t open = gap.find('"', word);
        if (open == std::string_view::npos) return;
        const std::size_t close = gap.find('"', open + 1);
        if (close == std::string_view::npos) return;
        initialise(end, gap.substr(open, close + 1 - open));
    }

    // The memory whose declaration ends with the semicolon at `end`: reg [7:0] NAME [0:255] ;
    void initialise(std::size_t end, std::string_view file) {
        std::size_t i = end;
        while (i > 0 && tokens_[i - 1].is("]")) {
            while (i > 0 && !tokens_[i - 1].is("[")) --i;
            if (i == 0) return;  // a broken text
            --i;
        }
        if (i == 0 || i == end || tokens_[i - 1].kind != Kind::NAME) return;
        note(tokens_[i - 1], file, "ram_init_file");
        const std::string memory{tokens_[i - 1].text};
        const std::string width = fmt::format("$bits({0}[$low({0})])", memory);
        edits_.after[end] += fmt::format(
            " {0}initial begin : de1sim_init_{1} int at, part; bit [{2}+31:0] word; "
            "if (de1sim_init::de1sim_init_file({3}, $sformatf(\"%m\"), {2}, $size({4})) != 0) "
            "for (at = 0; at < $size({4}); ++at) begin "
            "for (part = 0; 32 * part < {2}; ++part) "
            "word[32 * part +: 32] = de1sim_init::de1sim_init_part(at, part); "
            "{4}[$low({4}) + at] = word[{2}-1:0]; end end{5}",
            SYSTEM_VERILOG, ++number_, width, file, memory, BACK);
    }

    const std::vector<Token>& tokens_;
    Edits& edits_;
    std::string module_;
    std::vector<InitName> names_;
    unsigned number_ = 0;
};

}  // namespace

std::vector<InitName> read_at_run_time(const Tokens& tokens, Edits& edits) {
    return InitText{tokens.all, edits}.run();
}

}  // namespace sim::project
