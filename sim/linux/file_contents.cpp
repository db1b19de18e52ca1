// file_contents.cpp - LinuxFiles' reading, writing and status
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <climits>
#include <cstring>

#include "sim/linux/arm_abi.h"
#include "sim/linux/open_file.h"

namespace sim {

// ---- Contents -----------------------------------------------------------------------------------

std::int64_t LinuxFiles::read(int fd, void* data, std::size_t bytes) {
    const File* file = find(fd);
    if (!file || (file->flags & arm_open::ACCESS) == arm_open::WRONLY) return -EBADF;
    switch (file->kind) {
        case File::Kind::HOST: return or_error(::read(file->host->fd(), data, bytes));
        case File::Kind::MEMORY: return -EFAULT;
        case File::Kind::DEVICE: return file->device->read(data, bytes);
        default: return console_.read(static_cast<char*>(data), bytes);
    }
}

std::int64_t LinuxFiles::write(int fd, const void* data, std::size_t bytes) {
    const File* file = find(fd);
    if (!file || (file->flags & arm_open::ACCESS) == arm_open::RDONLY) return -EBADF;
    if (file->kind == File::Kind::HOST) return or_error(::write(file->host->fd(), data, bytes));
    if (file->kind == File::Kind::MEMORY) return -EFAULT;
    if (file->kind == File::Kind::DEVICE) return file->device->write(data, bytes);
    const char* text = static_cast<const char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) console_.print(text[i]);
    return static_cast<std::int64_t>(bytes);
}

std::int64_t LinuxFiles::read_at(int fd, void* data, std::size_t bytes, std::int64_t offset) {
    const File* file = find(fd);
    if (!file) return -EBADF;
    if (file->device) return file->device->read_at(data, bytes, offset);
    if (file->kind != File::Kind::HOST) return -ESPIPE;
    return or_error(::pread(file->host->fd(), data, bytes, offset));
}

std::int64_t LinuxFiles::write_at(int fd, const void* data, std::size_t bytes,
                                  std::int64_t offset) {
    const File* file = find(fd);
    if (!file) return -EBADF;
    if (file->device) return file->device->write_at(data, bytes, offset);
    if (file->kind != File::Kind::HOST) return -ESPIPE;
    return or_error(::pwrite(file->host->fd(), data, bytes, offset));
}

std::int64_t LinuxFiles::seek(int fd, std::int64_t offset, int whence) {
    const File* file = find(fd);
    if (!file) return -EBADF;
    if (file->device && !file->device->entries()) return file->device->seek(offset, whence);
    if (file->kind != File::Kind::HOST && !file->device) return -ESPIPE;
    if (file->device || !file->names.empty()) {  // a folder: telldir(), seekdir(), rewinddir()
        if (whence == SEEK_SET) slots_[fd].file->next_name = static_cast<std::size_t>(offset);
        return static_cast<std::int64_t>(file->next_name);
    }
    return or_error(::lseek(file->host->fd(), offset, whence));
}

std::int64_t LinuxFiles::read_folder(int fd, std::uint8_t* data, std::size_t bytes) {
    if (!find(fd)) return -EBADF;
    File& file = *slots_[fd].file;
    const LinuxDevice::Entries* const own = file.device ? file.device->entries() : nullptr;
    if (file.kind != File::Kind::HOST && !own) return -ENOTDIR;
    if (file.next_name == 0 && own) {
        file.names.clear();
        for (const auto& [name, mode] : *own) file.names.push_back(name);
    } else if (file.next_name == 0) {
        DIR* const folder = fdopendir(::openat(file.host->fd(), ".", O_RDONLY | O_CLOEXEC));
        if (!folder) return -errno;
        file.names.clear();
        while (const dirent* const entry = ::readdir(folder))
            file.names.emplace_back(entry->d_name);
        closedir(folder);
        std::sort(file.names.begin(), file.names.end());
    }
    struct Entry {  // include/linux/dirent.h; the name follows
        std::uint64_t number, next;
        std::uint16_t size;
        std::uint8_t type;
    };
    constexpr std::size_t NAME = 19;
    std::size_t used = 0;
    for (; file.next_name < file.names.size(); ++file.next_name) {
        const std::string& name = file.names[file.next_name];
        const std::size_t size = (NAME + name.size() + 1 + 7) & ~std::size_t{7};
        if (used + size > bytes) return used == 0 ? -EINVAL : static_cast<std::int64_t>(used);
        FileStatus status{own ? own->at(name) : 0, 0, 1, 0};
        if (!own) {
            const Handle there{
                ::openat(file.host->fd(), name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC)};
            status = host_status(there.fd()).second;
        }
        std::memset(data + used, 0, size);
        const Entry entry{status.number, file.next_name + 1, static_cast<std::uint16_t>(size),
                          static_cast<std::uint8_t>(status.mode >> 12)};  // 0: unknown
        std::memcpy(data + used, &entry, NAME);
        std::memcpy(data + used + NAME, name.data(), name.size());
        used += size;
    }
    return static_cast<std::int64_t>(used);
}

int LinuxFiles::truncate(int fd, std::int64_t bytes) {
    const File* file = find(fd);
    if (!file) return -EBADF;
    if (file->device) return file->device->truncate(bytes);
    if (file->kind != File::Kind::HOST) return -EINVAL;
    return static_cast<int>(or_error(::ftruncate(file->host->fd(), bytes)));
}

unsigned LinuxFiles::can_do(int fd) const {
    const File* file = find(fd);
    if (!file) return 0;
    if (file->device) return file->device->can_do();
    return file->kind == File::Kind::CONSOLE && !console_.readable() ? WRITE : READ | WRITE;
}

std::string LinuxFiles::name(int fd) const {
    const File* file = find(fd);
    if (file && file->device) return file->device->name();
    return is_console(fd) ? "standard input" : "a file";
}

bool LinuxFiles::is_inside(int fd) const {
    const File* file = find(fd);
    return file && file->device && file->device->is_inside();
}

// ---- Status -------------------------------------------------------------------------------------

std::pair<int, FileStatus> LinuxFiles::host_status(int host) const {
    struct stat status {};
    if (fstat(host, &status) != 0) return {-errno, {}};
    const bool folder = S_ISDIR(status.st_mode);
    if (!folder && !S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) return {-EACCES, {}};
    const auto number =
        numbers_->emplace(std::pair{status.st_dev, status.st_ino}, numbers_->size() + 2);
    return {0,
            {status.st_mode & (S_IFMT | 0777),
             folder ? 4096 : static_cast<std::uint64_t>(status.st_size), number.first->second, 0}};
}

std::pair<int, FileStatus> LinuxFiles::status_of(int fd) const {
    const File* file = find(fd);
    if (!file) return {-EBADF, {}};
    switch (file->kind) {
        case File::Kind::HOST: return host_status(file->host->fd());
        case File::Kind::MEMORY: return {0, {S_IFCHR | 0640, 0, 1, 1 << 8 | 1}};
        case File::Kind::DEVICE: return {0, file->device->status()};
        default: return {0, *console_status(file->path)};
    }
}

std::pair<int, FileStatus> LinuxFiles::status_of(const std::string& path, bool of_link) const {
    if (path == MEMORY_PATH) return {0, {S_IFCHR | 0640, 0, 1, 1 << 8 | 1}};
    if (const auto console = console_status(path)) return {0, *console};
    const auto found = status_on_host(path, of_link);
    if (found.first != -ENOENT) return found;
    const auto status = system_.status(path, of_link);
    return status ? std::pair{0, *status} : found;
}

std::pair<int, FileStatus> LinuxFiles::status_on_host(const std::string& path, bool of_link) const {
    Place place;
    if (const int error = place_to_read(path, place, of_link ? Last::KEEP : Last::FOLLOW))
        return {error, {}};
    const Handle file{
        ::openat(place.folder->fd(), place.name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC)};
    if (file.fd() < 0) return {-errno, {}};
    return host_status(file.fd());
}

std::pair<int, std::string> LinuxFiles::folder_at(const std::string& path) const {
    const auto [error, status] = status_on_host(path);
    if (error == -ENOENT && path[0] == '/')
        if (const auto own = system_.status(path, false))
            return S_ISDIR(own->mode) ? std::pair{0, path} : std::pair{-ENOTDIR, std::string{}};
    if (error) return {error, ""};
    if (!S_ISDIR(status.mode)) return {-ENOTDIR, ""};
    Place place;
    place_to_read(path, place);
    return {0, place.path};
}

std::pair<int, std::string> LinuxFiles::target_of(const std::string& path) const {
    Place place;
    const int error = place_to_read(path, place, Last::KEEP);
    if (error == -ENOENT || (!error && status_on_host(path, true).first == -ENOENT))
        if (const auto target = system_.target(path)) return {0, *target};
    if (error) return {error, ""};
    char text[PATH_MAX];
    const ssize_t bytes = ::readlinkat(place.folder->fd(), place.name.c_str(), text, sizeof text);
    if (bytes < 0) return {-errno, ""};
    return {0, {text, static_cast<std::size_t>(bytes)}};
}

}  // namespace sim
