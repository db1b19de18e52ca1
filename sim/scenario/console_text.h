// console_text.h - what a program prints, as somebody reads it who waits for one text after another
//
// What has been waited for is read, and so is all before it: the next wait begins behind it.  Of
// what is not read yet at least the last LIMIT characters are kept, or as many as the text waited
// for has, and twice as many at most.
#pragma once

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
    bool take(std::string_view text);

    std::uint64_t unread() const { return forgotten_ + unread_.size(); }
    std::uint64_t forgotten() const { return forgotten_; }  // of those, too old to be looked at

private:
    std::string unread_;
    std::uint64_t forgotten_ = 0;
    std::string wanted_;        // by the last take()
    std::size_t searched_ = 0;  // no wanted_ begins before this
};

}  // namespace sim
