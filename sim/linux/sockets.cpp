#include "sim/linux/sockets.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/host_sockets.h"

namespace sim {

namespace {

constexpr std::size_t INET_BYTES = 16, PATH_BYTES = 108;
constexpr std::uint32_t LOOPBACK = 127;

}  // namespace

// ---- Addresses ----------------------------------------------------------------------------------

std::optional<SocketAddress> SocketAddress::from(const std::vector<std::uint8_t>& bytes) {
    if (bytes.size() < 2) return std::nullopt;
    SocketAddress address;
    address.family = static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
    if (address.family == INET) {
        if (bytes.size() < INET_BYTES) return std::nullopt;
        address.port = static_cast<std::uint16_t>(bytes[2] << 8 | bytes[3]);
        for (unsigned i = 4; i < 8; ++i) address.ip = address.ip << 8 | bytes[i];
    } else if (address.family == UNIX) {
        if (bytes.size() > 2 + PATH_BYTES) return std::nullopt;
        address.path.assign(bytes.begin() + 2, bytes.end());
        if (!address.path.empty() && address.path[0] != '\0') address.path = address.path.c_str();
    }
    return address;
}

std::vector<std::uint8_t> SocketAddress::bytes() const {
    std::vector<std::uint8_t> all;
    all.reserve(2 + PATH_BYTES);
    all.push_back(static_cast<std::uint8_t>(family));
    all.push_back(static_cast<std::uint8_t>(family >> 8));
    if (family == INET) {
        all.resize(INET_BYTES);
        all[2] = static_cast<std::uint8_t>(port >> 8);
        all[3] = static_cast<std::uint8_t>(port);
        for (unsigned i = 0; i < 4; ++i) all[4 + i] = static_cast<std::uint8_t>(ip >> (24 - 8 * i));
    } else if (!path.empty()) {
        for (const char c : path) all.push_back(static_cast<std::uint8_t>(c));
        if (path[0] != '\0') all.push_back(0);
    }
    return all;
}

bool SocketAddress::is_here() const { return family == UNIX || ip == 0 || ip >> 24 == LOOPBACK; }

std::string SocketAddress::text() const {
    if (family == UNIX) return path;
    return fmt::format("{}.{}.{}.{}:{}", ip >> 24, ip >> 16 & 0xFF, ip >> 8 & 0xFF, ip & 0xFF,
                       port);
}

LinuxNetwork::Key LinuxNetwork::key(bool stream, const SocketAddress& address) {
    return {stream, address.family == SocketAddress::UNIX ? "p" + address.path
                                                          : std::to_string(address.port)};
}

int LinuxNetwork::bind(const std::shared_ptr<LinuxSocket>& socket, SocketAddress& address) {
    const bool stream = socket->type() == LinuxSocket::STREAM;
    if (address.family == SocketAddress::INET && address.port == 0) {
        do {
            address.port = next_port_;
            next_port_ = next_port_ == 60999 ? std::uint16_t{32768}
                                             : static_cast<std::uint16_t>(next_port_ + 1);
        } while (find(stream, address));
    }
    if (find(stream, address)) return -EADDRINUSE;
    bound_[key(stream, address)] = socket;
    return 0;
}

std::shared_ptr<LinuxSocket> LinuxNetwork::find(bool stream, const SocketAddress& address) const {
    const auto found = bound_.find(key(stream, address));
    return found == bound_.end() ? nullptr : found->second.lock();
}

bool LinuxNetwork::has_path(const std::string& path) const {
    return bound_.count({true, "p" + path}) > 0 || bound_.count({false, "p" + path}) > 0;
}

bool LinuxNetwork::remove_path(const std::string& path) {
    return bound_.erase({true, "p" + path}) + bound_.erase({false, "p" + path}) > 0;
}

// ---- A socket -----------------------------------------------------------------------------------

LinuxSocket::LinuxSocket(LinuxNetwork& network, std::uint16_t family, unsigned type)
    : network_{network}, family_{family}, type_{type} {
    own_.family = family;
}

LinuxSocket::~LinuxSocket() {
    if (in_) in_->has_reader = false;
    if (out_) out_->has_writer = false;
}

void LinuxSocket::connect_pair(LinuxSocket& a, LinuxSocket& b) {
    a.peer_ = b.own_;
    b.peer_ = a.own_;
    if (a.by_messages()) {
        a.other_ = b.weak_from_this();
        b.other_ = a.weak_from_this();
        a.had_other_ = b.had_other_ = true;
        return;
    }
    a.in_ = b.out_ = std::make_shared<BytePipe>();
    a.out_ = b.in_ = std::make_shared<BytePipe>();
}

FileStatus LinuxSocket::status() const { return {S_IFSOCK | 0777, 0, 1, 0}; }

std::string LinuxSocket::name() const {
    if (listens_) return fmt::format("a connection to {}", own_.text());
    if (host_ && peer_) return fmt::format("an answer of {}", peer_->text());
    return own_.text().empty() ? "a socket" : fmt::format("the socket of {}", own_.text());
}

std::uint64_t LinuxSocket::arrivals() const {
    return arrivals_ + (host_ ? host_->arrivals() : in_ ? in_->writes() + out_->rooms() : 0);
}

int LinuxSocket::consume_error() {
    return host_ && error_ == 0 ? host_->consume_error() : std::exchange(error_, 0);
}

unsigned LinuxSocket::can_do() const {
    if (listens_) return waiting_.empty() ? 0 : READ;
    if (host_) return host_->can_do() | (messages_.empty() && error_ == 0 ? 0 : READ);
    if (by_messages()) return (messages_.empty() && error_ == 0 ? 0 : READ) | WRITE;
    if (!in_) return WRITE | HUNG_UP;
    const bool over = !in_->has_writer && !out_->has_reader;
    return (in_->can_do() & READ) | (out_->can_do() & WRITE) | (over ? HUNG_UP : 0);
}

std::int64_t LinuxSocket::control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) {
    if (request != arm_ioctl::READABLE) return -ENOTTY;
    const std::size_t count = !messages_.empty() ? messages_.front().bytes.size()
                              : host_            ? host_->readable()
                              : in_              ? in_->size()
                                                 : 0;
    const auto word = static_cast<std::uint32_t>(count);
    return memory.write(at, &word, sizeof word) ? 0 : -EFAULT;
}

int LinuxSocket::bind(SocketAddress address) {
    if (address.family != family_) return -EAFNOSUPPORT;
    if (bound_) return -EINVAL;
    if (!address.is_here()) return -EADDRNOTAVAIL;
    if (const int error = network_.bind(shared_from_this(), address)) return error;
    own_ = address;
    bound_ = true;
    return 0;
}

void LinuxSocket::bind_somewhere() {
    if (bound_ || family_ != SocketAddress::INET) return;
    SocketAddress any;
    any.family = SocketAddress::INET;
    bind(any);
}

int LinuxSocket::listen(std::uint32_t backlog) {
    if (type_ == DATAGRAM) return -EOPNOTSUPP;
    if (in_ || host_) return -EINVAL;
    bind_somewhere();
    backlog_ = std::clamp<std::uint32_t>(backlog, 1, 128);
    listens_ = true;
    return 0;
}

int LinuxSocket::connect_outside(const SocketAddress& to) {
    if (in_) return -EISCONN;
    if (listens_) return -EINVAL;
    if (!host_) host_ = network_.host().open(type_ == STREAM);
    if (!host_) return -ENOBUFS;
    bind_somewhere();
    const int result = host_->connect(to);
    if (result == 0 || result == -EINPROGRESS) peer_ = to;
    return result;
}

int LinuxSocket::connect(const SocketAddress& to) {
    if (to.family != family_) return -EAFNOSUPPORT;
    if (network_.host().has(to)) return connect_outside(to);
    host_.reset();
    if (type_ == DATAGRAM) {
        bind_somewhere();
        peer_ = to;
        return 0;
    }
    if (in_ || had_other_) return -EISCONN;
    if (listens_) return -EINVAL;
    const auto listener = network_.find(type_ == STREAM, to);
    if (!listener || !listener->listens_)
        return !listener && family_ == SocketAddress::UNIX ? -ENOENT : -ECONNREFUSED;
    if (listener->waiting_.size() > listener->backlog_) return -EAGAIN;
    bind_somewhere();
    const auto served = std::make_shared<LinuxSocket>(network_, family_, type_);
    served->own_ = listener->own_;
    served->bound_ = true;
    connect_pair(*this, *served);
    listener->waiting_.push_back(served);
    ++listener->arrivals_;
    return 0;
}

std::pair<int, std::shared_ptr<LinuxSocket>> LinuxSocket::accept() {
    if (!listens_) return {-EINVAL, nullptr};
    if (waiting_.empty()) return {-EAGAIN, nullptr};
    auto served = waiting_.front();
    waiting_.pop_front();
    return {0, served};
}

int LinuxSocket::shut_down(std::uint32_t how) {
    constexpr std::uint32_t READING = 0, WRITING = 1, BOTH = 2;
    if (how > BOTH) return -EINVAL;
    if (host_) return host_->shut_down(how);
    if (!in_) return had_other_ || peer_ ? 0 : -ENOTCONN;
    if (how == READING || how == BOTH) in_->has_reader = in_->has_writer = false;
    if (how == WRITING || how == BOTH) out_->has_writer = false;
    return 0;
}

std::pair<std::int64_t, std::int64_t> LinuxSocket::receive(void* data, std::size_t bytes, bool peek,
                                                           SocketAddress* from) {
    if (from && peer_) *from = *peer_;
    if (!by_messages() && host_) return host_->receive(data, bytes, peek, nullptr);
    if (!by_messages()) {
        const std::int64_t count = in_ ? in_->read(data, bytes, peek) : -ENOTCONN;
        return {count, count};
    }
    if (messages_.empty()) {
        if (error_ != 0) return {-consume_error(), 0};
        if (host_) return receive_outside(data, bytes, peek, from);
        const bool over = type_ == PACKETS && had_other_ && other_.expired();
        return {over ? 0 : -EAGAIN, 0};
    }
    Message& message = messages_.front();
    const std::size_t count = std::min(bytes, message.bytes.size());
    const auto all = static_cast<std::int64_t>(message.bytes.size());
    std::memcpy(data, message.bytes.data(), count);
    if (from) *from = message.from;
    if (!peek) {
        held_ -= message.bytes.size();
        messages_.pop_front();
    }
    return {static_cast<std::int64_t>(count), all};
}

// Of datagrams only those from who is named.
std::pair<std::int64_t, std::int64_t> LinuxSocket::receive_outside(void* data, std::size_t bytes,
                                                                   bool peek, SocketAddress* from) {
    for (;;) {
        SocketAddress sender;
        const auto result = host_->receive(data, bytes, peek, &sender);
        if (result.first < 0 || network_.host().has(sender)) {
            if (from) *from = sender;
            return result;
        }
        if (peek) host_->receive(nullptr, 0, false, nullptr);
    }
}

std::int64_t LinuxSocket::send(const void* data, std::size_t bytes, const SocketAddress* to) {
    constexpr std::size_t LONGEST = 65507;  // of UDP
    if (!by_messages() && host_) return host_->send(data, bytes, nullptr);
    if (!by_messages()) {
        if (!out_) return listens_ || !peer_ ? -ENOTCONN : -EPIPE;
        return out_->has_writer ? out_->write(data, bytes) : -EPIPE;
    }
    if (error_ != 0) return -consume_error();
    std::shared_ptr<LinuxSocket> other = other_.lock();
    if (had_other_ && !other) return type_ == PACKETS ? -EPIPE : -ECONNREFUSED;
    if (!other) {
        const SocketAddress* const where = to ? to : peer_ ? &*peer_ : nullptr;
        if (!where) return -EDESTADDRREQ;
        if (where->family != family_) return -EAFNOSUPPORT;
        bind_somewhere();
        if (network_.host().has(*where)) {
            if (!host_) host_ = network_.host().open(false);
            return host_ ? host_->send(data, bytes, to) : -ENOBUFS;
        }
        other = network_.find(false, *where);
    }
    if (bytes > LONGEST) return -EMSGSIZE;
    const bool is_unix = family_ == SocketAddress::UNIX;
    if (!other) {
        if (is_unix) return -ECONNREFUSED;
        if (!to) error_ = ECONNREFUSED;  // reported with the next call, as by ICMP
        return static_cast<std::int64_t>(bytes);
    }
    // A connected one takes only what its peer sends.
    const bool expected = is_unix || !other->peer_ || other->peer_->port == own_.port;
    const bool room = other->held_ + bytes <= ROOM && other->messages_.size() < 1024;
    if (!room && is_unix) return -EAGAIN;
    if (!room || !expected) return static_cast<std::int64_t>(bytes);
    SocketAddress own = own_;
    if (!is_unix && own.ip == 0) own.ip = LOOPBACK << 24 | 1;
    const auto* const begin = static_cast<const std::uint8_t*>(data);
    other->messages_.push_back({own, {begin, begin + bytes}});
    ++other->arrivals_;
    other->held_ += bytes;
    return static_cast<std::int64_t>(bytes);
}

}  // namespace sim
