// kernel_files.cpp - LinuxKernel's calls on open files
#include <algorithm>
#include <cerrno>
#include <cmath>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t MOST_BYTES = 0x7FFFF000;  // of one transfer, as the kernel has it
constexpr std::uint32_t TCGETS = 0x5401, TCSETS = 0x5402, TCSETSF = 0x5404, TIOCGWINSZ = 0x5413,
                        FIONREAD = 0x541B;

// What is there on each Linux without a program's doing.
bool is_of_the_system(const std::string& path) {
    const auto in = [&](const char* folder) { return path.rfind(folder, 0) == 0; };
    return in("/dev/") || in("/proc/") || in("/sys/");
}

int fd_of(std::uint32_t value) { return static_cast<int>(value); }

std::int64_t pair_of(std::uint32_t low, std::uint32_t high) {
    return static_cast<std::int64_t>(std::uint64_t{high} << 32 | low);
}

}  // namespace

std::int64_t LinuxKernel::open(std::uint32_t folder, std::uint32_t path, std::uint32_t flags,
                               std::uint32_t mode) {
    const auto [error, text] = path_at(folder, path);
    if (error) return error;
    const int fd = files_.open(text, flags, mode & ~umask_);
    if (fd == -ENOENT && is_of_the_system(text) && named_files_.insert(text).second)
        outside_.log(
            fmt::format("{} is not there: of the system's files the simulated Linux has "
                        "/dev/mem, and what --linux-root brings, {}",
                        text, cpu_.where()));
    return fd;
}

LinuxKernel::Result LinuxKernel::sys_open(const Arguments& a) {
    return open(ARM_AT_FDCWD, a[0], a[1], a[2]);
}

LinuxKernel::Result LinuxKernel::sys_openat(const Arguments& a) {
    return open(a[0], a[1], a[2], a[3]);
}

LinuxKernel::Result LinuxKernel::sys_creat(const Arguments& a) {
    return open(ARM_AT_FDCWD, a[0], arm_open::CREAT | arm_open::WRONLY | arm_open::TRUNC, a[1]);
}

LinuxKernel::Result LinuxKernel::sys_close(const Arguments& a) { return files_.close(fd_of(a[0])); }

LinuxKernel::Result LinuxKernel::sys_read(const Arguments& a) {
    const std::uint32_t count = std::min(a[2], MOST_BYTES);
    std::uint8_t* to = memory_.bytes(a[1], count, arm_access::WRITE);
    if (!to) return -EFAULT;
    const int fd = fd_of(a[0]), flags = files_.flags(fd);
    if (flags >= 0 && (flags & arm_open::NONBLOCK) && !is_readable(fd)) return -EAGAIN;
    return files_.read(fd, to, count);
}

LinuxKernel::Result LinuxKernel::sys_write(const Arguments& a) {
    const std::uint32_t count = std::min(a[2], MOST_BYTES);
    const std::uint8_t* from = memory_.bytes(a[1], count, arm_access::READ);
    if (!from) return -EFAULT;
    const int fd = fd_of(a[0]);
    return files_.is_console(fd) ? print(fd, from, count) : files_.write(fd, from, count);
}

// The board's console is a serial line behind a buffer of the kernel's.  What is printed is seen at
// once here, but where the line would still have a full buffer before it, the program waits.
std::int64_t LinuxKernel::print(int fd, const std::uint8_t* from, std::uint32_t count) {
    constexpr std::uint32_t BUFFER = 4096, WAKES_AT = 256;  // as Linux' serial core and tty have it
    const sc_core::sc_time character{10. / 115'200, sc_core::SC_SEC};
    std::uint32_t done = 0;
    while (done < count) {
        line_free_ = std::max(line_free_, cpu_.now());
        const auto waiting =
            static_cast<std::uint32_t>(std::ceil((line_free_ - cpu_.now()) / character));
        const std::uint32_t part = std::min(count - done, BUFFER - std::min(BUFFER, waiting));
        if (part == 0) {
            if (files_.flags(fd) & static_cast<int>(arm_open::NONBLOCK))
                return done ? done : -EAGAIN;
            const std::uint32_t wanted = std::min(count - done, BUFFER - WAKES_AT);
            cpu_.pause((waiting + wanted - BUFFER) * character);
            continue;
        }
        const std::int64_t written = files_.write(fd, from + done, part);
        if (written < 0) return written;
        line_free_ += part * character;
        done += part;
    }
    return done;
}

std::int64_t LinuxKernel::each_vector(const Arguments& a, bool write) {
    constexpr std::uint32_t MOST = 1024;
    if (a[2] > MOST) return -EINVAL;
    std::int64_t all = 0;
    for (std::uint32_t i = 0; i < a[2]; ++i) {
        std::uint32_t vector[2];
        if (!memory_.read(a[1] + 8 * i, vector, sizeof vector)) return all ? all : -EFAULT;
        const Arguments one{a[0], vector[0], vector[1]};
        const std::int64_t count = *(write ? sys_write(one) : sys_read(one));
        if (count < 0) return all ? all : count;
        all += count;
        if (count < vector[1]) break;
    }
    return all;
}

LinuxKernel::Result LinuxKernel::sys_readv(const Arguments& a) { return each_vector(a, false); }
LinuxKernel::Result LinuxKernel::sys_writev(const Arguments& a) { return each_vector(a, true); }

// 64-bit values lie in an even register and the next one.
LinuxKernel::Result LinuxKernel::sys_pread64(const Arguments& a) {
    const std::uint32_t count = std::min(a[2], MOST_BYTES);
    std::uint8_t* to = memory_.bytes(a[1], count, arm_access::WRITE);
    return to ? files_.read_at(fd_of(a[0]), to, count, pair_of(a[4], a[5])) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_pwrite64(const Arguments& a) {
    const std::uint32_t count = std::min(a[2], MOST_BYTES);
    const std::uint8_t* from = memory_.bytes(a[1], count, arm_access::READ);
    return from ? files_.write_at(fd_of(a[0]), from, count, pair_of(a[4], a[5])) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_lseek(const Arguments& a) {
    return files_.seek(fd_of(a[0]), static_cast<std::int32_t>(a[1]), fd_of(a[2]));
}

LinuxKernel::Result LinuxKernel::sys_llseek(const Arguments& a) {
    const std::int64_t at = files_.seek(fd_of(a[0]), pair_of(a[2], a[1]), fd_of(a[4]));
    if (at < 0) return at;
    return memory_.write(a[3], &at, sizeof at) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_ftruncate64(const Arguments& a) {
    return files_.truncate(fd_of(a[0]), pair_of(a[2], a[3]));
}

LinuxKernel::Result LinuxKernel::sys_fsync(const Arguments& a) { return files_.sync(fd_of(a[0])); }

LinuxKernel::Result LinuxKernel::sys_dup(const Arguments& a) {
    return files_.duplicate(fd_of(a[0]), 0);
}

LinuxKernel::Result LinuxKernel::sys_dup2(const Arguments& a) {
    return files_.duplicate_onto(fd_of(a[0]), fd_of(a[1]));
}

LinuxKernel::Result LinuxKernel::sys_fcntl(const Arguments& a) {
    const int fd = fd_of(a[0]);
    switch (a[1]) {
        case arm_fcntl::DUPFD:
        case arm_fcntl::DUPFD_CLOEXEC: return files_.duplicate(fd, fd_of(a[2]));
        case arm_fcntl::GETFD: return files_.close_on_exec(fd);
        case arm_fcntl::SETFD: return files_.set_close_on_exec(fd, a[2] & 1);
        case arm_fcntl::GETFL: return files_.flags(fd);
        case arm_fcntl::SETFL: return files_.set_flags(fd, a[2]);
        default: return -EINVAL;
    }
}

// A C library requests the terminal's settings to find out whether it is one.  If so, it flushes
// its output at each end of a line, on the board's serial console and here.
LinuxKernel::Result LinuxKernel::sys_ioctl(const Arguments& a) {
    const int fd = fd_of(a[0]);
    if (files_.flags(fd) < 0) return -EBADF;
    if (!files_.is_console(fd)) return -ENOTTY;
    Terminal::Settings& settings = terminal_.settings;
    if (a[1] == TCGETS) return memory_.write(a[2], &settings, sizeof settings) ? 0 : -EFAULT;
    if (a[1] >= TCSETS && a[1] <= TCSETSF)
        return memory_.read(a[2], &settings, sizeof settings) ? 0 : -EFAULT;
    if (a[1] == FIONREAD) {
        const std::uint32_t count = terminal_.ready();
        return memory_.write(a[2], &count, sizeof count) ? 0 : -EFAULT;
    }
    if (a[1] == TIOCGWINSZ) {
        constexpr std::uint16_t SIZE[4] = {24, 80, 0, 0};
        return memory_.write(a[2], SIZE, sizeof SIZE) ? 0 : -EFAULT;
    }
    return -ENOTTY;
}

}  // namespace sim
