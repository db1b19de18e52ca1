#include "sim/linux/host_sockets.h"

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::uint64_t LOOK_NS = 1'000'000, AFTER_NEWS_NS = 100'000;

sockaddr_in to_host(const SocketAddress& address) {
    sockaddr_in host{};
    host.sin_family = AF_INET;
    host.sin_port = htons(address.port);
    host.sin_addr.s_addr = htonl(address.ip);
    return host;
}

SocketAddress from_host(const sockaddr_in& host) {
    SocketAddress address;
    address.family = SocketAddress::INET;
    address.port = ntohs(host.sin_port);
    address.ip = ntohl(host.sin_addr.s_addr);
    return address;
}

std::int64_t or_errno(std::int64_t result) { return result < 0 ? -errno : result; }

}  // namespace

// ---- Names --------------------------------------------------------------------------------------

NamedPeer NamedPeer::from(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    std::uint16_t port = 0;
    if (colon != std::string::npos) {
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, port);
        if (error != std::errc{} || stop != end) port = 0;
    }
    if (colon == 0 || port == 0)
        throw std::runtime_error{
            fmt::format("--network: expected HOST:PORT, a port from 1 to 65535, got \"{}\"", text)};
    NamedPeer peer;
    peer.host = text.substr(0, colon);
    addrinfo asked{}, *found = nullptr;
    asked.ai_family = AF_INET;
    asked.ai_socktype = SOCK_STREAM;
    if (const int error = getaddrinfo(peer.host.c_str(), nullptr, &asked, &found))
        throw std::runtime_error{fmt::format("--network: {}: {}", peer.host, gai_strerror(error))};
    for (const addrinfo* one = found; one; one = one->ai_next) {
        peer.addresses.push_back(from_host(*reinterpret_cast<const sockaddr_in*>(one->ai_addr)));
        peer.addresses.back().port = port;
    }
    freeaddrinfo(found);
    return peer;
}

// ---- A socket -----------------------------------------------------------------------------------

HostSocket::HostSocket(bool stream)
    : stream_{stream},
      fd_{::socket(AF_INET, (stream ? SOCK_STREAM : SOCK_DGRAM) | SOCK_NONBLOCK | SOCK_CLOEXEC,
                   0)} {}

HostSocket::~HostSocket() {
    if (fd_ >= 0) ::close(fd_);
}

int HostSocket::connect(const SocketAddress& to) {
    const sockaddr_in address = to_host(to);
    const auto* const generic = reinterpret_cast<const sockaddr*>(&address);
    const auto result = static_cast<int>(or_errno(::connect(fd_, generic, sizeof address)));
    connects_ = result == -EINPROGRESS || result == -EALREADY;
    return result;
}

int HostSocket::shut_down(std::uint32_t how) {
    return static_cast<int>(or_errno(::shutdown(fd_, static_cast<int>(how))));
}

int HostSocket::consume_error() {
    int error = 0;
    socklen_t bytes = sizeof error;
    return ::getsockopt(fd_, SOL_SOCKET, SO_ERROR, &error, &bytes) == 0 ? error : errno;
}

unsigned HostSocket::can_do() const {
    pollfd entry{fd_, POLLIN | POLLOUT, 0};
    ::poll(&entry, 1, 0);
    return (entry.revents & POLLIN ? LinuxDevice::READ : 0) |
           (entry.revents & POLLOUT ? LinuxDevice::WRITE : 0) |
           (entry.revents & POLLHUP ? LinuxDevice::HUNG_UP : 0) |
           (entry.revents & POLLERR ? LinuxDevice::BROKEN : 0);
}

std::size_t HostSocket::readable() const {
    int bytes = 0;
    return ::ioctl(fd_, FIONREAD, &bytes) == 0 ? static_cast<std::size_t>(bytes) : 0;
}

std::int64_t HostSocket::send(const void* data, std::size_t bytes, const SocketAddress* to) {
    const sockaddr_in address = to ? to_host(*to) : sockaddr_in{};
    const auto* const generic = reinterpret_cast<const sockaddr*>(&address);
    const std::int64_t count = or_errno(::sendto(fd_, data, bytes, MSG_NOSIGNAL | MSG_DONTWAIT,
                                                 to ? generic : nullptr, to ? sizeof address : 0));
    lacks_room_ = count == -EAGAIN;
    return count;
}

std::pair<std::int64_t, std::int64_t> HostSocket::receive(void* data, std::size_t bytes, bool peek,
                                                          SocketAddress* from) {
    sockaddr_in sender{};
    socklen_t length = sizeof sender;
    const int flags = MSG_DONTWAIT | MSG_TRUNC | (peek ? MSG_PEEK : 0);
    const std::int64_t all =
        or_errno(::recvfrom(fd_, data, bytes, stream_ ? flags & ~MSG_TRUNC : flags,
                            reinterpret_cast<sockaddr*>(&sender), &length));
    if (all < 0) return {all, 0};
    if (from && !stream_) *from = from_host(sender);
    if (!peek) counted_ -= std::min(counted_, static_cast<std::size_t>(all));
    if (stream_ && all == 0 && bytes > 0) ended_ = true;
    return {std::min(all, static_cast<std::int64_t>(bytes)), all};
}

short HostSocket::awaits() const {
    return static_cast<short>((ended_ ? 0 : POLLIN) | (connects_ || lacks_room_ ? POLLOUT : 0));
}

bool HostSocket::seen(short events) {
    const std::size_t bytes = events & POLLIN ? readable() : 0;
    const bool over = (events & (POLLHUP | POLLERR)) || ((events & POLLIN) && bytes == 0);
    const bool news = bytes > counted_ || (events & POLLOUT) || (over && !over_);
    counted_ = bytes;
    over_ = over;
    if (events & POLLOUT) connects_ = lacks_room_ = false;
    arrivals_ += news;
    return news;
}

// ---- All of them --------------------------------------------------------------------------------

bool HostNetwork::has(const SocketAddress& address) const {
    const auto is_it = [&](const SocketAddress& one) {
        return one.ip == address.ip && one.port == address.port;
    };
    return address.family == SocketAddress::INET &&
           std::any_of(peers_.begin(), peers_.end(), [&](const NamedPeer& peer) {
               return std::any_of(peer.addresses.begin(), peer.addresses.end(), is_it);
           });
}

std::shared_ptr<HostSocket> HostNetwork::open(bool stream) {
    auto socket = std::make_shared<HostSocket>(stream);
    if (!socket->is_open()) return nullptr;
    sockets_.push_back(socket);
    return socket;
}

std::string HostNetwork::hosts() const {
    std::string text = "127.0.0.1\tlocalhost\n";
    for (const NamedPeer& peer : peers_)
        for (const SocketAddress& address : peer.addresses)
            if (peer.host != "localhost")
                text += fmt::format("{}.{}.{}.{}\t{}\n", address.ip >> 24, address.ip >> 16 & 0xFF,
                                    address.ip >> 8 & 0xFF, address.ip & 0xFF, peer.host);
    return text;
}

bool HostNetwork::is_used() const {
    return std::any_of(sockets_.begin(), sockets_.end(),
                       [](const auto& socket) { return !socket.expired(); });
}

bool HostNetwork::look(std::uint64_t now_ns, bool waits) {
    std::vector<std::shared_ptr<HostSocket>> open;
    std::vector<pollfd> entries;
    for (const auto& entry : sockets_)
        if (auto socket = entry.lock()) {
            const short events = socket->awaits();  // none once all is read: its end is known
            entries.push_back({events ? socket->fd_ : -1, events, 0});
            open.push_back(std::move(socket));
        }
    sockets_.assign(open.begin(), open.end());
    ::poll(entries.data(), entries.size(), waits ? 1 : 0);
    bool news = false;
    for (std::size_t i = 0; i < open.size(); ++i)
        if (entries[i].fd >= 0) news |= open[i]->seen(entries[i].revents);
    next_ns_ = now_ns + (news ? AFTER_NEWS_NS : LOOK_NS);
    return news;
}

}  // namespace sim
