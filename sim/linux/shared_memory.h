// shared_memory.h - memory that several processes of a Linux program may map.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sim {

class SharedMemory {
public:
    SharedMemory();                                             // std::bad_alloc
    SharedMemory(const std::uint8_t* data, std::size_t bytes);  // with this in it
    ~SharedMemory();
    SharedMemory(const SharedMemory&) = delete;

    int fd() const { return fd_; }  // the host's
    std::uint64_t size() const { return size_; }
    void resize(std::uint64_t bytes);  // as ftruncate: zeros after the old end
    // From now on it may be mapped up to here; what lies beyond its size is zero.
    bool reserve(std::uint64_t bytes);

private:
    int fd_;
    std::uint64_t size_ = 0, reserved_ = 0;
};

}  // namespace sim
