#include "sim/live/text_stream.h"

#include <utility>

namespace sim::live {

namespace {

// Bytes of the character that this one begins; 1 also where it begins none.
std::size_t length_of(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
}

}  // namespace

std::string TextStream::remove() {
    std::size_t end = text_.size();
    for (std::size_t back = 1; back <= 3 && back <= text_.size(); ++back)
        if (length_of(text_[text_.size() - back]) > back) end = text_.size() - back;
    std::string rest = text_.substr(end);
    text_.resize(end);
    return std::exchange(text_, std::move(rest));
}

}  // namespace sim::live
