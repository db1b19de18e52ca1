// console_text.h - what a program prints, read by waiting for one text after another
//
// The text that was found counts as read, together with everything before it; the next wait begins
// after it.  Of the unread text at least the last LIMIT characters are kept (more if the text that
// is waited for is longer), and at most twice as many.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sim {

class ConsoleText {
public:
    static constexpr std::size_t LIMIT = 1 << 18;

    void print(char character);

    // Reads up to the end of the first `text` that is not read yet; false: nowhere, nothing read.
    bool consume(std::string_view text);

    std::uint64_t unread() const { return forgotten_ + unread_.size(); }
    // The last of the unread text, `most` characters of it.
    std::string_view end(std::size_t most) const {
        const std::string_view all = unread_;
        return all.substr(all.size() - std::min(all.size(), most));
    }
    std::uint64_t forgotten() const { return forgotten_; }  // unread characters that were dropped

private:
    std::string unread_;
    std::uint64_t forgotten_ = 0;
    std::string wanted_;        // by the last consume()
    std::size_t searched_ = 0;  // no wanted_ begins before this
};

}  // namespace sim
