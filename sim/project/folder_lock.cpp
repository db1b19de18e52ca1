#include "sim/project/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sim/project/settings.h"

namespace sim::project {

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

void FolderLock::acquire(const std::filesystem::path& file) {
    descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw ProjectError{file.string() + ": " + std::strerror(errno)};
    flock(descriptor_, LOCK_EX);  // where a file system has none, there is no other process either
}

}  // namespace sim::project
