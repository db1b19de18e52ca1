// Memory Initialization Files: words of text, and the grammar of them.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>

#include "sim/project/formats.h"

namespace sim::project {
namespace {

using Word = std::vector<std::uint32_t>;

constexpr std::size_t MOST_BITS = 4096;  // far more than Quartus has in a memory's word

class Mif {
public:
    Mif(std::string_view text, const std::string& name) : text_{text}, name_{name} {
        if (text_.substr(0, 3) == "\xEF\xBB\xBF") text_.remove_prefix(3);
        next();
    }

    MifSize size() {
        while (token_ != "CONTENT") read_setting();
        return {static_cast<unsigned>(width_), depth_};
    }

    void read(MemoryImage& image) {
        size();
        next();
        expect("BEGIN");
        while (token_ != "END") read_entry(image);
    }

private:
    [[noreturn]] void fail(const std::string& expected) const {
        throw std::runtime_error(
            fmt::format("{}:{}: {}, expected {}", name_, line_, found(), expected));
    }

    // Printable: all but words is a single character.
    std::string found() const {
        if (token_.empty()) return "the file ends";
        const auto first = static_cast<unsigned char>(token_[0]);
        return std::isprint(first) ? "\"" + token_ + "\"" : fmt::format("the byte 0x{:02X}", first);
    }

    // Text up to the next one that means something; token_ is empty at the end.
    void next() {
        skip_blanks();
        token_.clear();
        if (text_.empty()) return;
        std::size_t length = 1;
        if (text_.substr(0, 2) == "..") length = 2;
        if (is_word(text_[0])) {
            while (length < text_.size() && is_word(text_[length]) &&
                   text_.substr(length, 2) != "--")
                ++length;
        }
        for (const char c : text_.substr(0, length)) {
            token_ += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
        text_.remove_prefix(length);
    }

    static bool is_word(char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '+';
    }

    void skip_blanks() {
        while (!text_.empty()) {
            std::size_t length = 0;
            if (std::isspace(static_cast<unsigned char>(text_[0]))) {
                length = 1;
            } else if (text_.substr(0, 2) == "--") {
                length = std::min(text_.find('\n'), text_.size());
            } else if (text_[0] == '%') {
                const std::size_t end = text_.find('%', 1);
                if (end == std::string_view::npos) {
                    token_ = "%";
                    fail("another % at the comment's end");
                }
                length = end + 1;
            } else {
                return;
            }
            for (const char c : text_.substr(0, length)) line_ += c == '\n';
            text_.remove_prefix(length);
        }
    }

    void expect(const std::string& token) {
        if (token_ != token) fail("\"" + token + "\"");
        next();
    }

    void read_setting() {
        const std::string setting = token_;
        if (setting != "WIDTH" && setting != "DEPTH" && setting != "ADDRESS_RADIX" &&
            setting != "DATA_RADIX") {
            fail("WIDTH, DEPTH, ADDRESS_RADIX, DATA_RADIX or CONTENT");
        }
        next();
        expect("=");
        if (setting == "WIDTH") {
            width_ = number(10, "the width in bits");
            if (width_ == 0 || width_ > MOST_BITS) fail("a width of 1 to 4096 bits");
        } else if (setting == "DEPTH") {
            depth_ = number(10, "the number of words");
        } else {
            const std::map<std::string, unsigned> radices{
                {"BIN", 2}, {"OCT", 8}, {"DEC", 10}, {"UNS", 10}, {"HEX", 16}};
            const auto radix = radices.find(token_);
            if (radix == radices.end()) fail("BIN, OCT, DEC, HEX or UNS");
            (setting == "DATA_RADIX" ? data_radix_ : address_radix_) = radix->second;
            if (setting == "DATA_RADIX") signed_ = token_ == "DEC";
        }
        next();
        expect(";");
    }

    // `address : values;` or `[first..last] : values;`.
    void read_entry(MemoryImage& image) {
        if (width_ == 0 || depth_ == 0) fail("WIDTH and DEPTH before the content");
        const bool range = token_ == "[";
        if (range) next();
        std::size_t at = address();
        std::size_t last = at;
        if (range) {
            expect("..");
            last = address();
            expect("]");
        }
        expect(":");
        std::vector<Word> values;
        for (; token_ != ";"; next()) values.push_back(value());
        if (values.empty()) fail("a value");
        if (!range) last = at + values.size() - 1;
        if (last < at || last >= depth_) {
            fail(fmt::format("addresses {} to {} in order and below DEPTH={}", at, last, depth_));
        }
        last = std::min(last, image.words());  // what lies after is lost
        for (std::size_t i = 0; at <= last; ++at) image.set(at, values[i++ % values.size()]);
        next();
    }

    std::size_t address() {
        const std::size_t result = number(address_radix_, "an address");
        next();
        return result;
    }

    unsigned digit(char c, unsigned radix, const std::string& what) const {
        const unsigned value =
            static_cast<unsigned>(std::isdigit(static_cast<unsigned char>(c)) ? c - '0'
                                  : c >= 'A' && c <= 'Z'                      ? c - 'A' + 10
                                                                              : 99);
        if (value >= radix) fail(fmt::format("{} in base {}", what, radix));
        return value;
    }

    std::size_t number(unsigned radix, const std::string& what) const {
        std::size_t result = 0;
        if (token_.empty() || token_.size() > 32) fail(what);
        for (const char c : token_) {
            result = result * radix + digit(c, radix, what);
            if (result > 1u << 30) fail(what + " of less than a thousand million");
        }
        return result;
    }

    Word value() const {
        const bool negative = signed_ && token_[0] == '-';
        const std::string digits = token_.substr(negative || token_[0] == '+');
        if (digits.empty()) fail("a value");
        Word word((width_ + 31) / 32);
        for (const char c : digits) {
            std::uint64_t carry = digit(c, data_radix_, "a value");
            for (std::uint32_t& part : word) {
                carry += std::uint64_t{part} * data_radix_;
                part = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            const unsigned top = width_ % 32;
            if (carry || (top && word.back() >> top)) fail(fmt::format("at most {} bits", width_));
        }
        if (negative) {
            bool carry = true;
            for (std::uint32_t& part : word) {
                part = ~part + carry;
                carry = carry && part == 0;
            }
        }
        return word;
    }

    std::string_view text_;
    const std::string& name_;
    unsigned line_ = 1;
    std::string token_;  // in capitals
    std::size_t width_ = 0;
    std::size_t depth_ = 0;
    unsigned address_radix_ = 16;
    unsigned data_radix_ = 16;
    bool signed_ = false;
};

}  // namespace

MifSize size_of_mif(std::string_view text, const std::string& name) {
    return Mif{text, name}.size();
}

void read_mif(std::string_view text, const std::string& name, MemoryImage& image) {
    Mif{text, name}.read(image);
}

}  // namespace sim::project
