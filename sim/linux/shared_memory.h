// shared_memory.h - memory that several processes of a Linux program may map, or a file's pages.
//
// All of it together is at most LIMIT, as much as the board has, without the files.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sim {

class SharedMemory {
public:
    static constexpr std::uint64_t LIMIT = 1u << 30;  // bytes

    // std::bad_alloc: the host refuses, or the limit is reached.
    SharedMemory();
    SharedMemory(const std::uint8_t* data, std::size_t bytes);  // with this in it
    // The pages of a file that is open on the host, which others may make longer or shorter.
    // std::bad_alloc: the host has no more files to open.
    explicit SharedMemory(int file);
    ~SharedMemory();
    SharedMemory(const SharedMemory&) = delete;

    int fd() const { return fd_; }  // the host's
    bool is_file() const { return is_file_; }
    const void* identity() const { return identity_; }  // the same for the same file
    bool is_writable() const { return is_writable_; }   // no: of a file that is open for reading
    std::uint64_t size() const;                         // of a file: as it is now
    // As ftruncate: zeros after the old end.  False, and nothing done, if there is no room.
    bool resize(std::uint64_t bytes);
    // From now on it may be mapped up to here; what lies beyond its size is zero.  False, and
    // nothing done, if there is no room.
    bool reserve(std::uint64_t bytes);

private:
    const int fd_;
    const bool is_file_, is_writable_;
    const void* const identity_;
    std::uint64_t size_ = 0, reserved_ = 0;
    inline static std::uint64_t all_reserved_ = 0;
};

}  // namespace sim
