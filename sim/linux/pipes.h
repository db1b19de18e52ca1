// pipes.h - what two ends of an open file have in common: pipes, and connected sockets.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "sim/linux/device.h"

namespace sim {

// Bytes in one direction, 64 KB at most unless a program asks for another size, 1 MB at most; a
// write of 4096 or fewer is whole or not at all.
class BytePipe {
public:
    static constexpr std::size_t WHOLE = 4096, LARGEST = 1 << 20;

    std::int64_t read(void* data, std::size_t bytes, bool peek = false);
    std::int64_t write(const void* data, std::size_t bytes);
    unsigned can_do() const;  // of both ends
    std::size_t size() const { return bytes_.size(); }
    std::size_t capacity() const { return capacity_; }
    // The next power of two.  EPERM, EBUSY: there is more in it.
    std::int64_t set_capacity(std::uint32_t bytes);

    std::uint64_t writes() const { return writes_; }
    std::uint64_t rooms() const { return rooms_; }  // that a full one got

    bool has_reader = true, has_writer = true;

private:
    std::deque<std::uint8_t> bytes_;
    std::size_t capacity_ = 65536;
    std::uint64_t writes_ = 0, rooms_ = 0;
};

// The end to read from, and the one to write to.
std::pair<std::shared_ptr<LinuxDevice>, std::shared_ptr<LinuxDevice>> make_pipe();

}  // namespace sim
