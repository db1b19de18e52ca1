// open_file.h - LinuxFiles' record of an open file
#pragma once

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <memory>
#include <string>

#include "sim/linux/files.h"

namespace sim {

class LinuxFiles::Handle {
public:
    explicit Handle(int fd) : fd_{fd} {}
    ~Handle() {
        if (fd_ >= 0) ::close(fd_);
    }
    Handle(const Handle&) = delete;
    int fd() const { return fd_; }

private:
    int fd_;
};

struct LinuxFiles::File {
    enum class Kind { CONSOLE, MEMORY, HOST, DEVICE } kind;
    std::uint32_t flags;
    std::shared_ptr<Handle> host = nullptr;
    std::shared_ptr<LinuxDevice> device = nullptr;
    std::string path = "";
    bool is_outside = false;              // of the root: only to be read
    std::vector<std::string> names = {};  // of a folder that is read, sorted
    std::size_t next_name = 0;
};

struct LinuxFiles::Place {
    std::shared_ptr<Handle> folder;
    std::string name, path;
    bool is_outside = false;  // of the root: among the libraries
};

constexpr const char* MEMORY_PATH = "/dev/mem";
constexpr const char* SERIAL_CONSOLE = "/dev/ttyS0";  // at which the program was started

// Of a name of the console.
inline std::optional<FileStatus> console_status(const std::string& path) {
    const auto device = [](std::uint64_t major, std::uint64_t minor) {
        return FileStatus{S_IFCHR | 0620, 0, 1, major << 8 | minor};
    };
    if (path == SERIAL_CONSOLE) return device(4, 64);
    if (path == "/dev/console") return device(5, 1);
    if (path == "/dev/tty") return device(5, 0);
    return std::nullopt;
}

// The host's file `fd` is one of the last that it allows, which a run needs itself.  The host
// numbers files from the lowest free number on.
inline bool is_one_too_many(int fd) {
    constexpr rlim_t SPARE_FILES = 32;
    rlimit limit{};
    return getrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
           static_cast<rlim_t>(fd) + SPARE_FILES >= limit.rlim_cur;
}

// The host's result, as the kernel returns it.
inline std::int64_t or_error(std::int64_t result) { return result < 0 ? -errno : result; }

}  // namespace sim
