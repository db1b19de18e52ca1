// folder_lock.h - what is written into a folder, by one process at a time
#pragma once

#include <filesystem>

namespace sim::project {

// Held by one process at a time; others wait.
class FolderLock {
public:
    FolderLock() = default;
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    void acquire(const std::filesystem::path& file);  // ProjectError: cannot be written

private:
    int descriptor_ = -1;
};

}  // namespace sim::project
