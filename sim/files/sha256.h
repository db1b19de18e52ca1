// sha256.h - SHA-256 of a block of bytes, as 64 hex digits
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sim {

std::string sha256_hex(const void* bytes, std::size_t size);
std::string sha256_hex(const std::vector<std::uint8_t>& bytes);

}  // namespace sim
