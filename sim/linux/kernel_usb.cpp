// kernel_usb.cpp - LinuxKernel's USB: requests of usbfs that wait, and sockets that hear of plugs
#include <array>
#include <cerrno>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"
#include "sim/linux/usb_file.h"

namespace sim {

void LinuxKernel::plug_in(UsbPorts& ports) {
    input_.attach(ports);
    usb_.attach(ports);
}

// ---- usbfs --------------------------------------------------------------------------------------

// No value: it is not of usbfs.
LinuxKernel::Result LinuxKernel::usb_control(int fd, UsbFile& file, const Arguments& a) {
    constexpr std::uint64_t NS_PER_MS = 1'000'000, RESET_MS = 60;
    const auto what = static_cast<std::uint8_t>(a[1]);
    if ((files().flags(fd) & static_cast<int>(arm_open::ACCESS)) !=
        static_cast<int>(arm_open::RDWR))
        return -EPERM;
    changed_ = true;
    LinuxWait wait;
    wait.what = file.name();
    const auto open = files().hold(fd);
    if (what == UsbFile::REAP) {
        wait.look = [this, &file, open, at = a[2], request = a[1]](LinuxWait&) -> Result {
            const std::int64_t result = file.control(request, at, memory());
            return result == -EAGAIN ? Result{} : result;
        };
    } else if (what == UsbFile::CONTROL || what == UsbFile::BULK) {
        const auto [error, transfer, ms] = file.begin(a[1], a[2], memory());
        if (error) return error;
        wait.at_ns = ms == 0 ? LinuxWait::NEVER : later_ns(ms * NS_PER_MS);
        wait.look = [this, &file, open, transfer = transfer](LinuxWait& w) -> Result {
            if (transfer->done) return UsbFile::finish(*transfer, memory());
            if (now_ns() < w.at_ns) return std::nullopt;
            file.cancel(*transfer);
            return -ETIMEDOUT;
        };
    } else {
        const std::int64_t result = file.control(a[1], a[2], memory());
        if (what != UsbFile::RESET || result != 0) return result;
        wait.at_ns = later_ns(RESET_MS * NS_PER_MS);
        wait.look = [this](LinuxWait& w) -> Result { return now_ns() < w.at_ns ? Result{} : 0; };
    }
    return this->wait(std::move(wait));
}

// ---- Sockets of netlink -------------------------------------------------------------------------

UeventSocket* LinuxKernel::uevents_at(std::uint32_t fd) const {
    return dynamic_cast<UeventSocket*>(files().device(static_cast<int>(fd)));
}

LinuxKernel::Result LinuxKernel::uevent_socket(const Arguments& a) {
    constexpr std::uint32_t RAW = 3, DATAGRAM = 2, TYPE = 0xF, KOBJECT_UEVENT = 15;
    const std::uint32_t type = a[1] & TYPE;
    if (type != RAW && type != DATAGRAM) return -ESOCKTNOSUPPORT;
    if (a[2] != KOBJECT_UEVENT) return -EPROTONOSUPPORT;
    const auto socket = std::make_shared<UeventSocket>();
    uevents_.join(socket);
    return files().add(socket, (a[1] & (arm_open::CLOEXEC | arm_open::NONBLOCK)) | arm_open::RDWR);
}

// struct sockaddr_nl: family, number of the process, groups.
std::int64_t LinuxKernel::bind_uevents(UeventSocket& socket, const Arguments& a) {
    std::array<std::uint32_t, 3> address;
    if (a[2] < sizeof address) return -EINVAL;
    if (!memory().read(a[1], address.data(), sizeof address)) return -EFAULT;
    if ((address[0] & 0xFFFF) != NETLINK) return -EINVAL;
    socket.groups = address[2];
    return 0;
}

std::int64_t LinuxKernel::name_uevents(const UeventSocket& socket, const Arguments& a) {
    const std::array<std::uint32_t, 3> address{
        NETLINK, static_cast<std::uint32_t>(process_->number), socket.groups};
    std::uint32_t room;
    const std::uint32_t bytes = sizeof address;
    if (!memory().read(a[2], &room, sizeof room)) return -EFAULT;
    const bool written = memory().write(a[1], address.data(), std::min(room, bytes)) &&
                         memory().write(a[2], &bytes, sizeof bytes);
    return written ? 0 : -EFAULT;
}

std::int64_t LinuxKernel::set_uevents(UeventSocket& socket, const Arguments& a) {
    constexpr std::uint32_t LEVEL = 1, PASS_CREDENTIALS = 16;
    std::uint32_t on = 0;
    if (a[1] != LEVEL || a[2] != PASS_CREDENTIALS) return 0;
    if (!memory().read(a[3], &on, sizeof on)) return -EFAULT;
    socket.tells_who = on != 0;
    return 0;
}

// With the kernel's address, and that it is user 0's.  A header as sys_recvmsg() has it.
LinuxKernel::Result LinuxKernel::receive_uevent(std::uint32_t fd, const Arguments& a) {
    std::array<std::uint32_t, 7> header;
    std::vector<Piece> pieces;
    if (!memory().read(a[1], header.data(), sizeof header)) return -EFAULT;
    if (const std::int64_t error = pieces_at(header[2], header[3], pieces)) return error;
    LinuxWait wait;
    wait.what = files().name(static_cast<int>(fd));
    wait.restarts = true;
    wait.look = [this, fd, a, header, pieces](LinuxWait&) mutable -> Result {
        constexpr std::uint32_t NOT_WAITING = 0x40, CUT = 0x20, SOCKET = 1, CREDENTIALS = 2,
                                KERNEL = 1;
        UeventSocket* const socket = uevents_at(fd);
        if (!socket) return -EBADF;
        if (socket->next_bytes() == 0) {
            if (does_not_wait(fd) || (a[2] & NOT_WAITING)) return -EAGAIN;
            return std::nullopt;
        }
        const auto [to, room] = part(pieces, 0, arm_access::WRITE);
        if (!to) return -EFAULT;
        const std::size_t bytes = socket->next_bytes();
        const std::int64_t count = socket->read(to, room);
        const std::array<std::uint32_t, 3> from{NETLINK, 0, KERNEL};
        const std::array<std::uint32_t, 6> who{sizeof who, SOCKET, CREDENTIALS, 0, 0, 0};
        if (header[0] != 0) {
            memory().write(header[0], from.data(), std::min<std::size_t>(header[1], sizeof from));
            header[1] = sizeof from;
        }
        const bool tells = socket->tells_who && header[5] >= sizeof who;
        if (tells) memory().write(header[4], who.data(), sizeof who);
        header[5] = tells ? sizeof who : 0;
        header[6] = bytes > room ? CUT : 0;
        changed_ = true;
        return memory().write(a[1], header.data(), sizeof header) ? count : -EFAULT;
    };
    return this->wait(std::move(wait));
}

}  // namespace sim
