// kernel_names.cpp - LinuxKernel's calls on paths, and on the status of files
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

// -1, of 32 bits or 16, leaves the owner unchanged.
bool is_root(std::uint32_t id) { return id == 0 || id == ~0u || id == 0xFFFF; }

constexpr std::uint32_t BLOCK = 4096, SECTOR = 512;

struct Stat64 {  // arch/arm/include/uapi/asm/stat.h
    std::uint64_t device;
    std::uint32_t pad0, short_number, mode, links, user, group;
    std::uint64_t this_device;
    std::uint32_t pad1[2];
    std::uint64_t size;
    std::uint32_t block, pad2;
    std::uint64_t sectors;
    std::uint32_t times[6];
    std::uint64_t number;
};
static_assert(sizeof(Stat64) == 104);

struct Statx {  // include/uapi/linux/stat.h
    std::uint32_t mask, block;
    std::uint64_t attributes;
    std::uint32_t links, user, group;
    std::uint16_t mode, pad0;
    std::uint64_t number, size, sectors, attributes_mask;
    std::uint64_t times[8];
    std::uint32_t this_device[2], device[2];
    std::uint64_t rest[14];
};
static_assert(sizeof(Statx) == 256);

constexpr std::uint32_t BASIC_STATS = 0x7FF;

}  // namespace

// Relative paths begin at the folder of that number, or at the working directory.
std::pair<std::int64_t, std::string> LinuxKernel::path_at(std::uint32_t folder,
                                                          std::uint32_t address) const {
    const auto text = memory().string(address);
    if (!text) return {-EFAULT, ""};
    if (text->empty() || (*text)[0] == '/') return {0, *text};
    std::string base = process_->folder;
    if (folder != ARM_AT_FDCWD) {
        const auto [error, status] = files().status_of(static_cast<int>(folder));
        if (error) return {error, ""};
        if (!S_ISDIR(status.mode)) return {-ENOTDIR, ""};
        base = files().path_of(static_cast<int>(folder));
    }
    return {0, (base == "/" ? "" : base) + "/" + *text};
}

std::int64_t LinuxKernel::give_status(const std::pair<int, FileStatus>& status, std::uint32_t to) {
    const auto& [error, file] = status;
    if (error) return error;
    Stat64 stat{};
    stat.device = 1;
    stat.short_number = static_cast<std::uint32_t>(file.number);
    stat.number = file.number;
    stat.mode = file.mode;
    stat.links = 1;
    stat.this_device = file.device;
    stat.size = file.size;
    stat.block = BLOCK;
    stat.sectors = (file.size + SECTOR - 1) / SECTOR;
    return memory().write(to, &stat, sizeof stat) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_fstat64(const Arguments& a) {
    return give_status(files().status_of(static_cast<int>(a[0])), a[1]);
}

LinuxKernel::Result LinuxKernel::sys_stat64(const Arguments& a) {
    const auto [error, path] = path_at(ARM_AT_FDCWD, a[0]);
    return error ? error : give_status(files().status_of(path), a[1]);
}

LinuxKernel::Result LinuxKernel::sys_lstat64(const Arguments& a) {
    const auto [error, path] = path_at(ARM_AT_FDCWD, a[0]);
    return error ? error : give_status(files().status_of(path, true), a[1]);
}

LinuxKernel::Result LinuxKernel::sys_fstatat64(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    if (path.empty() && (a[3] & ARM_AT_EMPTY_PATH)) return sys_fstat64({a[0], a[2]});
    const bool of_link = a[3] & ARM_AT_SYMLINK_NOFOLLOW;
    return error ? error : give_status(files().status_of(path, of_link), a[2]);
}

LinuxKernel::Result LinuxKernel::sys_statx(const Arguments& a) {
    const auto text = memory().string(a[1]);
    const bool by_number = text && text->empty() && (a[2] & ARM_AT_EMPTY_PATH);
    const auto [error, path] =
        by_number ? std::pair<std::int64_t, std::string>{} : path_at(a[0], a[1]);
    if (error) return error;
    const auto [failed, file] = by_number ? files().status_of(static_cast<int>(a[0]))
                                          : files().status_of(path, a[2] & ARM_AT_SYMLINK_NOFOLLOW);
    if (failed) return failed;
    Statx stat{};
    stat.mask = BASIC_STATS;
    stat.block = BLOCK;
    stat.links = 1;
    stat.mode = static_cast<std::uint16_t>(file.mode);
    stat.number = file.number;
    stat.size = file.size;
    stat.sectors = (file.size + SECTOR - 1) / SECTOR;
    stat.this_device[0] = static_cast<std::uint32_t>(file.device >> 8);
    stat.this_device[1] = static_cast<std::uint32_t>(file.device & 0xFF);
    stat.device[1] = 1;
    return memory().write(a[4], &stat, sizeof stat) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_access(const Arguments& a) {
    return sys_faccessat({ARM_AT_FDCWD, a[0], a[1]});
}

LinuxKernel::Result LinuxKernel::sys_faccessat(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    return error ? error : files().access(path, static_cast<int>(a[2]));
}

LinuxKernel::Result LinuxKernel::sys_chmod(const Arguments& a) {
    return sys_fchmodat({ARM_AT_FDCWD, a[0], a[1]});
}
LinuxKernel::Result LinuxKernel::sys_fchmodat(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    return error ? error : files().set_rights(path, a[2]);
}
LinuxKernel::Result LinuxKernel::sys_fchmod(const Arguments& a) {
    return files().set_rights(static_cast<int>(a[0]), a[1]);
}

// All files are root's, and so is the program.
LinuxKernel::Result LinuxKernel::sys_fchownat(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    if (error) return error;
    if (const int missing = files().status_of(path, true).first) return missing;
    return is_root(a[2]) && is_root(a[3]) ? 0 : -EPERM;
}
LinuxKernel::Result LinuxKernel::sys_chown(const Arguments& a) {
    return sys_fchownat({ARM_AT_FDCWD, a[0], a[1], a[2]});
}
LinuxKernel::Result LinuxKernel::sys_fchown(const Arguments& a) {
    if (const int missing = files().status_of(static_cast<int>(a[0])).first) return missing;
    return is_root(a[1]) && is_root(a[2]) ? 0 : -EPERM;
}

LinuxKernel::Result LinuxKernel::sys_unlink(const Arguments& a) {
    return sys_unlinkat({ARM_AT_FDCWD, a[0], 0});
}

LinuxKernel::Result LinuxKernel::sys_rmdir(const Arguments& a) {
    return sys_unlinkat({ARM_AT_FDCWD, a[0], ARM_AT_REMOVEDIR});
}

LinuxKernel::Result LinuxKernel::sys_unlinkat(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    return error ? error : files().remove(path, a[2] & ARM_AT_REMOVEDIR);
}

LinuxKernel::Result LinuxKernel::sys_mkdir(const Arguments& a) {
    return sys_mkdirat({ARM_AT_FDCWD, a[0], a[1]});
}

LinuxKernel::Result LinuxKernel::sys_mkdirat(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    return error ? error : files().make_folder(path, a[2] & ~process_->umask);
}

LinuxKernel::Result LinuxKernel::sys_rename(const Arguments& a) {
    return sys_renameat({ARM_AT_FDCWD, a[0], ARM_AT_FDCWD, a[1]});
}

LinuxKernel::Result LinuxKernel::sys_renameat(const Arguments& a) {
    const auto [from_error, from] = path_at(a[0], a[1]);
    const auto [to_error, to] = path_at(a[2], a[3]);
    if (from_error || to_error) return from_error ? from_error : to_error;
    return files().rename(from, to);
}

// The kernel's own link is /proc/self/exe, to the program itself.
std::int64_t LinuxKernel::give_link(const std::string& path, std::uint32_t to, std::uint32_t size) {
    auto [error, target] = files().target_of(path);
    if (path == "/proc/self/exe") {
        error = 0;
        target = sim::path_of(cpu_.program().elf);
    }
    if (error) return error == -ENOENT && system_status(path, true) ? -EINVAL : error;
    const std::size_t count = std::min<std::size_t>(size, target.size());
    return memory().write(to, target.data(), count) ? static_cast<std::int64_t>(count) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_readlink(const Arguments& a) {
    return sys_readlinkat({ARM_AT_FDCWD, a[0], a[1], a[2]});
}

LinuxKernel::Result LinuxKernel::sys_readlinkat(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    return error ? error : give_link(path, a[2], a[3]);
}

LinuxKernel::Result LinuxKernel::sys_getcwd(const Arguments& a) {
    const std::string& folder = process_->folder;
    const std::size_t bytes = folder.size() + 1;
    if (a[1] < bytes) return -ERANGE;
    return memory().write(a[0], folder.c_str(), bytes) ? static_cast<std::int64_t>(bytes) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_chdir(const Arguments& a) {
    const auto [error, path] = path_at(ARM_AT_FDCWD, a[0]);
    return error ? error : change_folder(path);
}

LinuxKernel::Result LinuxKernel::sys_fchdir(const Arguments& a) {
    const int fd = static_cast<int>(a[0]);
    const auto [error, status] = files().status_of(fd);
    if (error) return error;
    return S_ISDIR(status.mode) ? change_folder(files().path_of(fd)) : -ENOTDIR;
}

std::int64_t LinuxKernel::change_folder(const std::string& path) {
    if (path == "/" || path == ".") {  // which is there without a root, too
        if (path == "/") process_->folder = path;
        return 0;
    }
    const auto [error, folder] = files().folder_at(path);
    if (error == 0) process_->folder = folder;
    return error;
}

LinuxKernel::Result LinuxKernel::sys_umask(const Arguments& a) {
    const std::uint32_t was = process_->umask;
    process_->umask = a[0] & 0777;
    return was;
}

// ---- Device nodes, of modules -------------------------------------------------------------------

std::optional<ModuleNode> LinuxKernel::module_node(const std::string& path) const {
    const auto made = nodes_.find(path);
    for (const auto& module : modules_)
        for (const auto& [id, file] : module->files)
            if (made == nodes_.end() ? file.path == path : file.number == made->second)
                return ModuleNode{module.get(), made == nodes_.end() ? id : ~0u, file.mode,
                                  file.number};
    if (made == nodes_.end()) return std::nullopt;
    const std::uint32_t major = made->second >> 20;  // of another minor number
    for (const auto& module : modules_)
        for (const auto& [id, file] : module->files)
            if (file.number >> 20 == major)
                return ModuleNode{module.get(), ~0u, file.mode, made->second};
    return std::nullopt;
}

std::optional<FileStatus> LinuxKernel::module_status(const std::string& path) const {
    const auto node = module_node(path);
    if (!node) return std::nullopt;
    return status_of(*node);
}

// The number of a device as Linux' user interface has it.
FileStatus LinuxKernel::status_of(const ModuleNode& node) {
    const std::uint32_t major = node.number >> 20, minor = node.number & 0xFFFFF;
    return FileStatus{node.mode, 0, 1, (minor & 0xFF) | major << 8 | (minor & ~0xFFu) << 12};
}

LinuxKernel::Result LinuxKernel::sys_mknod(const Arguments& a) {
    return mknod(ARM_AT_FDCWD, a[0], a[1], a[2]);
}
LinuxKernel::Result LinuxKernel::sys_mknodat(const Arguments& a) {
    return mknod(a[0], a[1], a[2], a[3]);
}
// Numbers of Linux' user interface: 8 bits of the minor one, the major one above.
std::int64_t LinuxKernel::mknod(std::uint32_t folder, std::uint32_t path, std::uint32_t mode,
                                std::uint32_t number) {
    constexpr std::uint32_t TYPE = 0170000, CHARACTER = 020000;
    const auto [error, text] = path_at(folder, path);
    if (error) return error;
    if ((mode & TYPE) != CHARACTER) {
        not_emulated("mknod of what is no character device");
        return -ENOSYS;
    }
    const std::uint32_t major = number >> 8 & 0xFFF,
                        minor = (number & 0xFF) | (number >> 12 & 0xFFF00);
    if (nodes_.count(text) || files().status_of(text).first == 0) return -EEXIST;
    nodes_[text] = major << 20 | minor;
    return 0;
}

}  // namespace sim
