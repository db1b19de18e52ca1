// device.h - an open file of the kernel's own: /dev/null, a text of /proc, a pipe, a socket.
//
// Results are like the kernel's: a number of at least 0, or minus the error; EAGAIN where it would
// have to wait.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "sim/linux/address_space.h"
#include "sim/linux/file_status.h"

namespace sim {

class LinuxDevice {
public:
    // Of these, what would not have to wait.
    static constexpr unsigned READ = 1, WRITE = 2, HUNG_UP = 4, BROKEN = 8,
                              UNKNOWN = 16;   // until something changes
    static constexpr unsigned PRIORITY = 32;  // POLLPRI

    virtual ~LinuxDevice() = default;
    virtual FileStatus status() const = 0;
    virtual std::string name() const = 0;  // in a message about who waits for it
    // Only threads of the run's own processes can end a wait for it.
    virtual bool is_inside() const { return false; }
    virtual unsigned can_do() const { return READ | WRITE; }
    // What can_do() has returned may have changed.
    virtual void look_again() {}
    // How often something has come to be read, or room to write, for EPOLLET; 0: nobody counts.
    virtual std::uint64_t arrivals() const { return 0; }

    virtual std::int64_t read(void*, std::size_t) { return -EINVAL; }
    virtual std::int64_t write(const void*, std::size_t) { return -EINVAL; }
    virtual std::int64_t read_at(void*, std::size_t, std::int64_t) { return -ESPIPE; }
    virtual std::int64_t write_at(const void*, std::size_t, std::int64_t) { return -ESPIPE; }
    virtual std::int64_t seek(std::int64_t, int) { return -ESPIPE; }
    virtual int truncate(std::int64_t) { return -EINVAL; }
    virtual std::int64_t control(std::uint32_t, std::uint32_t, AddressSpace&) { return -ENOTTY; }

    // F_GETPIPE_SZ; F_SETPIPE_SZ with the bytes that are wished for.
    virtual std::int64_t pipe_size() const { return -EBADF; }
    virtual std::int64_t set_pipe_size(std::uint32_t) { return -EBADF; }

    // Of a folder: its names, sorted, with their modes.
    using Entries = std::map<std::string, std::uint32_t>;
    virtual const Entries* entries() const { return nullptr; }

    // For mmap: memory that others may map, too, or what lies on the bus and its bytes.
    virtual std::shared_ptr<SharedMemory> memory() { return nullptr; }
    virtual std::optional<std::pair<std::uint32_t, std::uint32_t>> on_bus() const {
        return std::nullopt;
    }
};

}  // namespace sim
