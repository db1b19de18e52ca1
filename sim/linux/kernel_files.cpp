// kernel_files.cpp - LinuxKernel's calls on open files
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"
#include "sim/linux/usb_file.h"

namespace sim {

namespace {

constexpr std::uint32_t MOST_BYTES = 0x7FFFF000;  // of one transfer, as the kernel has it
constexpr std::uint32_t TCGETS = 0x5401, TCSETS = 0x5402, TCSETSF = 0x5404, TCFLSH = 0x540B,
                        TIOCGWINSZ = 0x5413, FIONBIO = 0x5421;
constexpr std::uint32_t OUTPUT_ONLY = 1;

// What is there on each Linux without a program's doing.
bool is_of_the_system(const std::string& path) {
    const auto in = [&](const char* folder) { return path.rfind(folder, 0) == 0; };
    if (in("/sys/bus/usb/devices/")) return false;  // some devices have no "serial"
    return in("/dev/") || in("/proc/") || in("/sys/");
}

bool is_of_usb(const std::string& path) {
    return path.rfind("/dev/input/", 0) == 0 || path.rfind("/dev/bus/usb/", 0) == 0;
}

bool is_shared_memory(const std::string& path) { return path.rfind("/dev/shm/", 0) == 0; }

// A command that Linux has, of those that are not answered here: locks, leases and so on.
bool is_fcntl(std::uint32_t command) {
    return command <= 38 || (command >= 1024 && command <= 1038);
}

int fd_of(std::uint32_t value) { return static_cast<int>(value); }

std::int64_t pair_of(std::uint32_t low, std::uint32_t high) {
    return static_cast<std::int64_t>(std::uint64_t{high} << 32 | low);
}

}  // namespace

LinuxKernel::Result LinuxKernel::open(std::uint32_t folder, std::uint32_t path, std::uint32_t flags,
                                      std::uint32_t mode) {
    const auto [error, text] = path_at(folder, path);
    if (error) return error;
    if (const auto node = module_node(text)) return open_module(*node, text, flags);
    const int fd = files().open(text, flags, mode & ~process_->umask);
    if (flags & arm_open::TRUNC) files_changed();
    if (is_library(text)) {
        if (fd >= 0 || fd == -ENOENT)
            loader_.looked_for(text, fd < 0 ? fd : files().on_host(fd).first);
        return fd;
    }
    if (fd == -ENOENT && is_of_the_system(text) && !is_shared_memory(text) &&
        named_files_.insert(text).second)
        outside_.log(fmt::format(
            "{} is not there: {}, {}", text,
            is_of_usb(text) ? "no device in a USB port has it (a scenario's usb, plug-usb)"
                            : "of the system's files the simulated Linux has /dev/mem and a few "
                              "more, and what --linux-root brings",
            cpu_.where()));
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

LinuxKernel::Result LinuxKernel::sys_close(const Arguments& a) {
    changed_ = true;
    if (ModuleFile* const file = module_file(fd_of(a[0]))) {
        ModuleRequest flush{KMOD_FLUSH, file->id};
        flush.thread = running_;
        flush.finish = [this, fd = fd_of(a[0])](std::int64_t result) -> Result {
            files().close(fd);
            return result;
        };
        return request(file->module, std::move(flush), "close of " + file->name());
    }
    forget_notice(a[0]);
    return files().close(fd_of(a[0]));
}

// The bytes from `done` on that lie together; nullptr: they are not the program's.
std::pair<std::uint8_t*, std::uint32_t> LinuxKernel::part(const std::vector<Piece>& pieces,
                                                          std::int64_t done,
                                                          unsigned access) const {
    auto skip = static_cast<std::uint64_t>(done);
    for (const Piece& piece : pieces) {
        if (skip >= piece.bytes && (&piece != &pieces.back() || skip > piece.bytes)) {
            skip -= piece.bytes;
            continue;
        }
        const auto rest = static_cast<std::uint32_t>(piece.bytes - skip);
        return {memory().bytes(piece.address + static_cast<std::uint32_t>(skip), rest, access),
                rest};
    }
    return {memory().bytes(0, 0, access), 0};
}

// A module gets one piece at a time: the program asks again for the others.
LinuxKernel::Piece LinuxKernel::first_of(const std::vector<Piece>& pieces) {
    for (const Piece& piece : pieces)
        if (piece.bytes > 0) return piece;
    return {0, 0};
}

LinuxKernel::Result LinuxKernel::read(int fd, std::vector<Piece> pieces) {
    if (ModuleFile* const file = module_file(fd)) {
        if ((static_cast<unsigned>(files().flags(fd)) & arm_open::ACCESS) == arm_open::WRONLY)
            return -EBADF;
        const Piece piece = first_of(pieces);
        return request(fd, *file, KMOD_READ, piece.address, piece.bytes);
    }
    LinuxWait wait;
    wait.what = files().name(fd);
    wait.restarts = true;
    wait.inside = files().is_inside(fd);
    wait.look = [this, fd, pieces = std::move(pieces),
                 file = files().hold(fd)](LinuxWait&) -> Result {
        std::int64_t all = 0;
        for (;;) {
            const auto [to, bytes] = part(pieces, all, arm_access::WRITE);
            const std::int64_t count = to ? files().read(fd, to, bytes) : -EFAULT;
            if (count < 0 && all > 0) return all;
            if (count == -EAGAIN && !(files().flags(fd) & static_cast<int>(arm_open::NONBLOCK)))
                return std::nullopt;
            if (count < 0) return count;
            all += count;
            if (count < bytes || part(pieces, all, 0).second == 0) break;
        }
        changed_ = true;
        return all;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::write(int fd, std::vector<Piece> pieces) {
    if (ModuleFile* const file = module_file(fd)) {
        if ((static_cast<unsigned>(files().flags(fd)) & arm_open::ACCESS) == arm_open::RDONLY)
            return -EBADF;
        const Piece piece = first_of(pieces);
        return request(fd, *file, KMOD_WRITE, piece.address, piece.bytes);
    }
    LinuxWait wait;
    wait.what = files().name(fd);
    wait.restarts = true;
    wait.inside = files().is_inside(fd);
    wait.look = [this, fd, pieces = std::move(pieces),
                 &thread = *running_](LinuxWait& w) -> Result {
        const int flags = files().flags(fd);
        for (;;) {
            const auto [from, bytes] = part(pieces, w.done, arm_access::READ);
            const std::int64_t count = !from                    ? -EFAULT
                                       : files().is_console(fd) ? print(fd, from, bytes, w)
                                                                : files().write(fd, from, bytes);
            if (count == -EAGAIN && flags >= 0 && !(flags & static_cast<int>(arm_open::NONBLOCK)))
                return std::nullopt;
            if (count == -EPIPE && w.done == 0) send(thread, {SIGPIPE, 0, {}, "nobody reads"});
            changed_ = true;
            if (count < 0) return w.done > 0 ? w.done : count;
            w.done += count;
            if (count == 0 || part(pieces, w.done, 0).second == 0) return w.done;
        }
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_read(const Arguments& a) {
    return read(fd_of(a[0]), {{a[1], std::min(a[2], MOST_BYTES)}});
}

LinuxKernel::Result LinuxKernel::sys_write(const Arguments& a) {
    return write(fd_of(a[0]), {{a[1], std::min(a[2], MOST_BYTES)}});
}

// The board's console is a serial line behind a buffer of the kernel's.  What is printed is seen at
// once here, but where the line would still have a full buffer before it, the program waits.
std::int64_t LinuxKernel::print(int fd, const std::uint8_t* from, std::uint32_t count,
                                LinuxWait& wait) {
    constexpr std::uint32_t BUFFER = 4096, WAKES_AT = 256;  // as Linux' serial core and tty have it
    const sc_core::sc_time character{10. / 115'200, sc_core::SC_SEC};
    line_free_ = std::max(line_free_, cpu_.now());
    const auto waiting =
        static_cast<std::uint32_t>(std::ceil((line_free_ - cpu_.now()) / character));
    const std::uint32_t room = std::min(count, BUFFER - std::min(BUFFER, waiting));
    if (room == 0 && count > 0) {
        const std::uint32_t wanted = std::min(count, BUFFER - WAKES_AT);
        const sc_core::sc_time at = cpu_.now() + (waiting + wanted - BUFFER) * character;
        wait.at_ns = (at.value() + 999) / 1000;
        return -EAGAIN;
    }
    const std::int64_t written = files().write(fd, from, room);
    if (written > 0) line_free_ += static_cast<double>(written) * character;
    return written;
}

// Of struct iovec.
std::int64_t LinuxKernel::pieces_at(std::uint32_t list, std::uint32_t count,
                                    std::vector<Piece>& pieces) const {
    constexpr std::uint32_t MOST = 1024;
    if (count > MOST) return -EINVAL;
    pieces.resize(count);
    static_assert(sizeof(Piece) == 8);
    if (!memory().read(list, pieces.data(), count * sizeof(Piece))) return -EFAULT;
    std::uint64_t all = 0;
    for (Piece& piece : pieces) {
        if (piece.bytes > INT32_MAX) return -EINVAL;
        piece.bytes = static_cast<std::uint32_t>(std::min<std::uint64_t>(
            piece.bytes, MOST_BYTES - std::min<std::uint64_t>(all, MOST_BYTES)));
        all += piece.bytes;
    }
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_readv(const Arguments& a) {
    std::vector<Piece> pieces;
    const std::int64_t error = pieces_at(a[1], a[2], pieces);
    return error ? error : read(fd_of(a[0]), std::move(pieces));
}

LinuxKernel::Result LinuxKernel::sys_writev(const Arguments& a) {
    std::vector<Piece> pieces;
    const std::int64_t error = pieces_at(a[1], a[2], pieces);
    return error ? error : write(fd_of(a[0]), std::move(pieces));
}

// 64-bit values lie in an even register and the next one.
LinuxKernel::Result LinuxKernel::sys_pread64(const Arguments& a) {
    const std::uint32_t count = std::min(a[2], MOST_BYTES);
    std::uint8_t* to = memory().bytes(a[1], count, arm_access::WRITE);
    return to ? files().read_at(fd_of(a[0]), to, count, pair_of(a[4], a[5])) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_pwrite64(const Arguments& a) {
    const std::uint32_t count = std::min(a[2], MOST_BYTES);
    const std::uint8_t* from = memory().bytes(a[1], count, arm_access::READ);
    return from ? files().write_at(fd_of(a[0]), from, count, pair_of(a[4], a[5])) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_getdents64(const Arguments& a) {
    std::uint8_t* const to = memory().bytes(a[1], a[2], arm_access::WRITE);
    return to ? files().read_folder(fd_of(a[0]), to, a[2]) : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_lseek(const Arguments& a) {
    if (ModuleFile* const file = module_file(fd_of(a[0])))
        return request(fd_of(a[0]), *file, KMOD_SEEK, a[1],
                       static_cast<std::int32_t>(a[1]) < 0 ? ~0u : 0, a[2]);
    return files().seek(fd_of(a[0]), static_cast<std::int32_t>(a[1]), fd_of(a[2]));
}

LinuxKernel::Result LinuxKernel::sys_llseek(const Arguments& a) {
    const auto give = [this, to = a[3]](std::int64_t at) -> Result {
        if (at < 0) return at;
        return memory().write(to, &at, sizeof at) ? 0 : -EFAULT;
    };
    if (ModuleFile* const file = module_file(fd_of(a[0]))) {
        ModuleRequest seek{KMOD_SEEK, file->id, 0, {a[2], a[1], a[4]}, running_, nullptr, give};
        return request(file->module, std::move(seek), "lseek of " + file->name());
    }
    return give(files().seek(fd_of(a[0]), pair_of(a[2], a[1]), fd_of(a[4])));
}

LinuxKernel::Result LinuxKernel::sys_ftruncate64(const Arguments& a) {
    const int error = files().truncate(fd_of(a[0]), pair_of(a[2], a[3]));
    files_changed();
    return error;
}

LinuxKernel::Result LinuxKernel::sys_ftruncate(const Arguments& a) {
    const std::int64_t bytes = static_cast<std::int32_t>(a[1]);
    return sys_ftruncate64(
        {a[0], 0, static_cast<std::uint32_t>(bytes), static_cast<std::uint32_t>(bytes >> 32)});
}

LinuxKernel::Result LinuxKernel::sys_truncate64(const Arguments& a) {
    const Result fd = open(ARM_AT_FDCWD, a[0], arm_open::WRONLY, 0);
    if (!fd || *fd < 0) return fd;
    const Result result = sys_ftruncate64({static_cast<std::uint32_t>(*fd), 0, a[2], a[3]});
    files().close(static_cast<int>(*fd));
    return result;
}

LinuxKernel::Result LinuxKernel::sys_truncate(const Arguments& a) {
    return sys_truncate64({a[0], 0, a[1], static_cast<std::int32_t>(a[1]) < 0 ? ~0u : 0});
}

LinuxKernel::Result LinuxKernel::sys_fsync(const Arguments& a) { return files().sync(fd_of(a[0])); }

LinuxKernel::Result LinuxKernel::sys_dup(const Arguments& a) {
    return files().duplicate(fd_of(a[0]), 0);
}

LinuxKernel::Result LinuxKernel::sys_dup2(const Arguments& a) {
    return files().duplicate_onto(fd_of(a[0]), fd_of(a[1]));
}

LinuxKernel::Result LinuxKernel::sys_fcntl(const Arguments& a) {
    const int fd = fd_of(a[0]);
    switch (a[1]) {
        case arm_fcntl::DUPFD:
        case arm_fcntl::DUPFD_CLOEXEC: return files().duplicate(fd, fd_of(a[2]));
        case arm_fcntl::GETFD: return files().close_on_exec(fd);
        case arm_fcntl::SETFD: return files().set_close_on_exec(fd, a[2] & 1);
        case arm_fcntl::GETFL: return files().flags(fd);
        case arm_fcntl::SETFL:
            files().set_flags(fd, a[2]);
            if (ModuleFile* const file = module_file(fd)) {
                const bool on = a[2] & arm_open::ASYNC;
                if (std::exchange(file->sends_signals, on) != on) {
                    ModuleRequest fasync{KMOD_FASYNC, file->id, 0,      {a[0], on},
                                         running_,    nullptr,  nullptr};
                    fasync.finish = [](std::int64_t result) {
                        return Result{std::min<std::int64_t>(result, 0)};
                    };
                    return request(file->module, std::move(fasync), "fcntl of " + file->name());
                }
            }
            return files().flags(fd) < 0 ? -EBADF : 0;
        case arm_fcntl::SETOWN:
            if (ModuleFile* const file = module_file(fd)) file->owner = fd_of(a[2]);
            return files().flags(fd) < 0 ? -EBADF : 0;
        case arm_fcntl::GETPIPE_SZ:
        case arm_fcntl::SETPIPE_SZ: {
            LinuxDevice* const device = files().device(fd);
            if (!device) return -EBADF;
            changed_ = true;
            return a[1] == arm_fcntl::GETPIPE_SZ ? device->pipe_size()
                                                 : device->set_pipe_size(a[2]);
        }
        default:
            if (is_fcntl(a[1])) not_emulated(fmt::format("fcntl, command {}", a[1]));
            return -EINVAL;
    }
}

// A C library requests the terminal's settings to find out whether it is one.  If so, it flushes
// its output at each end of a line, on the board's serial console and here.
LinuxKernel::Result LinuxKernel::sys_ioctl(const Arguments& a) {
    const int fd = fd_of(a[0]);
    if (files().flags(fd) < 0) return -EBADF;
    if (ModuleFile* const file = module_file(fd); file && a[1] != FIONBIO)
        return request(fd, *file, KMOD_IOCTL, a[1], a[2]);
    if (LinuxDevice* const device = files().device(fd)) {
        auto* const usb = dynamic_cast<UsbFile*>(device);
        if (usb && UsbFile::is_request(a[1])) return usb_control(fd, *usb, a);
        const std::int64_t result = device->control(a[1], a[2], memory());
        if (result != -ENOTTY || a[1] != FIONBIO) return result;
    }
    if (a[1] == FIONBIO) {
        std::uint32_t on;
        if (!memory().read(a[2], &on, sizeof on)) return -EFAULT;
        return files().set_flags(fd, on ? arm_open::NONBLOCK : 0);
    }
    if (!files().is_console(fd)) return -ENOTTY;
    Terminal::Settings& settings = terminal_.settings;
    if (a[1] == TCGETS) return memory().write(a[2], &settings, sizeof settings) ? 0 : -EFAULT;
    if (a[1] >= TCSETS && a[1] <= TCSETSF) {
        changed_ = true;
        if (a[1] == TCSETSF) terminal_.flush();
        return memory().read(a[2], &settings, sizeof settings) ? 0 : -EFAULT;
    }
    if (a[1] == TCFLSH) {
        if (a[2] != OUTPUT_ONLY) terminal_.flush();
        return 0;
    }
    if (a[1] == arm_ioctl::READABLE) {
        const std::uint32_t count = terminal_.ready();
        return memory().write(a[2], &count, sizeof count) ? 0 : -EFAULT;
    }
    if (a[1] == TIOCGWINSZ) {
        constexpr std::uint16_t SIZE[4] = {24, 80, 0, 0};
        return memory().write(a[2], SIZE, sizeof SIZE) ? 0 : -EFAULT;
    }
    return -ENOTTY;
}

}  // namespace sim
