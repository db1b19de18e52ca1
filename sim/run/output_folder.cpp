// output_folder.cpp - see output_folder.h
#include "sim/run/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "sim/files/run_files.h"
#include "sim/files/whole_file.h"
#include "sim/text/pattern.h"

namespace sim {

namespace fs = std::filesystem;

namespace {

// The process with a flock() on the file, as /proc/locks tells; 0 where it does not.  Some file
// systems give another device there than stat() does, so an inode alone is better than nothing.
long holder_of(int descriptor) {
    struct stat file {};
    if (fstat(descriptor, &file) != 0) return 0;
    long by_inode = 0;
    std::ifstream locks{"/proc/locks"};
    for (std::string line; std::getline(locks, line);) {
        long pid = 0;
        unsigned major_number = 0, minor_number = 0;
        unsigned long inode = 0;  // "1: FLOCK  ADVISORY  WRITE 15052 fe:00:247066 0 EOF"
        if (std::sscanf(line.c_str(), "%*d: FLOCK %*s %*s %ld %x:%x:%lu", &pid, &major_number,
                        &minor_number, &inode) != 4 ||
            inode != file.st_ino || pid <= 0)
            continue;
        if (makedev(major_number, minor_number) == file.st_dev) return pid;
        by_inode = pid;
    }
    return by_inode;
}

// Only names that a run makes; anything else in the folder is somebody's.
void remove_old(const fs::path& folder, const char* names) {
    const Pattern pattern{names};
    std::error_code error;
    for (fs::directory_iterator it{folder, error}, end; !error && it != end; it.increment(error)) {
        std::error_code failed;
        if (pattern.matches(it->path().filename().string()) && it->is_regular_file(failed))
            fs::remove(it->path(), failed);
        if (failed) throw IoError{it->path(), "remove", failed.value()};
    }
}

}  // namespace

OutputFolder::OutputFolder(fs::path path) : path_{std::move(path)} {
    make_folder(path_);
    lock();
    try {
        remove_old(path_, RUN_FILES);
        remove_old(path_ / "frames", FRAME_FILES);
        remove_old(path_ / "mismatch", MISMATCH_FILES);
    } catch (...) {
        close(descriptor_);
        throw;
    }
}

OutputFolder::~OutputFolder() {
    if (descriptor_ >= 0) close(descriptor_);
}

void OutputFolder::lock() {
    descriptor_ = open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        return;
    const long pid = holder_of(descriptor_);
    close(descriptor_);
    throw IoError{path_, "another run is writing into this folder" +
                             (pid ? fmt::format(" (PID {})", pid) : std::string{})};
}

}  // namespace sim
