#include "tb/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "sim/text/printable.h"

namespace fuzz {

void must(bool holds, const char* promise) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", promise);
    std::abort();
}

void must_be_a_line(const std::string& message) {
    const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
    if (!message.empty() && std::all_of(message.begin(), message.end(), is_plain)) return;
    if (!message.empty() && sim::printable(message) == message) return;
    std::fprintf(stderr, "message: %s\n", sim::printable(message).c_str());
    must(false, "a message is one printable line");
}

std::string path_in_memory(std::string_view bytes) {
    static const int file = memfd_create("input", MFD_CLOEXEC);  // one for all inputs
    const auto count = static_cast<ssize_t>(bytes.size());
    must(ftruncate(file, count) == 0 && pwrite(file, bytes.data(), bytes.size(), 0) == count,
         "there is memory for a file");
    return "/proc/self/fd/" + std::to_string(file);
}

std::string_view next_line(std::string_view& rest) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    return line;
}

unsigned char next_byte(std::string_view& rest) {
    if (rest.empty()) return 0;
    const auto byte = static_cast<unsigned char>(rest[0]);
    rest.remove_prefix(1);
    return byte;
}

}  // namespace fuzz
