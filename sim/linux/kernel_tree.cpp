// kernel_tree.cpp - the folders and links of LinuxKernel's own files, and the calls on file systems
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/devices.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

void list_process(const LinuxProcess& process, OwnFiles& all) {
    const std::string folder = fmt::format("/proc/{}", process.number);
    for (const char* name : {"maps", "comm", "cmdline", "statm", "status", "stat"})
        all.add(folder + "/" + name);
    all.add_text(folder + "/mounts",
                 "/dev/root / ext4 rw 0 0\nproc /proc proc rw 0 0\nsysfs /sys sysfs rw 0 0\n"
                 "tmpfs /dev/shm tmpfs rw 0 0\n");
    for (const auto& thread : process.threads)
        for (const char* name : {"comm", "status", "stat"})
            all.add(fmt::format("{}/task/{}/{}", folder, thread->number, name));
    all.add_folder(folder + "/fd");
    for (const int fd : process.files.numbers())
        all.add_link(fmt::format("{}/fd/{}", folder, fd), process.files.target_of(fd));
}

}  // namespace

OwnFiles LinuxKernel::own_files() {
    OwnFiles all;
    for (const char* path : {"/dev/mem",
                             "/dev/null",
                             "/dev/zero",
                             "/dev/full",
                             "/dev/random",
                             "/dev/urandom",
                             "/proc/cpuinfo",
                             "/proc/iomem",
                             "/proc/version",
                             "/proc/uptime",
                             "/proc/loadavg",
                             "/proc/meminfo",
                             "/proc/stat",
                             "/proc/modules",
                             "/proc/interrupts",
                             "/sys/class/fpga_manager/fpga0/state",
                             "/sys/class/fpga_manager/fpga0/name",
                             "/sys/devices/system/cpu/online",
                             "/sys/devices/system/cpu/possible",
                             "/sys/devices/system/cpu/present"})
        all.add(path);
    if (outside_.i2c0) all.add("/dev/i2c-0");
    if (outside_.pixels) all.add("/dev/fb0");
    if (host_network_.exists()) all.add_text("/etc/hosts", host_network_.hosts());
    all.add_folder("/dev/shm");
    for (const auto& [name, memory] : shared_files_) all.add("/dev/shm/" + name);
    all.add_link("/proc/self", std::to_string(process_->number));
    if (running_)
        all.add_link("/proc/thread-self",
                     fmt::format("{}/task/{}", process_->number, running_->number));
    all.add_link("/dev/fd", "/proc/self/fd");
    all.add_link("/dev/stdin", "/proc/self/fd/0");
    all.add_link("/dev/stdout", "/proc/self/fd/1");
    all.add_link("/dev/stderr", "/proc/self/fd/2");
    for (const auto& process : processes_)
        if (process->memory && !process->threads.empty()) list_process(*process, all);
    all.add_link("/proc/mounts", "self/mounts");
    all.add_text("/proc/sys/kernel/pid_max", "32768\n");
    all.add_text("/proc/filesystems", "nodev\tproc\nnodev\tsysfs\nnodev\ttmpfs\n\text4\n");
    for (const auto& module : modules_)
        for (const auto& [id, file] : module->files)
            if (!file.path.empty()) all.add(file.path);
    for (const auto& [path, number] : nodes_) all.add(path);
    input_.list(all);
    usb_.list(all);
    gpio_.list(all);
    led_.list(all);
    return all;
}

std::pair<int, std::shared_ptr<LinuxDevice>> LinuxKernel::open_system(const std::string& path,
                                                                      std::uint32_t flags) {
    if (path.empty()) return {-ENOENT, nullptr};
    const OwnFiles all = own_files();
    if (const auto number = all.open_file(path, process_->number))
        return {files().open_again(*number, flags), nullptr};
    if (flags & arm_open::NOFOLLOW)
        if (const auto link = all.resolve(path, OwnFiles::Last::KEEP); link && all.target_of(*link))
            return flags & arm_open::PATH ? std::pair{0, all.open_link(*link)}
                                          : std::pair{-ELOOP, std::shared_ptr<LinuxDevice>{}};
    const auto way = all.resolve(path, OwnFiles::Last::FOLLOW);
    if (!way) return {-ELOOP, nullptr};
    if (all.is_folder(*way)) {
        if (flags & (arm_open::ACCESS | arm_open::CREAT)) return {-EISDIR, nullptr};
        return {0, all.open_folder(*way, [this](const std::string& inside) {
                    return system_status(inside, true);
                })};
    }
    if (const auto text = all.text_of(*way)) {
        if (flags & arm_open::ACCESS) return {-EACCES, nullptr};
        return {0, devices::text(*way, *text)};
    }
    auto opened = open_own(*way, flags);
    if (opened.second && (flags & arm_open::DIRECTORY)) return {-ENOTDIR, nullptr};
    return opened;
}

std::optional<FileStatus> LinuxKernel::system_status(const std::string& path, bool of_link) {
    if (path.empty()) return std::nullopt;
    const OwnFiles all = own_files();
    const auto number = all.open_file(path, process_->number);
    if (number && !of_link) return files().status_of(*number).second;
    const auto way = all.resolve(path, of_link ? OwnFiles::Last::KEEP : OwnFiles::Last::FOLLOW);
    if (!way) return std::nullopt;
    if (all.is_folder(*way)) return status_of_own_folder();
    if (all.target_of(*way)) return all.status_of_link(*way);
    if (all.text_of(*way)) return devices::status_of_text();
    return status_of_own(*way);
}

std::optional<std::string> LinuxKernel::system_target(const std::string& path) {
    const OwnFiles all = own_files();
    const auto way = all.resolve(path, OwnFiles::Last::KEEP);
    return way ? all.target_of(*way) : std::nullopt;
}

// ---- statfs -------------------------------------------------------------------------------------

// In the order of struct statfs and struct statfs64, which have some fields of 64 bits; on an empty
// disk.
std::int64_t LinuxKernel::give_file_system(const std::string& path, std::uint32_t to, bool wide) {
    constexpr std::uint32_t SYSFS = 0x62656572, PROC = 0x9FA0, TMPFS = 0x01021994, EXT4 = 0xEF53;
    constexpr std::uint32_t BLOCK = 4096, LONGEST_NAME = 255, BLOCKS = 1 << 20;
    const auto [error, status] = files().status_of(path);
    if (error) return error;
    const auto in = [&](const char* folder) {
        return path == folder || path.rfind(std::string{folder} + "/", 0) == 0;
    };
    const std::uint32_t kind = in("/sys") ? SYSFS : in("/proc") ? PROC : in("/dev") ? TMPFS : EXT4;
    const std::uint32_t blocks = kind == SYSFS || kind == PROC ? 0 : BLOCKS;
    std::vector<std::uint32_t> words{kind, BLOCK};
    for (const std::uint32_t count : {blocks, blocks, blocks, blocks, blocks}) {
        words.push_back(count);
        if (wide) words.push_back(0);
    }
    for (const std::uint32_t word : {0u, 0u, LONGEST_NAME, BLOCK, 0u, 0u, 0u, 0u, 0u})
        words.push_back(word);
    return memory().write(to, words.data(), 4 * words.size()) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_statfs(const Arguments& a) {
    const auto [error, path] = path_at(ARM_AT_FDCWD, a[0]);
    return error ? error : give_file_system(path, a[1], false);
}

LinuxKernel::Result LinuxKernel::sys_statfs64(const Arguments& a) {
    const auto [error, path] = path_at(ARM_AT_FDCWD, a[0]);
    return error ? error : give_file_system(path, a[2], true);
}

LinuxKernel::Result LinuxKernel::sys_fstatfs64(const Arguments& a) {
    const int fd = static_cast<int>(a[0]);
    if (files().flags(fd) < 0) return -EBADF;
    return give_file_system(files().path_of(fd), a[2], true);
}

// No file system here has handles for files, as overlayfs has none without nfs_export.
LinuxKernel::Result LinuxKernel::sys_name_to_handle_at(const Arguments& a) {
    const auto [error, path] = path_at(a[0], a[1]);
    if (error) return error;
    const bool by_number = path.empty() && (a[4] & ARM_AT_EMPTY_PATH);
    const int missing = by_number ? files().status_of(static_cast<int>(a[0])).first
                                  : files().status_of(path, true).first;
    return missing ? missing : -EOPNOTSUPP;
}

}  // namespace sim
