// sockets.h - sockets between the processes of a run: AF_UNIX and AF_INET, streams and datagrams.
//
// All lies on the loopback: a connection is there at once, nothing is lost but datagrams for which
// there is no more room, and nothing leaves the simulator but to what --network names
// (host_sockets.h).  Ports that nobody has asked for are given in turn, from 32768 on, so every run
// is the same.
//
// Not handled: AF_INET6 and others, raw sockets, multicast, out-of-band data, passing of files and
// credentials; options are taken, and only SO_RCVTIMEO, SO_ERROR and SO_TYPE do something.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/pipes.h"

namespace sim {

struct SocketAddress {
    static constexpr std::uint16_t UNIX = 1, INET = 2;

    std::uint16_t family = 0, port = 0;  // in this machine's order
    std::uint32_t ip = 0;                // likewise
    std::string path{};                  // of UNIX; one that begins with 0 is no file's

    // struct sockaddr; no value: it is none.
    static std::optional<SocketAddress> from(const std::vector<std::uint8_t>& bytes);
    std::vector<std::uint8_t> bytes() const;
    bool is_here() const;  // on the loopback
    std::string text() const;
};

class HostNetwork;
class HostSocket;
class LinuxSocket;

// Who has which address.
class LinuxNetwork {
public:
    explicit LinuxNetwork(HostNetwork& host) : host_{host} {}

    HostNetwork& host() const { return host_; }
    // EADDRINUSE; a port 0 becomes a free one.
    int bind(const std::shared_ptr<LinuxSocket>& socket, SocketAddress& address);
    std::shared_ptr<LinuxSocket> find(bool stream, const SocketAddress& address) const;
    bool has_path(const std::string& path) const;
    bool remove_path(const std::string& path);

private:
    using Key = std::pair<bool, std::string>;  // a stream's or not
    static Key key(bool stream, const SocketAddress& address);

    HostNetwork& host_;
    std::map<Key, std::weak_ptr<LinuxSocket>> bound_;
    std::uint16_t next_port_ = 32768;
};

class LinuxSocket final : public LinuxDevice, public std::enable_shared_from_this<LinuxSocket> {
public:
    static constexpr unsigned STREAM = 1, DATAGRAM = 2, PACKETS = 5;

    LinuxSocket(LinuxNetwork& network, std::uint16_t family, unsigned type);
    ~LinuxSocket() override;
    static void connect_pair(LinuxSocket& a, LinuxSocket& b);

    FileStatus status() const override;
    std::string name() const override;
    bool is_inside() const override { return !host_; }
    unsigned can_do() const override;
    std::uint64_t arrivals() const override;
    std::int64_t read(void* data, std::size_t bytes) override {
        return receive(data, bytes, false, nullptr).first;
    }
    std::int64_t write(const void* data, std::size_t bytes) override {
        return send(data, bytes, nullptr);
    }
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override;

    int bind(SocketAddress address);
    int listen(std::uint32_t backlog);
    // EINPROGRESS, and then EALREADY, while the host connects.
    int connect(const SocketAddress& to);
    std::pair<int, std::shared_ptr<LinuxSocket>> accept();
    int shut_down(std::uint32_t how);
    // The bytes of a datagram, also if they did not all fit.
    std::pair<std::int64_t, std::int64_t> receive(void* data, std::size_t bytes, bool peek,
                                                  SocketAddress* from);
    std::int64_t send(const void* data, std::size_t bytes, const SocketAddress* to);

    const SocketAddress& address() const { return own_; }
    const std::optional<SocketAddress>& peer() const { return peer_; }
    unsigned type() const { return type_; }
    std::uint16_t family() const { return family_; }
    int consume_error();

    std::uint64_t receive_limit_ns = 0;  // SO_RCVTIMEO; 0: none

private:
    static constexpr std::size_t ROOM = 212992;  // bytes of datagrams

    struct Message {
        SocketAddress from;
        std::vector<std::uint8_t> bytes;
    };
    bool by_messages() const { return type_ != STREAM; }
    void bind_somewhere();
    int connect_outside(const SocketAddress& to);
    std::pair<std::int64_t, std::int64_t> receive_outside(void* data, std::size_t bytes, bool peek,
                                                          SocketAddress* from);

    LinuxNetwork& network_;
    const std::uint16_t family_;
    const unsigned type_;
    SocketAddress own_;
    std::optional<SocketAddress> peer_;
    std::shared_ptr<BytePipe> in_, out_;  // of a connected stream
    std::uint64_t arrivals_ = 0;          // of connections and messages
    std::shared_ptr<HostSocket> host_;    // of one that reaches the outside
    std::weak_ptr<LinuxSocket> other_;    // of one that is connected and has messages
    std::deque<std::shared_ptr<LinuxSocket>> waiting_;
    std::size_t backlog_ = 0;
    bool listens_ = false, bound_ = false, had_other_ = false;
    std::deque<Message> messages_;
    std::size_t held_ = 0;  // bytes of these
    int error_ = 0;
};

}  // namespace sim
