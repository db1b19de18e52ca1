#include "sim/live/picture_store.h"

#include "sim/live/wire.h"

namespace sim::live {

void PictureStore::update(const std::string& bytes) {
    ++version_;
    if (head_.compare(0, 4, bytes, 0, 4) != 0) size_changed_in_ = version_;
    head_ = bytes.substr(0, PICTURE_HEAD);
    const std::size_t count =
        std::size_t{tiles(read_number(head_, 0, 2))} * tiles(read_number(head_, 2, 2));
    tiles_.resize(count);
    changed_in_.resize(count);
    for (std::size_t at = PICTURE_HEAD; at + TILE_BYTES <= bytes.size(); at += TILE_BYTES) {
        const std::uint32_t number = read_number(bytes, at, 2);
        if (number >= count) continue;
        tiles_[number] = bytes.substr(at, TILE_BYTES);
        changed_in_[number] = version_;
    }
}

std::string PictureStore::since(std::uint64_t version) const {
    std::string message(1, static_cast<char>(Kind::PICTURE));
    message += head_;
    for (std::size_t n = 0; n < tiles_.size(); ++n)
        if (changed_in_[n] > version || size_changed_in_ > version) message += tiles_[n];
    return message;
}

}  // namespace sim::live
