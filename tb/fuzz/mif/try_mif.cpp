// Initial words of a memory: a MIF or an Intel HEX file is refused with its line, or read; the
// words written as a MIF are read as the same.  Two bytes in front say how wide and how deep it is.
#include <stdexcept>

#include <fmt/format.h>

#include "sim/project/formats.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

using sim::project::MemoryImage;

std::string as_mif(const MemoryImage& image) {
    std::string text = fmt::format(
        "WIDTH={};\nDEPTH={};\nADDRESS_RADIX=DEC;\nDATA_RADIX=HEX;\n"
        "CONTENT BEGIN\n",
        image.width(), image.words());
    for (std::size_t word = 0; word < image.words(); ++word) {
        std::string digits;
        for (std::size_t part = 0; part < (image.width() + 31) / 32; ++part)
            digits = fmt::format("{:08x}", image.part(word, part)) + digits;
        text += fmt::format("{} : {};\n", word, digits);
    }
    return text + "END;\n";
}

bool same(const MemoryImage& a, const MemoryImage& b) {
    for (std::size_t word = 0; word < a.words(); ++word)
        for (std::size_t part = 0; part < (a.width() + 31) / 32; ++part)
            if (a.part(word, part) != b.part(word, part)) return false;
    return true;
}

}  // namespace

void try_mif(std::string_view input) {
    const unsigned width = next_byte(input) % 70 + 1, words = next_byte(input) + 1;
    MemoryImage image{width, words};
    try {
        if (input.substr(0, 1) == ":")
            sim::project::read_intel_hex(input, "m.hex", image);
        else
            sim::project::read_mif(input, "m.mif", image);
    } catch (const std::runtime_error& error) {
        must_be_a_line(error.what());
        must(std::string_view{error.what()}.find("expected") != std::string_view::npos,
             "a refusal says what was expected");
        return;
    }
    MemoryImage again{width, words};
    sim::project::read_mif(as_mif(image), "again.mif", again);
    must(same(image, again), "words that are written are read as the same");
}

}  // namespace fuzz
