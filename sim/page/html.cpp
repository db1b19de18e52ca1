// html.cpp - see html.h
#include "sim/page/html.h"

#include <openssl/evp.h>

namespace sim::page {

std::string base64(std::string_view bytes) {
    std::vector<unsigned char> digits((bytes.size() + 2) / 3 * 4 + 1);  // with a 0 after them
    EVP_EncodeBlock(digits.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    static_cast<int>(bytes.size()));
    return {digits.begin(), digits.end() - 1};
}

std::string data_url(const std::vector<std::uint8_t>& png) {
    return "data:image/png;base64," +
           base64({reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace sim::page
