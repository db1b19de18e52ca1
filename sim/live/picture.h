// picture.h - pictures as messages of kind PICTURE: the tiles that have changed.
//
//   u16 width, height; u32 number of the frame; then for each tile: u16 number, u8 rgb[16*16*3]
//
// Little-endian.  Tiles of 16 x 16 pixels are counted row by row from the top left, from 0; what of
// a tile is beyond the right or lower edge is 0.  Where width or height differ from the message
// before, all of the picture is in the message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace sim::live {

constexpr unsigned TILE = 16;
constexpr std::size_t PICTURE_HEAD = 8, TILE_BYTES = 2 + TILE * TILE * 3;

inline unsigned tiles(unsigned pixels) { return (pixels + TILE - 1) / TILE; }

inline void put(std::string& bytes, std::uint32_t value, unsigned count) {
    for (unsigned i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i);
}
inline std::uint32_t read_number(const std::string& bytes, std::size_t at, unsigned count) {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < count; ++i)
        value |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << 8 * i;
    return value;
}

}  // namespace sim::live
