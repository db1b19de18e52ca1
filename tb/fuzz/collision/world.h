// world.h - any bytes as polygons and a world of them, put through the whole library.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz {

// Reads polygons from the bytes, right and wrong ones (NaN, infinities, coordinates beyond the
// grid, no lines, too many, boxes inside out or too small), and hands them to every algorithm.
// Aborts if two of them disagree about valid shapes, if a refused call leaves pairs in its result,
// or if a contact is missing.  Worlds of more than most_with_all shapes are not given to the
// paper's algorithms but for ORIGINAL, with which the others are compared.
void try_world(const std::uint8_t* bytes, std::size_t count, std::size_t most_with_all = SIZE_MAX);

}  // namespace fuzz
