// html.cpp - see html.h
#include "sim/page/html.h"

#include <openssl/evp.h>

namespace sim::page {

std::string data_url(const std::vector<std::uint8_t>& png) {
    std::vector<unsigned char> digits((png.size() + 2) / 3 * 4 + 1);  // with a 0 behind them
    EVP_EncodeBlock(digits.data(), png.data(), static_cast<int>(png.size()));
    return "data:image/png;base64," + std::string(digits.begin(), digits.end() - 1);
}

}  // namespace sim::page
