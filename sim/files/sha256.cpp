// sha256.cpp - SHA-256 by OpenSSL
#include "sim/files/sha256.h"

#include <openssl/evp.h>

#include <stdexcept>

namespace sim {

std::string sha256_hex(const void* bytes, std::size_t size) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned length = 0;
    if (EVP_Digest(bytes, size, digest, &length, EVP_sha256(), nullptr) != 1)
        throw std::runtime_error("OpenSSL gave no SHA-256");
    std::string hex;
    for (unsigned i = 0; i < length; ++i) {
        hex += "0123456789abcdef"[digest[i] >> 4];
        hex += "0123456789abcdef"[digest[i] & 15];
    }
    return hex;
}

std::string sha256_hex(const std::vector<std::uint8_t>& bytes) {
    return sha256_hex(bytes.data(), bytes.size());
}

}  // namespace sim
