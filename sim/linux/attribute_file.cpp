#include "sim/linux/attribute_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <climits>
#include <cstdlib>
#include <cstring>

namespace sim {

FileStatus AttributeFile::status() const {
    constexpr std::uint64_t SHOWN_BYTES = 4096;  // whatever it shows
    return {S_IFREG | (attribute_.show ? 0444u : 0) | (attribute_.store ? 0200u : 0), SHOWN_BYTES,
            1, 0};
}

unsigned AttributeFile::can_do() const {
    const bool changed = attribute_.changes && (is_gone() || attribute_.changes->count != seen_);
    return READ | WRITE | (changed ? PRIORITY | BROKEN : 0);
}

std::int64_t AttributeFile::read(void* data, std::size_t bytes) {
    const std::int64_t count = read_at(data, bytes, at_);
    if (count > 0) at_ += count;
    return count;
}

std::int64_t AttributeFile::read_at(void* data, std::size_t bytes, std::int64_t offset) {
    if (is_gone()) return -ENODEV;
    if (offset < 0 || !attribute_.show) return -EINVAL;
    if (offset == 0) {
        if (attribute_.changes) seen_ = attribute_.changes->count;
        shown_ = attribute_.show();
    }
    const std::size_t from = std::min(static_cast<std::size_t>(offset), shown_.size());
    return static_cast<std::int64_t>(shown_.copy(static_cast<char*>(data), bytes, from));
}

std::int64_t AttributeFile::write(const void* data, std::size_t bytes) {
    if (is_gone()) return -ENODEV;
    if (!attribute_.store) return -EINVAL;
    if (bytes == 0) return 0;
    const int error = attribute_.store(std::string{static_cast<const char*>(data), bytes});
    return error ? error : static_cast<std::int64_t>(bytes);
}

std::int64_t AttributeFile::seek(std::int64_t offset, int whence) {
    std::int64_t to = offset;
    if (whence == SEEK_CUR ? __builtin_add_overflow(at_, offset, &to) : whence != SEEK_SET)
        return -EINVAL;
    return to < 0 ? -EINVAL : at_ = to;
}

namespace attribute {

int number_in(const std::string& text, int base, long& value) {
    const char* const begin = text.c_str();
    const char* const digits = begin + (*begin == '-' || *begin == '+' ? 1 : 0);
    if (!std::isxdigit(static_cast<unsigned char>(*digits))) return -EINVAL;
    char* end = nullptr;
    errno = 0;
    value = std::strtol(begin, &end, base);
    const bool out_of_range = errno == ERANGE || value > INT32_MAX || value < INT32_MIN;
    if (end == begin || (*end != 0 && (*end != '\n' || end[1] != 0))) return -EINVAL;
    return out_of_range ? -ERANGE : 0;
}

bool is_word(const std::string& text, const char* word) {
    const std::string written = text.c_str();
    return written == word || written == std::string{word} + '\n';
}

}  // namespace attribute

}  // namespace sim
