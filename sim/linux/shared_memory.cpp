#include "sim/linux/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <new>
#include <utility>

#include "sim/linux/address_space.h"
#include "sim/linux/open_file.h"

namespace sim {

namespace {

int unless_too_many(int fd) {
    if (fd >= 0 && !is_one_too_many(fd)) return fd;
    close(fd);
    throw std::bad_alloc{};
}

const void* identity_of(int file) {
    static std::map<std::pair<dev_t, ino_t>, char> files;
    struct stat status {};
    fstat(file, &status);
    return &files[{status.st_dev, status.st_ino}];
}

}  // namespace

SharedMemory::SharedMemory()
    : fd_{unless_too_many(memfd_create("shared", MFD_CLOEXEC))},
      is_file_{false},
      is_writable_{true},
      identity_{this} {}

SharedMemory::SharedMemory(int file)
    : fd_{unless_too_many(fcntl(file, F_DUPFD_CLOEXEC, 0))},
      is_file_{true},
      is_writable_{(fcntl(file, F_GETFL) & O_ACCMODE) == O_RDWR},
      identity_{identity_of(file)} {}

SharedMemory::SharedMemory(const std::uint8_t* data, std::size_t bytes) : SharedMemory{} {
    if (!resize(bytes) || pwrite(fd_, data, bytes, 0) != static_cast<ssize_t>(bytes))
        throw std::bad_alloc{};
}

SharedMemory::~SharedMemory() {
    all_reserved_ -= reserved_;
    close(fd_);
}

std::uint64_t SharedMemory::size() const {
    struct stat status {};
    if (!is_file_) return size_;
    return fstat(fd_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

// The host's file never shrinks: an access beyond its end would end the simulator.
bool SharedMemory::resize(std::uint64_t bytes) {
    if (!reserve(bytes)) return false;
    if (bytes < size_) {
        const auto begin = static_cast<off_t>(bytes), length = static_cast<off_t>(size_ - bytes);
        fallocate(fd_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, begin, length);
    }
    size_ = bytes;
    return true;
}

bool SharedMemory::reserve(std::uint64_t bytes) {
    if (is_file_) return true;
    if (bytes > LIMIT) return false;
    const std::uint64_t pages =
        (bytes + AddressSpace::PAGE - 1) / AddressSpace::PAGE * AddressSpace::PAGE;
    if (pages <= reserved_) return true;
    if (all_reserved_ - reserved_ + pages > LIMIT) return false;
    if (ftruncate(fd_, static_cast<off_t>(pages)) != 0) return false;
    all_reserved_ += pages - reserved_;
    reserved_ = pages;
    return true;
}

}  // namespace sim
