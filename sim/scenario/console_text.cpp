#include "sim/scenario/console_text.h"

#include <algorithm>

namespace sim {

void ConsoleText::print(char character) {
    unread_ += character;
    const std::size_t limit = std::max(LIMIT, wanted_.size());
    if (unread_.size() < 2 * limit) return;
    unread_.erase(0, limit);
    forgotten_ += limit;
    searched_ -= std::min(searched_, limit);
}

bool ConsoleText::consume(std::string_view text) {
    if (text != wanted_) {
        wanted_ = text;
        searched_ = 0;
    }
    const std::size_t at = unread_.find(text, searched_);
    if (at == std::string::npos) {
        const std::size_t open = text.empty() ? 0 : text.size() - 1;  // may be the text's beginning
        searched_ = unread_.size() - std::min(open, unread_.size());
        return false;
    }
    unread_.erase(0, at + text.size());
    forgotten_ = 0;
    searched_ = 0;
    return true;
}

}  // namespace sim
