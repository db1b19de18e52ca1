// picture_store.h - the picture as it is now, and what of it a client has not seen yet.
//
// A client that is slow thus loses pictures in between, and never holds memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/live/picture.h"

namespace sim::live {

class PictureStore {
public:
    // A message of kind PICTURE.
    void update(const std::string& bytes);
    void clear() { *this = {}; }

    std::uint64_t version() const { return version_; }
    // A message with the tiles that are newer than `version`; all, for 0.  As the page gets it:
    // after a byte that says its kind.
    std::string since(std::uint64_t version) const;

private:
    std::string head_;
    std::vector<std::string> tiles_;         // with their number, as in the message
    std::vector<std::uint64_t> changed_in_;  // version
    std::uint64_t version_ = 0, size_changed_in_ = 0;
};

}  // namespace sim::live
