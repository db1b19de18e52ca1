// items.h - the items of a module, told apart from the statements of its processes.
//
// `counter (clk, q);` is an instance without a name among the items, and calls a task among the
// statements of an always block.
#pragma once

#include <vector>

#include "sim/verilog/tokens.h"

namespace sim::project {

class Items {
public:
    // Of all tokens of a file, which must outlive this.
    explicit Items(const std::vector<Token>& tokens);

    // MODULE ( or MODULE #(...) ( begins at token `i`: an instance that has no name, which the
    // standard wants and Quartus does not.
    bool unnamed_instance(std::size_t i) const;

    // An item, and not a statement, begins at token `i`.
    bool begins_item(std::size_t i) const;

    // Token `i` is in an always, initial or final block, a function or a task.
    bool is_statement(std::size_t i) const { return statements_[i]; }

private:
    const std::vector<Token>& tokens_;
    std::vector<bool> statements_;
};

// The token after the statement that begins at `i`.
std::size_t behind_statement(const std::vector<Token>& tokens, std::size_t i);

// The parenthesis that closes the one at `open`; where there is none, the last token.
std::size_t closing(const std::vector<Token>& tokens, std::size_t open);

}  // namespace sim::project
