// clocked_block.h - the statements of an always block with an edge, and what they assign and read.
#pragma once

#include <initializer_list>
#include <set>
#include <string_view>
#include <vector>

#include "sim/verilog/tokens.h"

namespace sim::project {

struct NotUnderstood {};  // thrown: the block has a statement that is not known here

class ClockedBlock {
public:
    struct Target {
        std::string_view name;
        std::size_t begin, end;  // the tokens "n[3:0]"
    };
    struct Assignment {
        std::vector<Target> targets;   // of {a, b} several
        std::size_t begin, sign, end;  // its first token, its sign, its semicolon
        bool is_blocking;
        bool is_plain;  // "=", and not "+=" or "++"
    };
    using Names = std::set<std::string_view>;

    // From the statement's first token on.
    ClockedBlock(const std::vector<Token>& all, std::size_t begin);

    std::size_t begin() const { return begin_; }
    std::size_t end() const { return at_; }  // after the statement
    const std::vector<Assignment>& assignments() const { return assignments_; }
    // What may have been assigned before it is read, or where that is not known.
    const Names& read_behind() const { return read_; }
    const Names& loop_variables() const { return loops_; }
    const Names& locals() const { return locals_; }
    // Whether it calls a task; what that reads and assigns is not among the above.
    bool calls() const { return calls_; }

private:
    const Token& here() const;
    bool accept(std::string_view text);
    void expect(std::string_view text);
    bool is_one_of(std::initializer_list<std::string_view> words) const;
    void read_to(std::string_view end);
    void condition();
    void statement();
    void sequence();
    void local();
    void branches();
    void choices();
    void loop();
    void assignment();
    Target target();

    const std::vector<Token>& all_;
    const std::size_t begin_;
    std::size_t at_;
    unsigned nested_ = 0;
    bool calls_ = false;
    Names assigned_, read_, loops_, locals_;  // assigned_: up to here
    std::vector<Assignment> assignments_;
};

}  // namespace sim::project
