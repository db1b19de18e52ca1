// files.h - a Linux process's open files: the console, /dev/mem, under a folder, the kernel's own.
//
//   0 stdin    the console, or a file       /dev/mem    for mmap; see address_space.h
//   1, 2       the console                  PATH        ROOT/PATH on the host
//   /dev/tty, /dev/console, /dev/ttyS0      the console
//
// A path is relative to the root, and symbolic links are followed within it, as after chroot: ".."
// of the root is the root.  Anything that is neither file nor folder is refused (EACCES).  What the
// root does not have of /lib and /usr/lib is read among the cross compiler's libraries.  What is
// not there may be the kernel's own (device.h).  A file's status does not depend on the host: owner
// 0, times 0, inodes numbered in the order of first use.  Some of the host's files stay free for
// the run's own (EMFILE).
//
// Results are like the kernel's: a number of at least 0, or minus the error.  Flags, modes
// and errors are Linux's for ARM.
//
// A copy is that of a process that forks: it has the same open files.
//
// Not handled: making links, locks, reading /dev/mem by read(); the kernel's own files in the list
// of a folder that the root has, too; numbers of pipes and sockets, which all have 1.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/file_status.h"

namespace sim {

class LinuxFiles {
public:
    struct Console {
        std::function<void(char)> print;
        std::function<std::int64_t(char* to, std::size_t bytes)> read;  // or EAGAIN
        std::function<bool()> readable;
    };
    // Of the kernel's own by this path: open, or none with the error or the number of a file that
    // it is already; what stat() says of it, or lstat() of a link; and where that leads.
    struct System {
        std::function<std::pair<int, std::shared_ptr<LinuxDevice>>(const std::string& path,
                                                                   std::uint32_t flags)>
            open;
        std::function<std::optional<FileStatus>(const std::string& path, bool of_link)> status;
        std::function<int(const std::string& path)> remove;
        std::function<std::optional<std::string>(const std::string& path)> target;
    };
    // `root` and `input`, which is standard input instead of the console, may be empty;
    // `libraries` may not exist.  std::runtime_error if the root or the input cannot be opened.
    LinuxFiles(const std::filesystem::path& root,
               const std::vector<std::filesystem::path>& libraries,
               const std::filesystem::path& input, Console console, System system);

    // The lowest free number, or EMFILE.
    int add(std::shared_ptr<LinuxDevice> device, std::uint32_t flags);
    LinuxDevice* device(int fd) const;  // nullptr: it is another kind of file
    void for_each_device(const std::function<void(LinuxDevice&)>& visit) const;
    std::shared_ptr<void> hold(int fd) const;  // as long as this lives it stays open
    void close_all(bool only_on_exec);
    // For reading, on the host; the error, or the host's number.
    int open_to_load(const std::string& path) const;
    int open(const std::string& path, std::uint32_t flags, std::uint32_t mode);
    int close(int fd);
    int duplicate(int fd, int at_least);         // the lowest free number from there on
    int duplicate_onto(int fd, int other);       // closes that first
    int flags(int fd) const;                     // of open(), without those for open() alone
    int set_flags(int fd, std::uint32_t flags);  // O_NONBLOCK, which the caller has to obey
    int set_close_on_exec(int fd, bool on);
    int close_on_exec(int fd) const;

    // EAGAIN where it would have to wait, whatever set_flags() says.
    std::int64_t read(int fd, void* data, std::size_t bytes);
    std::int64_t write(int fd, const void* data, std::size_t bytes);
    std::int64_t read_at(int fd, void* data, std::size_t bytes, std::int64_t offset);
    std::int64_t write_at(int fd, const void* data, std::size_t bytes, std::int64_t offset);
    std::int64_t seek(int fd, std::int64_t offset, int whence);
    int truncate(int fd, std::int64_t bytes);
    // As getdents64: entries in the order of their names.  `data` is aligned to 8.
    std::int64_t read_folder(int fd, std::uint8_t* data, std::size_t bytes);
    // Of these, what would not have to wait.
    static constexpr unsigned READ = LinuxDevice::READ, WRITE = LinuxDevice::WRITE,
                              HUNG_UP = LinuxDevice::HUNG_UP, BROKEN = LinuxDevice::BROKEN,
                              UNKNOWN = LinuxDevice::UNKNOWN, PRIORITY = LinuxDevice::PRIORITY;
    unsigned can_do(int fd) const;
    std::string name(int fd) const;  // in a message about who waits for it
    bool is_inside(int fd) const;    // as LinuxDevice's
    int sync(int fd) const { return status_of(fd).first; }

    std::pair<int, FileStatus> status_of(int fd) const;
    std::pair<int, FileStatus> status_of(const std::string& path, bool of_link = false) const;
    // Of a symbolic link; EINVAL if it is none.
    std::pair<int, std::string> target_of(const std::string& path) const;
    int access(const std::string& path, int mode) const;
    int remove(const std::string& path, bool folder);
    int make_folder(const std::string& path, std::uint32_t mode);
    int rename(const std::string& from, const std::string& to);
    // As chmod(); what is not on the host has no rights that count.
    int set_rights(const std::string& path, std::uint32_t mode);
    int set_rights(int fd, std::uint32_t mode);

    bool is_console(int fd) const;
    bool is_memory(int fd) const;
    // Of a file under the root or among the libraries: the host's number, and the path by which it
    // was opened; or -1.
    std::pair<int, std::string> on_host(int fd) const;
    std::vector<int> numbers() const;     // of open files
    std::string target_of(int fd) const;  // of the link /proc/PID/fd/NUMBER
    // Another open file of the same; devices and the console have their state in common.
    int open_again(int fd, std::uint32_t flags);
    std::string path_of(int fd) const;  // by which a file or folder was opened
    // The path of a folder without links; or the error.
    std::pair<int, std::string> folder_at(const std::string& path) const;

private:
    class Handle;  // of the host
    struct File;
    struct Place;  // a folder that is open, a name in it, and the path of that without links

    int add(std::shared_ptr<File> file, int at_least, bool close_on_exec);
    const File* find(int fd) const;
    enum class Last { FOLLOW, KEEP };  // a symbolic link at the path's end
    // Where a path leads to; KEEP: where it is itself.
    int place_of(const std::string& path, Place& place, Last last = Last::FOLLOW) const;
    // Of what is read, also among the libraries.
    int place_to_read(const std::string& path, Place& place, Last last = Last::FOLLOW) const;
    static int walk(const Place& root, const std::string& path, Place& place, Last last);
    int open_on_host(const Place& place, std::uint32_t flags, std::uint32_t mode) const;
    std::pair<int, FileStatus> host_status(int host) const;
    std::pair<int, FileStatus> status_on_host(const std::string& path, bool of_link = false) const;

    struct Slot {
        std::shared_ptr<File> file;
        bool close_on_exec = false;
    };

    std::shared_ptr<Handle> root_;  // may be none
    std::vector<std::shared_ptr<Handle>> libraries_;
    Console console_;
    System system_;
    std::map<int, Slot> slots_;
    using Numbers = std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t>;
    std::shared_ptr<Numbers> numbers_ = std::make_shared<Numbers>();  // of files
};

}  // namespace sim
