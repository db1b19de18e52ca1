#include "tb/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "sim/report/printable.h"

namespace fuzz {

void must(bool holds, const char* promise) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", promise);
    std::abort();
}

void must_be_a_line(const std::string& message) {
    if (!message.empty() && sim::printable(message) == message) return;
    std::fprintf(stderr, "message: %s\n", sim::printable(message).c_str());
    must(false, "a message is one printable line");
}

MemoryFile::MemoryFile(std::string_view bytes) : descriptor_{memfd_create("input", MFD_CLOEXEC)} {
    const auto count = static_cast<ssize_t>(bytes.size());
    must(write(descriptor_, bytes.data(), bytes.size()) == count, "there is memory for a file");
}

MemoryFile::~MemoryFile() { close(descriptor_); }

std::string MemoryFile::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

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
