// memory_image.h - the initial words of a memory, as a MIF or an Intel HEX file says them.
//
// MIF: WIDTH, DEPTH, ADDRESS_RADIX and DATA_RADIX (BIN, OCT, DEC, HEX, UNS; without them HEX), then
// CONTENT BEGIN ... END with `address : value value ...;` and `[first..last] : value ...;`, whose
// values are repeated until the range is full.  Comments are -- to the end of the line and %...%.
// Case does not matter.  Negative values only with DEC.
//
// Intel HEX, as Quartus reads it: the address of a record is that of a word, not of a byte; a word
// is as many bytes as its bits need, highest first; the bytes of a record go on in the words that
// follow.  Records 02 and 04 give the upper part of the address.
//
// Words that the file does not mention are 0, and so is the upper part of words wider than the
// file's; of words narrower than a MIF's values the lower bits count.  What lies after the
// memory's last word is lost.  Quartus does so with a warning.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace sim::project {

class MemoryImage {
public:
    // `words` words of `width` bits, all 0.
    MemoryImage(unsigned width, std::size_t words);

    std::size_t words() const { return words_; }
    unsigned width() const { return width_; }

    // Bits 32 * part to 32 * part + 31 of a word; 0 after the last word or bit.
    std::uint32_t part(std::size_t word, std::size_t part) const;

    // Lost after the last word; bits above the width are cut off.
    void set(std::size_t word, const std::vector<std::uint32_t>& parts);

private:
    unsigned width_;
    std::size_t words_;
    std::size_t parts_;
    std::vector<std::uint32_t> bits_;
};

// The two formats are told apart by the file's content, not its name.  Throws std::runtime_error
// "FILE:LINE: ..., expected ..." on a file that is broken, and "FILE: ..." if it cannot be read.
MemoryImage read_memory_image(const std::filesystem::path& file, unsigned width, std::size_t words);

}  // namespace sim::project
