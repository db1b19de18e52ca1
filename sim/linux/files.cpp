#include "sim/linux/files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstring>
#include <deque>
#include <stdexcept>

#include "sim/linux/arm_abi.h"
#include "sim/linux/open_file.h"

namespace sim {

namespace {

constexpr int MOST_FILES = 1024;     // of the program
constexpr unsigned MOST_LINKS = 40;  // on the way of a path, as in Linux

std::deque<std::string> components(const std::string& path) {
    std::deque<std::string> names;
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        if (end > begin) names.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

// What lies in the cross compiler's folder of libraries, "libc.so.6"; no value for other paths.
std::optional<std::string> library(const std::string& path) {
    for (const char* folder :
         {"/usr/lib/arm-linux-gnueabihf/", "/lib/arm-linux-gnueabihf/", "/usr/lib/", "/lib/"})
        if (path.rfind(folder, 0) == 0) return path.substr(std::strlen(folder));
    return std::nullopt;
}

std::optional<std::string> link_target(int folder, const char* name) {
    char text[PATH_MAX];
    const ssize_t bytes = ::readlinkat(folder, name, text, sizeof text);
    if (bytes < 0) return std::nullopt;
    return std::string{text, static_cast<std::size_t>(bytes)};
}

bool only_reads(std::uint32_t flags) {
    return !(flags & (arm_open::ACCESS | arm_open::CREAT | arm_open::TRUNC));
}

int host_flags(std::uint32_t flags) {
    int host = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY;  // opening a FIFO must not block
    host |= static_cast<int>(flags & arm_open::ACCESS);
    if (flags & arm_open::CREAT) host |= O_CREAT;
    if (flags & arm_open::EXCL) host |= O_EXCL;
    if (flags & arm_open::TRUNC) host |= O_TRUNC;
    if (flags & arm_open::APPEND) host |= O_APPEND;
    if (flags & arm_open::DIRECTORY) host |= O_DIRECTORY;
    return host;
}

}  // namespace

LinuxFiles::LinuxFiles(const std::filesystem::path& root,
                       const std::vector<std::filesystem::path>& libraries,
                       const std::filesystem::path& input, Console console, System system)
    : console_{std::move(console)}, system_{std::move(system)} {
    for (const std::filesystem::path& path : libraries)
        if (const int folder = ::open(path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC); folder >= 0)
            libraries_.push_back(std::make_shared<Handle>(folder));
    if (!root.empty()) {
        root_ = std::make_shared<Handle>(::open(root.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
        if (root_->fd() < 0)
            throw std::runtime_error{
                root.string() + ": cannot open as the program's root: " + std::strerror(errno)};
    }
    auto in = std::make_shared<File>(
        File{File::Kind::CONSOLE, arm_open::RDONLY, nullptr, nullptr, SERIAL_CONSOLE});
    if (!input.empty()) {
        in->path = "";
        in->is_outside = true;
    }
    if (input == "/dev/null") {
        in->kind = File::Kind::HOST;
        in->host = std::make_shared<Handle>(memfd_create("empty", MFD_CLOEXEC));
    } else if (!input.empty()) {
        in->kind = File::Kind::HOST;
        in->host = std::make_shared<Handle>(
            ::open(input.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
        const int error = in->host->fd() < 0 ? errno : 0;
        if (error || !std::filesystem::is_regular_file(input))
            throw std::runtime_error{input.string() + ": cannot be standard input: " +
                                     (error ? std::strerror(error)
                                      : std::filesystem::is_directory(input)
                                          ? "is a folder"
                                          : "is a pipe or a device, expected a file")};
    }
    add(std::move(in), 0, false);
    const auto out = std::make_shared<File>(
        File{File::Kind::CONSOLE, arm_open::WRONLY, nullptr, nullptr, SERIAL_CONSOLE});
    add(out, 1, false);
    add(out, 2, false);
}

// ---- Names --------------------------------------------------------------------------------------

int LinuxFiles::walk(const Place& root, const std::string& path, Place& place, Last last) {
    if (path.empty() || !root.folder) return -ENOENT;
    std::deque<std::string> names = components(path);
    std::vector<Place> folders{root};  // from the root to where the way has come
    unsigned links = 0;
    place = root;
    while (!names.empty()) {
        const std::string name = std::move(names.front());
        names.pop_front();
        const bool is_last = names.empty();
        if (name == ".") continue;
        if (name == "..") {
            if (folders.size() > 1) folders.pop_back();
            place = folders.back();
            continue;
        }
        const Place folder = folders.back();
        if (!is_last || last == Last::FOLLOW)
            if (const auto target = link_target(folder.folder->fd(), name.c_str())) {
                if (++links > MOST_LINKS) return -ELOOP;
                if (target->rfind('/', 0) == 0) folders.resize(1);
                const std::deque<std::string> instead = components(*target);
                names.insert(names.begin(), instead.begin(), instead.end());
                place = folders.back();
                continue;
            }
        const std::string there = (folder.path == "/" ? "" : folder.path) + "/" + name;
        place = {folder.folder, name, there};
        if (is_last) break;
        const int next =
            ::openat(folder.folder->fd(), name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC);
        if (next < 0) return -errno;
        place = {std::make_shared<Handle>(next), ".", there};
        struct stat status {};
        if (fstat(next, &status) != 0) return -errno;
        if (!S_ISDIR(status.st_mode)) return -ENOTDIR;
        folders.push_back(place);
    }
    return 0;
}

int LinuxFiles::place_of(const std::string& path, Place& place, Last last) const {
    return walk({root_, ".", "/"}, path, place, last);
}

int LinuxFiles::place_to_read(const std::string& path, Place& place, Last last) const {
    const auto is_there = [](const Place& at) {
        return ::faccessat(at.folder->fd(), at.name.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0;
    };
    const int error = place_of(path, place, last);
    const auto name = library(path);
    if ((!error && is_there(place)) || !name || (error && error != -ENOENT)) return error;
    for (const auto& libraries : libraries_) {
        Place among_libraries;
        if (walk({libraries, ".", "/lib"}, *name, among_libraries, last) != 0 ||
            !is_there(among_libraries))
            continue;
        place = among_libraries;
        place.is_outside = true;
        return 0;
    }
    return error;
}

int LinuxFiles::open(const std::string& path, std::uint32_t flags, std::uint32_t mode) {
    const bool close_on_exec = flags & arm_open::CLOEXEC;
    if (console_status(path))
        return add(std::make_shared<File>(File{File::Kind::CONSOLE, flags & ~arm_open::CLOEXEC,
                                               nullptr, nullptr, path}),
                   0, close_on_exec);
    if (path == MEMORY_PATH)
        return add(std::make_shared<File>(File{File::Kind::MEMORY, flags}), 0, close_on_exec);
    if (status_on_host(path).first == -ENOENT) {
        auto [error, device] = system_.open(path, flags);
        if (device)
            return add(std::make_shared<File>(
                           File{File::Kind::DEVICE, flags, nullptr, std::move(device), path}),
                       0, close_on_exec);
        if (error != -ENOENT) return error;
    }
    Place place;
    const bool creates = flags & arm_open::CREAT;
    const bool reads = only_reads(flags);
    const Last last = flags & arm_open::NOFOLLOW || (creates && flags & arm_open::EXCL)
                          ? Last::KEEP
                          : Last::FOLLOW;
    if (const int error = reads ? place_to_read(path, place, last) : place_of(path, place, last))
        return error;
    const int fd = open_on_host(place, flags, mode);
    if (fd < 0) return fd;
    auto file = std::make_shared<File>(
        File{File::Kind::HOST, flags, std::make_shared<Handle>(fd), nullptr, path});
    file->is_outside = place.is_outside;
    if (is_one_too_many(fd)) return -EMFILE;
    return add(std::move(file), 0, close_on_exec);
}

// What is neither file nor folder is never opened: the driver of a device, or who waits at the
// other end of a pipe, would notice.
int LinuxFiles::open_on_host(const Place& place, std::uint32_t flags, std::uint32_t mode) const {
    const Handle there{
        ::openat(place.folder->fd(), place.name.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC)};
    int fd = -1;
    if (there.fd() >= 0) {
        if (flags & arm_open::CREAT && flags & arm_open::EXCL) return -EEXIST;
        const auto [error, status] = host_status(there.fd());
        if (error) return error;
        if (flags & arm_open::CREAT && S_ISDIR(status.mode)) return -EISDIR;
        const std::string same = "/proc/self/fd/" + std::to_string(there.fd());
        fd = ::open(same.c_str(), host_flags(flags) & ~(O_CREAT | O_NOFOLLOW));
    } else if (errno == ENOENT && flags & arm_open::CREAT) {
        fd = ::openat(place.folder->fd(), place.name.c_str(), host_flags(flags) | O_EXCL,
                      static_cast<mode_t>(mode & 0777));
    }
    return fd < 0 ? -errno : fd;
}

int LinuxFiles::access(const std::string& path, int mode) const {
    const auto [error, status] = status_of(path);
    if (error) return error;
    const bool allowed = !(mode & X_OK) || (status.mode & 0111);
    return allowed ? 0 : -EACCES;
}

int LinuxFiles::remove(const std::string& path, bool folder) {
    if (status_on_host(path, true).first == -ENOENT && !folder && system_.status(path, true))
        return system_.remove(path);
    Place place;
    if (const int error = place_of(path, place, Last::KEEP)) return error;
    const int flags = folder ? AT_REMOVEDIR : 0;
    return static_cast<int>(or_error(unlinkat(place.folder->fd(), place.name.c_str(), flags)));
}

int LinuxFiles::set_rights(const std::string& path, std::uint32_t mode) {
    if (status_on_host(path).first == -ENOENT && system_.status(path, false)) return 0;
    Place place;
    if (const int error = place_of(path, place)) return error;
    return static_cast<int>(or_error(
        fchmodat(place.folder->fd(), place.name.c_str(), static_cast<mode_t>(mode & 0777), 0)));
}

int LinuxFiles::set_rights(int fd, std::uint32_t mode) {
    const File* const file = find(fd);
    if (!file) return -EBADF;
    if (file->kind != File::Kind::HOST) return 0;
    if (file->is_outside) return -EROFS;
    return static_cast<int>(or_error(::fchmod(file->host->fd(), static_cast<mode_t>(mode & 0777))));
}

int LinuxFiles::make_folder(const std::string& path, std::uint32_t mode) {
    Place place;
    if (const int error = place_of(path, place, Last::KEEP)) return error;
    return static_cast<int>(or_error(
        mkdirat(place.folder->fd(), place.name.c_str(), static_cast<mode_t>(mode & 0777))));
}

int LinuxFiles::rename(const std::string& from, const std::string& to) {
    Place source, target;
    if (const int error = place_of(from, source, Last::KEEP)) return error;
    if (const int error = place_of(to, target, Last::KEEP)) return error;
    return static_cast<int>(or_error(renameat(source.folder->fd(), source.name.c_str(),
                                              target.folder->fd(), target.name.c_str())));
}

// ---- Numbers ------------------------------------------------------------------------------------

int LinuxFiles::add(std::shared_ptr<File> file, int at_least, bool close_on_exec) {
    int fd = at_least;
    while (slots_.count(fd)) ++fd;
    if (fd >= MOST_FILES) return -EMFILE;
    slots_[fd] = {std::move(file), close_on_exec};
    return fd;
}

const LinuxFiles::File* LinuxFiles::find(int fd) const {
    const auto slot = slots_.find(fd);
    return slot == slots_.end() ? nullptr : slot->second.file.get();
}

int LinuxFiles::add(std::shared_ptr<LinuxDevice> device, std::uint32_t flags) {
    return add(std::make_shared<File>(File{File::Kind::DEVICE, flags & ~arm_open::CLOEXEC, nullptr,
                                           std::move(device)}),
               0, flags & arm_open::CLOEXEC);
}

LinuxDevice* LinuxFiles::device(int fd) const {
    const File* const file = find(fd);
    return file ? file->device.get() : nullptr;
}

std::shared_ptr<void> LinuxFiles::hold(int fd) const {
    const auto slot = slots_.find(fd);
    return slot == slots_.end() ? nullptr : slot->second.file;
}

void LinuxFiles::close_all(bool only_on_exec) {
    for (auto it = slots_.begin(); it != slots_.end();)
        it = !only_on_exec || it->second.close_on_exec ? slots_.erase(it) : std::next(it);
}

int LinuxFiles::open_to_load(const std::string& path) const {
    Place place;
    if (const int error = place_to_read(path, place)) return error;
    return open_on_host(place, arm_open::RDONLY, 0);
}

int LinuxFiles::close(int fd) { return slots_.erase(fd) ? 0 : -EBADF; }

int LinuxFiles::duplicate(int fd, int at_least) {
    if (!find(fd)) return -EBADF;
    if (at_least < 0 || at_least >= MOST_FILES) return -EINVAL;
    return add(slots_[fd].file, at_least, false);
}

int LinuxFiles::duplicate_onto(int fd, int other) {
    if (!find(fd) || other < 0 || other >= MOST_FILES) return -EBADF;
    if (fd != other) slots_[other] = {slots_[fd].file, false};
    return other;
}

int LinuxFiles::flags(int fd) const {
    const File* file = find(fd);
    return file ? static_cast<int>(file->flags &
                                   (arm_open::ACCESS | arm_open::APPEND | arm_open::NONBLOCK))
                : -EBADF;
}

void LinuxFiles::for_each_device(const std::function<void(LinuxDevice&)>& visit) const {
    for (const auto& [fd, slot] : slots_)
        if (slot.file->device) visit(*slot.file->device);
}

int LinuxFiles::set_flags(int fd, std::uint32_t flags) {
    if (!find(fd)) return -EBADF;
    std::uint32_t& kept = slots_[fd].file->flags;
    kept = (kept & ~arm_open::NONBLOCK) | (flags & arm_open::NONBLOCK);
    return 0;
}

int LinuxFiles::close_on_exec(int fd) const {
    const auto slot = slots_.find(fd);
    return slot == slots_.end() ? -EBADF : slot->second.close_on_exec;
}

int LinuxFiles::set_close_on_exec(int fd, bool on) {
    const auto slot = slots_.find(fd);
    if (slot == slots_.end()) return -EBADF;
    slot->second.close_on_exec = on;
    return 0;
}

std::vector<int> LinuxFiles::numbers() const {
    std::vector<int> all;
    for (const auto& [fd, slot] : slots_) all.push_back(fd);
    return all;
}

std::string LinuxFiles::target_of(int fd) const {
    const File* const file = find(fd);
    if (!file) return "";
    if (!file->path.empty()) return file->path;
    if (file->kind == File::Kind::MEMORY) return MEMORY_PATH;
    if (!file->device) return "/dev/null";
    const std::uint32_t mode = file->device->status().mode;
    return S_ISFIFO(mode) ? "pipe:[1]" : S_ISSOCK(mode) ? "socket:[1]" : "anon_inode:[file]";
}

int LinuxFiles::open_again(int fd, std::uint32_t flags) {
    const File* const file = find(fd);
    if (!file) return -ENOENT;
    if (file->is_outside && !only_reads(flags)) return -EROFS;
    auto again = std::make_shared<File>(*file);
    again->flags = flags;
    again->next_name = 0;
    if (file->kind == File::Kind::HOST) {
        const std::string same = "/proc/self/fd/" + std::to_string(file->host->fd());
        const int host = ::open(same.c_str(), host_flags(flags) & ~(O_CREAT | O_EXCL | O_NOFOLLOW));
        if (host < 0) return -errno;
        again->host = std::make_shared<Handle>(host);
        if (is_one_too_many(host)) return -EMFILE;
    }
    return add(std::move(again), 0, flags & arm_open::CLOEXEC);
}

bool LinuxFiles::is_console(int fd) const {
    const File* file = find(fd);
    return file && file->kind == File::Kind::CONSOLE;
}

std::pair<int, std::string> LinuxFiles::on_host(int fd) const {
    const File* const file = find(fd);
    if (!file || file->kind != File::Kind::HOST) return {-1, ""};
    return {file->host->fd(), file->path};
}

std::string LinuxFiles::path_of(int fd) const {
    const File* const file = find(fd);
    if (!file) return "";
    // The kernel's own folders know their place, without the links on the way.
    return file->device && file->device->entries() ? file->device->name() : file->path;
}

bool LinuxFiles::is_memory(int fd) const {
    const File* file = find(fd);
    return file && file->kind == File::Kind::MEMORY;
}

}  // namespace sim
