// trace_file.cpp - see trace_file.h
#include "sim/files/trace_file.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <string>

#include <zlib.h>

namespace sim {

namespace {

constexpr const char* CUT_OFF = "cannot write: it was cut off (is the disk full?)";
constexpr int WRONG_INPUT = 2;

// Prepared for the signal handler, which can neither allocate nor format.
char crash_report[8192];
char hierarchy_name[4096 + 8];  // the writer's temporary file, until it is closed

void copy(char* to, std::size_t capacity, const std::string& text) {
    std::strncpy(to, text.c_str(), capacity - 1);
}

void on_bus_error(int) {
    [[maybe_unused]] const ssize_t written =
        write(STDERR_FILENO, crash_report, std::strlen(crash_report));
    remove_open_parts();
    unlink(hierarchy_name);
    _exit(WRONG_INPUT);
}

// Block types; the hierarchy comes plain or packed in two ways.
enum : std::uint8_t {
    HEADER = 0,
    GEOMETRY = 3,
    HIERARCHY = 4,
    LZ4 = 6,
    LZ4_TWICE = 7,
    PACKED = 254,
    SKIP = 255
};

constexpr std::size_t MOST_TO_PACK = 256u << 20;

void put(std::string& to, std::uint64_t value) {
    for (int shift = 56; shift >= 0; shift -= 8) to += static_cast<char>(value >> shift & 0xff);
}

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

std::string packed_fst(const std::string& bytes) {
    constexpr int GZIP = 16, FAST = 4;
    z_stream stream{};
    if (deflateInit2(&stream, FAST, Z_DEFLATED, MAX_WBITS + GZIP, MAX_MEM_LEVEL,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc{};
    std::string block(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    deflate(&stream, Z_FINISH);
    block.resize(stream.total_out);
    deflateEnd(&stream);
    std::string file(1, static_cast<char>(PACKED));
    put(file, 16 + block.size());  // all that follows the type
    put(file, bytes.size());
    return file + block;
}

TraceFile::TraceFile(const std::filesystem::path& path) : file_{path} {
    copy(crash_report, sizeof crash_report,
         std::string{"de1sim: "} + IoError(path, CUT_OFF).what() + "\n");
    copy(hierarchy_name, sizeof hierarchy_name, part().string() + ".hier");
    std::signal(SIGBUS, on_bus_error);
}

TraceFile::~TraceFile() { std::signal(SIGBUS, SIG_DFL); }

void TraceFile::commit(bool packed) {
    if (!is_whole_fst(part())) throw IoError(file_.path(), CUT_OFF);
    if (packed && std::filesystem::file_size(part()) <= MOST_TO_PACK) {
        write_whole_file(file_.path(), packed_fst(read_whole_file(part(), MOST_TO_PACK)));
        return;
    }
    file_.commit();
}

}  // namespace sim
