// trace_file.cpp - see trace_file.h
#include "sim/report/trace_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

namespace sim {

namespace {

constexpr const char* CUT_OFF = "cannot write: it was cut off (is the disk full?)";
constexpr int WRONG_INPUT = 2;

// Prepared for the signal handler, which can neither allocate nor format.
char last_words[8192];
char part_name[4096];
char hierarchy_name[4096 + 8];  // the writer's temporary file, until it is closed

void copy(char* to, std::size_t capacity, const std::string& text) {
    std::strncpy(to, text.c_str(), capacity - 1);
}

void on_bus_error(int) {
    [[maybe_unused]] const ssize_t said = write(STDERR_FILENO, last_words, std::strlen(last_words));
    unlink(part_name);
    unlink(hierarchy_name);
    _exit(WRONG_INPUT);
}

// Block types; the hierarchy comes plain or packed in two ways.
enum : std::uint8_t { HEADER = 0, GEOMETRY = 3, HIERARCHY = 4, LZ4 = 6, LZ4_TWICE = 7, SKIP = 255 };

}  // namespace

bool is_whole_fst(const std::filesystem::path& path) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(path, error);
    std::ifstream file{path, std::ios::binary};
    if (error || !file) return false;
    bool geometry = false, hierarchy = false;
    std::uint64_t at = 0;
    while (at < size) {
        std::array<char, 9> head{};  // type, then the length of all that follows the type
        if (!file.seekg(static_cast<std::streamoff>(at)).read(head.data(), head.size()))
            return false;
        const auto type = static_cast<std::uint8_t>(head[0]);
        std::uint64_t length = 0;
        for (unsigned i = 1; i < head.size(); ++i)
            length = length << 8 | static_cast<std::uint8_t>(head[i]);
        if (type == SKIP || (at == 0) != (type == HEADER)) return false;
        if (length < 8 || length > size - at - 1) return false;
        geometry = geometry || type == GEOMETRY;
        hierarchy = hierarchy || type == HIERARCHY || type == LZ4 || type == LZ4_TWICE;
        at += 1 + length;
    }
    return geometry && hierarchy;
}

TraceFile::TraceFile(const std::filesystem::path& path) : file_{path} {
    copy(last_words, sizeof last_words,
         std::string{"de1sim: "} + IoError(path, CUT_OFF).what() + "\n");
    copy(part_name, sizeof part_name, part().string());
    copy(hierarchy_name, sizeof hierarchy_name, part().string() + ".hier");
    std::signal(SIGBUS, on_bus_error);
}

TraceFile::~TraceFile() { std::signal(SIGBUS, SIG_DFL); }

void TraceFile::commit() {
    if (!is_whole_fst(part())) throw IoError(file_.path(), CUT_OFF);
    file_.commit();
}

}  // namespace sim
