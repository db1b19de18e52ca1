// Intel HEX: `:` count, address, kind, bytes, checksum; all as hexadecimal digits.

#include <fmt/format.h>

#include <stdexcept>

#include "sim/project/formats.h"

namespace sim::project {
namespace {

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// The bytes of a record, the colon left out; `fail` does not return.
template <class Fail>
std::vector<std::uint8_t> bytes_of(std::string_view line, const Fail& fail) {
    if (line[0] != ':') fail("does not begin with a colon");
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 1; i < line.size(); i += 2) {
        const int high = digit(line[i]);
        const int low = i + 1 < line.size() ? digit(line[i + 1]) : -1;
        if (high < 0 || low < 0) fail("column " + std::to_string(i + 1) + " is no byte");
        bytes.push_back(static_cast<std::uint8_t>(high * 16 + low));
    }
    if (bytes.size() < 5) fail("is too short");
    if (bytes.size() != bytes[0] + 5u) {
        fail(fmt::format("has {} bytes of data instead of {}", bytes.size() - 5, bytes[0]));
    }
    unsigned sum = 0;
    for (const std::uint8_t byte : bytes) sum += byte;
    if (sum % 256) {
        const unsigned right = (bytes.back() + 256 - sum % 256) % 256;
        fail(fmt::format("has the checksum {:02X} instead of {:02X}", bytes.back(), right));
    }
    return bytes;
}

}  // namespace

void read_intel_hex(std::string_view text, const std::string& name, MemoryImage& image) {
    const std::size_t word_bytes = (image.width() + 7) / 8;
    std::size_t base = 0;
    unsigned number = 0;
    while (!text.empty()) {
        ++number;
        const auto fail = [&](const std::string& what) {
            throw std::runtime_error(fmt::format(
                "{}:{}: the record {}, expected :COUNT ADDRESS KIND DATA CHECKSUM in hexadecimal",
                name, number, what));
        };
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string_view::npos) continue;
        line = line.substr(first, line.find_last_not_of(" \t\r") - first + 1);

        const std::vector<std::uint8_t> record = bytes_of(line, fail);
        const std::size_t count = record[0];
        const std::size_t address = record[1] * 256u + record[2];
        const std::uint8_t* data = record.data() + 4;
        switch (record[3]) {
            case 0:
                for (std::size_t at = 0; at < count; at += word_bytes) {
                    const std::size_t length = std::min(word_bytes, count - at);
                    std::vector<std::uint32_t> parts((word_bytes + 3) / 4);
                    for (std::size_t i = 0; i < length; ++i) {
                        const std::uint32_t byte = data[at + length - 1 - i];
                        parts[i / 4] |= byte << i % 4 * 8;
                    }
                    image.set(base + address + at / word_bytes, parts);
                }
                break;
            case 1: return;
            case 2:
            case 4:
                if (count != 2) fail("is of kind 02 or 04 without two bytes");
                base = data[0] * 256u + data[1];
                base <<= record[3] == 2 ? 4 : 16;
                break;
            case 3:
            case 5: break;  // where a program starts
            default: fail(fmt::format("is of kind {:02X}", record[3]));
        }
    }
}

}  // namespace sim::project
