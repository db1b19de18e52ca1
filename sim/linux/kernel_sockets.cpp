// kernel_sockets.cpp - LinuxKernel's calls for sockets, which reach the run's own processes, and
// what --network names
#include <algorithm>
#include <cerrno>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t SOCKET_TYPE = 0xF, SOCKET_FLAGS = arm_open::CLOEXEC | arm_open::NONBLOCK;
constexpr std::uint32_t MSG_PEEKS = 2, MSG_WHOLE_LENGTH = 0x20, MSG_NOT_WAITING = 0x40,
                        MSG_WAITS_FOR_ALL = 0x100, MSG_WITHOUT_SIGNAL = 0x4000;
constexpr std::uint32_t LONGEST_MESSAGE = 16 << 20;

}  // namespace

LinuxSocket* LinuxKernel::socket_at(std::uint32_t fd, int& error) const {
    auto* const socket = dynamic_cast<LinuxSocket*>(files().device(static_cast<int>(fd)));
    error = socket ? 0 : files().flags(static_cast<int>(fd)) < 0 ? -EBADF : -ENOTSOCK;
    return socket;
}

int LinuxKernel::check_socket(std::uint32_t family, std::uint32_t type, std::uint32_t protocol) {
    constexpr std::uint32_t TCP = 6, UDP = 17;
    const std::uint32_t kind = type & SOCKET_TYPE;
    if (type & ~(SOCKET_TYPE | SOCKET_FLAGS)) return -EINVAL;
    const bool is_unix = family == SocketAddress::UNIX, inet = family == SocketAddress::INET;
    if (!is_unix && !inet) return -EAFNOSUPPORT;
    if (kind == LinuxSocket::STREAM)
        return inet && protocol != 0 && protocol != TCP ? -EPROTONOSUPPORT : 0;
    if (kind == LinuxSocket::DATAGRAM)
        return inet && protocol != 0 && protocol != UDP ? -EPROTONOSUPPORT : 0;
    return is_unix && kind == LinuxSocket::PACKETS ? 0 : -ESOCKTNOSUPPORT;
}

LinuxKernel::Result LinuxKernel::sys_socket(const Arguments& a) {
    if (a[0] == NETLINK) return uevent_socket(a);
    if (const int error = check_socket(a[0], a[1], a[2])) return error;
    return files().add(std::make_shared<LinuxSocket>(network_, static_cast<std::uint16_t>(a[0]),
                                                     a[1] & SOCKET_TYPE),
                       (a[1] & SOCKET_FLAGS) | arm_open::RDWR);
}

LinuxKernel::Result LinuxKernel::sys_socketpair(const Arguments& a) {
    if (const int error = check_socket(a[0], a[1], a[2])) return error;
    if (a[0] != SocketAddress::UNIX) return -EOPNOTSUPP;
    const unsigned type = a[1] & SOCKET_TYPE;
    const auto one = std::make_shared<LinuxSocket>(network_, SocketAddress::UNIX, type);
    const auto other = std::make_shared<LinuxSocket>(network_, SocketAddress::UNIX, type);
    LinuxSocket::connect_pair(*one, *other);
    const std::uint32_t flags = (a[1] & SOCKET_FLAGS) | arm_open::RDWR;
    const int first = files().add(one, flags);
    return give_two(a[3], {first, files().add(other, flags)});
}

// ---- Addresses ----------------------------------------------------------------------------------

std::int64_t LinuxKernel::address_at(std::uint32_t at, std::uint32_t bytes,
                                     SocketAddress& address) const {
    constexpr std::uint32_t LONGEST = 128;
    if (static_cast<std::int32_t>(bytes) < 0 || bytes > LONGEST) return -EINVAL;
    std::vector<std::uint8_t> data(bytes);
    if (!memory().read(at, data.data(), bytes)) return -EFAULT;
    const auto found = SocketAddress::from(data);
    if (!found) return -EINVAL;
    address = *found;
    return 0;
}

// As much of it as there is room for, and how long it is; without an address nothing.
std::int64_t LinuxKernel::give_address(const SocketAddress& address, std::uint32_t to,
                                       std::uint32_t length_at) {
    std::int32_t room;
    if (to == 0) return 0;
    if (!memory().read(length_at, &room, sizeof room)) return -EFAULT;
    if (room < 0) return -EINVAL;
    const std::vector<std::uint8_t> bytes = address.bytes();
    const auto length = static_cast<std::uint32_t>(bytes.size());
    const bool given =
        memory().write(to, bytes.data(), std::min(length, static_cast<std::uint32_t>(room))) &&
        memory().write(length_at, &length, sizeof length);
    return given ? 0 : -EFAULT;
}

// Nothing else leaves the simulator: reported once.
bool LinuxKernel::is_reachable(const SocketAddress& address) {
    if (address.is_here() || host_network_.has(address)) return true;
    if (!unreachable_reported_)
        outside_.log(
            fmt::format("{} is not reachable: the simulated Linux has no network but the "
                        "loopback{}, {}",
                        address.text(), host_network_.exists() ? " and what --network names" : "",
                        cpu_.where()));
    unreachable_reported_ = true;
    return false;
}

LinuxKernel::Result LinuxKernel::sys_bind(const Arguments& a) {
    if (UeventSocket* const uevents = uevents_at(a[0])) return bind_uevents(*uevents, a);
    int error;
    SocketAddress address;
    LinuxSocket* const socket = socket_at(a[0], error);
    if (!socket) return error;
    const std::int64_t wrong = address_at(a[1], a[2], address);
    return wrong ? wrong : socket->bind(address);
}

LinuxKernel::Result LinuxKernel::sys_listen(const Arguments& a) {
    int error;
    LinuxSocket* const socket = socket_at(a[0], error);
    return socket ? socket->listen(a[1]) : error;
}

LinuxKernel::Result LinuxKernel::sys_getsockname(const Arguments& a) {
    if (const UeventSocket* const uevents = uevents_at(a[0])) return name_uevents(*uevents, a);
    int error;
    const LinuxSocket* const socket = socket_at(a[0], error);
    return socket ? give_address(socket->address(), a[1], a[2]) : error;
}

LinuxKernel::Result LinuxKernel::sys_getpeername(const Arguments& a) {
    int error;
    const LinuxSocket* const socket = socket_at(a[0], error);
    if (!socket) return error;
    return socket->peer() ? give_address(*socket->peer(), a[1], a[2]) : -ENOTCONN;
}

// ---- Connections --------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_connect(const Arguments& a) {
    int error;
    SocketAddress address;
    const LinuxSocket* const socket = socket_at(a[0], error);
    if (!socket) return error;
    if (const std::int64_t wrong = address_at(a[1], a[2], address)) return wrong;
    if (!is_reachable(address)) return -ENETUNREACH;
    LinuxWait wait;
    const bool outside = host_network_.has(address);
    wait.what = fmt::format("{} {}", outside ? "an answer of" : "a place among the connections to",
                            address.text());
    wait.restarts = true;
    wait.inside = !outside;
    wait.look = [this, fd = a[0], address, begun = false](LinuxWait&) mutable -> Result {
        int wrong;
        LinuxSocket* const own = socket_at(fd, wrong);
        int result = own ? own->connect(address) : wrong;
        const bool connects = result == -EINPROGRESS || (begun && result == -EALREADY);
        begun |= connects;
        if ((result == -EAGAIN || connects) && !does_not_wait(fd)) return std::nullopt;
        changed_ = true;
        return result;
    };
    return this->wait(std::move(wait));
}

bool LinuxKernel::does_not_wait(std::uint32_t fd) const {
    const int flags = files().flags(static_cast<int>(fd));
    return flags < 0 || (flags & static_cast<int>(arm_open::NONBLOCK));
}

LinuxKernel::Result LinuxKernel::sys_accept4(const Arguments& a) {
    int error;
    const LinuxSocket* const socket = socket_at(a[0], error);
    if (!socket) return error;
    if (a[3] & ~SOCKET_FLAGS) return -EINVAL;
    LinuxWait wait;
    wait.what = socket->name();
    wait.inside = wait.restarts = true;
    wait.look = [this, a](LinuxWait&) -> Result {
        int wrong;
        LinuxSocket* const own = socket_at(a[0], wrong);
        if (!own) return wrong;
        auto [refused, served] = own->accept();
        if (refused == -EAGAIN && !does_not_wait(a[0])) return std::nullopt;
        if (refused) return refused;
        changed_ = true;
        const SocketAddress peer = served->peer().value_or(SocketAddress{});
        const int fd = files().add(served, a[3] | arm_open::RDWR);
        if (fd < 0) return fd;
        const std::int64_t given = give_address(peer, a[1], a[2]);
        if (given < 0) files().close(fd);
        return given < 0 ? given : fd;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_accept(const Arguments& a) {
    return sys_accept4({a[0], a[1], a[2], 0});
}

LinuxKernel::Result LinuxKernel::sys_shutdown(const Arguments& a) {
    int error;
    LinuxSocket* const socket = socket_at(a[0], error);
    changed_ = true;
    return socket ? socket->shut_down(a[1]) : error;
}

// ---- Messages -----------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::send_to(std::uint32_t fd, const std::vector<Piece>& pieces,
                                         std::uint32_t flags,
                                         const std::optional<SocketAddress>& to) {
    int error;
    const LinuxSocket* const socket = socket_at(fd, error);
    if (!socket) return error;
    if (to && !is_reachable(*to)) return -ENETUNREACH;
    std::vector<std::uint8_t> data;
    for (const Piece& piece : pieces) {
        const std::uint8_t* const from =
            memory().bytes(piece.address, piece.bytes, arm_access::READ);
        if (!from) return -EFAULT;
        if (data.size() + piece.bytes > LONGEST_MESSAGE) return -EMSGSIZE;
        data.insert(data.end(), from, from + piece.bytes);
    }
    LinuxWait wait;
    wait.what = "room in " + socket->name();
    wait.restarts = true;
    wait.inside = socket->is_inside();
    wait.look = [this, fd, data = std::move(data), flags, to,
                 &thread = *running_](LinuxWait& w) -> Result {
        int wrong;
        LinuxSocket* const own = socket_at(fd, wrong);
        const bool stream = own && own->type() == LinuxSocket::STREAM;
        for (;;) {
            const auto done = static_cast<std::size_t>(w.done);
            const std::int64_t count =
                own ? own->send(data.data() + done, data.size() - done, to ? &*to : nullptr)
                    : wrong;
            if (count == -EAGAIN && !does_not_wait(fd) && !(flags & MSG_NOT_WAITING))
                return std::nullopt;
            changed_ = true;
            if (count == -EPIPE && w.done == 0 && !(flags & MSG_WITHOUT_SIGNAL))
                send(thread, {SIGPIPE, 0, {}, "nobody reads"});
            if (count < 0) return w.done > 0 ? w.done : count;
            w.done += count;
            if (!stream || static_cast<std::size_t>(w.done) == data.size()) return w.done;
        }
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_sendto(const Arguments& a) {
    std::optional<SocketAddress> to;
    if (a[4] != 0)
        if (const std::int64_t error = address_at(a[4], a[5], to.emplace())) return error;
    return send_to(a[0], {{a[1], a[2]}}, a[3], to);
}

LinuxKernel::Result LinuxKernel::sys_send(const Arguments& a) {
    return send_to(a[0], {{a[1], a[2]}}, a[3], std::nullopt);
}

// struct msghdr: name, its length, pieces, their number, control data, its length, flags.
LinuxKernel::Result LinuxKernel::sys_sendmsg(const Arguments& a) {
    std::uint32_t header[7];
    std::vector<Piece> pieces;
    std::optional<SocketAddress> to;
    if (!memory().read(a[1], header, sizeof header)) return -EFAULT;
    if (const std::int64_t error = pieces_at(header[2], header[3], pieces)) return error;
    if (header[0] != 0)
        if (const std::int64_t error = address_at(header[0], header[1], to.emplace())) return error;
    return send_to(a[0], pieces, a[2], to);
}

LinuxKernel::Result LinuxKernel::receive_from(std::uint32_t fd, std::vector<Piece> pieces,
                                              std::uint32_t flags, std::uint32_t name,
                                              std::uint32_t length_at, std::uint32_t header) {
    int error;
    const LinuxSocket* const socket = socket_at(fd, error);
    if (!socket) return error;
    LinuxWait wait;
    wait.what = socket->name();
    wait.restarts = true;
    if (socket->receive_limit_ns > 0) wait.at_ns = later_ns(socket->receive_limit_ns);
    wait.inside = wait.at_ns == LinuxWait::NEVER && socket->is_inside();
    wait.look = [this, fd, pieces = std::move(pieces), flags, name, length_at,
                 header](LinuxWait& w) -> Result {
        int wrong;
        LinuxSocket* const own = socket_at(fd, wrong);
        if (!own) return wrong;
        std::uint64_t most = 0;
        for (const Piece& piece : pieces) most += piece.bytes;
        std::vector<std::uint8_t> data(std::min<std::uint64_t>(most, LONGEST_MESSAGE));
        const bool stream = own->type() == LinuxSocket::STREAM;
        const auto limit = data.size() - static_cast<std::size_t>(w.done);
        SocketAddress from;
        const auto [count, all] = own->receive(data.data(), limit, flags & MSG_PEEKS, &from);
        if (count == -EAGAIN) {
            if (now_ns() >= w.at_ns) return w.done > 0 ? w.done : -EAGAIN;
            const bool at_once = does_not_wait(fd) || (flags & MSG_NOT_WAITING);
            return at_once ? Result{w.done > 0 ? w.done : -EAGAIN} : std::nullopt;
        }
        if (count < 0) return w.done > 0 ? w.done : count;
        std::size_t given = 0;
        while (given < static_cast<std::size_t>(count)) {
            const auto [to, room] =
                part(pieces, w.done + static_cast<std::int64_t>(given), arm_access::WRITE);
            if (!to) return -EFAULT;
            const std::size_t now =
                std::min<std::size_t>(room, static_cast<std::size_t>(count) - given);
            std::copy_n(data.data() + given, now, to);
            given += now;
        }
        changed_ = true;
        w.done += count;
        const bool goes_on = stream && (flags & MSG_WAITS_FOR_ALL) && !(flags & MSG_PEEKS) &&
                             count > 0 && static_cast<std::uint64_t>(w.done) < data.size();
        if (goes_on) return std::nullopt;
        if (const std::int64_t refused = give_address(from, name, length_at)) return refused;
        const bool cut = !stream && all > count;
        if (header != 0) {
            const std::uint32_t none[2] = {0, cut ? MSG_WHOLE_LENGTH : 0};
            if (!memory().write(header + 20, none, sizeof none)) return -EFAULT;
        }
        return cut && (flags & MSG_WHOLE_LENGTH) ? all : w.done;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_recvfrom(const Arguments& a) {
    if (uevents_at(a[0])) return read(static_cast<int>(a[0]), {{a[1], a[2]}});
    return receive_from(a[0], {{a[1], a[2]}}, a[3], a[4], a[5], 0);
}

LinuxKernel::Result LinuxKernel::sys_recv(const Arguments& a) {
    if (uevents_at(a[0])) return read(static_cast<int>(a[0]), {{a[1], a[2]}});
    return receive_from(a[0], {{a[1], a[2]}}, a[3], 0, 0, 0);
}

LinuxKernel::Result LinuxKernel::sys_recvmsg(const Arguments& a) {
    if (uevents_at(a[0])) return receive_uevent(a[0], a);
    std::uint32_t header[7];
    std::vector<Piece> pieces;
    if (!memory().read(a[1], header, sizeof header)) return -EFAULT;
    if (const std::int64_t error = pieces_at(header[2], header[3], pieces)) return error;
    return receive_from(a[0], std::move(pieces), a[2], header[0], a[1] + 4, a[1]);
}

// ---- Options ------------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_setsockopt(const Arguments& a) {
    if (UeventSocket* const uevents = uevents_at(a[0])) return set_uevents(*uevents, a);
    constexpr std::uint32_t LEVEL = 1, RECEIVE_LIMIT = 20, RECEIVE_LIMIT_64 = 66;
    int error;
    LinuxSocket* const socket = socket_at(a[0], error);
    if (!socket) return error;
    if (a[1] != LEVEL || (a[2] != RECEIVE_LIMIT && a[2] != RECEIVE_LIMIT_64)) return 0;
    std::int64_t time[2];
    std::int32_t narrow[2];
    if (a[2] == RECEIVE_LIMIT_64 ? !memory().read(a[3], time, sizeof time)
                                 : !memory().read(a[3], narrow, sizeof narrow))
        return -EFAULT;
    if (a[2] == RECEIVE_LIMIT) std::copy_n(narrow, 2, time);
    if (time[0] < 0 || time[1] < 0 || time[1] >= 1'000'000) return -EDOM;
    const auto seconds =
        static_cast<std::uint64_t>(std::min<std::int64_t>(time[0], LONGEST_NS / NS - 1));
    socket->receive_limit_ns = seconds * NS + static_cast<std::uint64_t>(time[1]) * 1000;
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_getsockopt(const Arguments& a) {
    constexpr std::uint32_t LEVEL = 1, TYPE = 3, ERROR = 4, SEND_ROOM = 7, RECEIVE_ROOM = 8;
    int error;
    std::uint32_t room;
    LinuxSocket* const socket = socket_at(a[0], error);
    if (!socket) return error;
    if (!memory().read(a[4], &room, sizeof room)) return -EFAULT;
    std::uint32_t value = 0;
    if (a[1] == LEVEL && a[2] == TYPE) value = socket->type();
    if (a[1] == LEVEL && a[2] == ERROR) value = static_cast<std::uint32_t>(socket->consume_error());
    if (a[1] == LEVEL && (a[2] == SEND_ROOM || a[2] == RECEIVE_ROOM)) value = 212992;
    room = std::min<std::uint32_t>(room, sizeof value);
    return memory().write(a[3], &value, room) && memory().write(a[4], &room, sizeof room) ? 0
                                                                                          : -EFAULT;
}

}  // namespace sim
