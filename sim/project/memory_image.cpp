// The words, and which of the two formats a file has.

#include "sim/project/memory_image.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "sim/project/formats.h"

namespace sim::project {

namespace {

// What $readmemh reads: nothing but digits and white space in the first line that has some.
void refuse_plain_words(const std::string& text, const std::filesystem::path& file) {
    std::istringstream lines{text};
    std::string line;
    for (unsigned number = 1; std::getline(lines, line); ++number) {
        const std::size_t word = line.find_first_not_of(" \t\r");
        if (word == std::string::npos || line.compare(word, 2, "//") == 0) continue;
        if (line.find_first_not_of("0123456789abcdefABCDEF_ \t\r", word + (line[word] == '@')) !=
            std::string::npos)
            return;
        throw std::runtime_error(fmt::format(
            "{}:{}: \"{}\" are words for $readmemh, expected Intel HEX, whose lines "
            "begin with a colon, or a MIF",
            file.string(), number,
            line.substr(word, line.find_last_not_of(" \t\r") + 1 - word).substr(0, 40)));
    }
}

}  // namespace

MemoryImage::MemoryImage(unsigned width, std::size_t words)
    : width_{width}, words_{words}, parts_{(width + 31) / 32}, bits_(words * parts_) {}

std::uint32_t MemoryImage::part(std::size_t word, std::size_t part) const {
    return word < words_ && part < parts_ ? bits_[word * parts_ + part] : 0;
}

void MemoryImage::set(std::size_t word, const std::vector<std::uint32_t>& parts) {
    if (word >= words_) return;
    for (std::size_t i = 0; i < parts_; ++i) {
        std::uint32_t bits = i < parts.size() ? parts[i] : 0;
        if (i + 1 == parts_ && width_ % 32) bits &= (1u << width_ % 32) - 1;
        bits_[word * parts_ + i] = bits;
    }
}

MemoryImage read_memory_image(const std::filesystem::path& file, unsigned width,
                              std::size_t words) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in || std::filesystem::is_directory(file)) {
        throw std::runtime_error(
            fmt::format("{}: cannot be read, expected a MIF or Intel HEX file", file.string()));
    }
    refuse_plain_words(text, file);
    MemoryImage image{width, words};
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && text[first] == ':') {
        read_intel_hex(text, file.string(), image);
    } else {
        read_mif(text, file.string(), image);
    }
    return image;
}

}  // namespace sim::project
