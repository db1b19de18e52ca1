// host_sockets.h - sockets of this machine, by which a Linux program reaches what --network names.
//
// A connection or datagrams to one of the named addresses go over the host's network; all others
// stay within the run.  Such a run depends on the wall clock and on who answers.  While it has such
// a socket and all threads wait, simulated time goes no faster than the clock of the host.
//
// Not handled: IPv6, listening for connections from outside, options of the sockets, urgent data,
// addresses of the program's own end, which are the run's.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/sockets.h"

namespace sim {

// "host:port" of --network, and its addresses.
struct NamedPeer {
    std::string host;
    std::vector<SocketAddress> addresses;

    // std::runtime_error: it has another form, or the host's resolver does not know the name.
    static NamedPeer from(const std::string& text);
};

// Results are minus the error, EAGAIN or EINPROGRESS where it would have to wait.
class HostSocket {
public:
    explicit HostSocket(bool stream);
    ~HostSocket();
    HostSocket(const HostSocket&) = delete;

    bool is_open() const { return fd_ >= 0; }  // the host had one left
    int connect(const SocketAddress& to);      // again: whether it is there; EALREADY, EISCONN
    int shut_down(std::uint32_t how);
    int consume_error();
    unsigned can_do() const;  // as LinuxDevice's
    std::size_t readable() const;
    std::uint64_t arrivals() const { return arrivals_; }
    std::int64_t send(const void* data, std::size_t bytes, const SocketAddress* to);
    // The bytes of a datagram, also if they did not all fit, and its sender.
    std::pair<std::int64_t, std::int64_t> receive(void* data, std::size_t bytes, bool peek,
                                                  SocketAddress* from);

private:
    friend class HostNetwork;
    short awaits() const;     // of poll(), on the host
    bool seen(short events);  // whether that is of use to a program

    const bool stream_;
    const int fd_;
    bool connects_ = false, lacks_room_ = false;
    bool ended_ = false;       // and that has been read
    bool over_ = false;        // hung up, broken or at its end, which has been reported
    std::size_t counted_ = 0;  // bytes that arrivals_ has reported
    std::uint64_t arrivals_ = 0;
};

class HostNetwork {
public:
    static constexpr std::uint64_t NEVER = ~std::uint64_t{0};

    explicit HostNetwork(std::vector<NamedPeer> peers) : peers_{std::move(peers)} {}

    bool exists() const { return !peers_.empty(); }
    bool has(const SocketAddress& address) const;
    std::shared_ptr<HostSocket> open(bool stream);
    std::string hosts() const;  // /etc/hosts

    bool is_used() const;
    // When to look again, in the time of the processor; NEVER while there is no socket.
    std::uint64_t next_ns() const { return is_used() ? next_ns_ : NEVER; }
    // Whether something has come.  `waits`: for up to 1 ms of the host's clock, if nothing has.
    bool look(std::uint64_t now_ns, bool waits);

private:
    const std::vector<NamedPeer> peers_;
    std::vector<std::weak_ptr<HostSocket>> sockets_;
    std::uint64_t next_ns_ = 0;
};

}  // namespace sim
