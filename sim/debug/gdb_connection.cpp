#include "sim/debug/gdb_connection.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

namespace sim {

namespace {

bool readable(int file, int wait_ms) {
    pollfd entry{file, POLLIN, 0};
    return poll(&entry, 1, wait_ms) > 0;
}

}  // namespace

GdbConnection::GdbConnection(unsigned port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    socklen_t size = sizeof address;
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    const int yes = 1;
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (listener_ < 0 || setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) < 0 ||
        bind(listener_, generic, size) < 0 || listen(listener_, 1) < 0 ||
        getsockname(listener_, generic, &size) < 0) {
        const int error = errno;
        if (listener_ >= 0) close(listener_);
        throw std::runtime_error{
            fmt::format("--gdb: cannot listen at 127.0.0.1:{}: {}", port, std::strerror(error))};
    }
    port_ = ntohs(address.sin_port);
}

GdbConnection::~GdbConnection() {
    drop();
    close(listener_);
}

bool GdbConnection::accept(int wait_ms) {
    if (!readable(listener_, wait_ms)) return false;
    client_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client_ < 0) return false;
    const int yes = 1;
    const timeval longest{5, 0};
    setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    setsockopt(client_, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest);
    acks_ = true;
    reader_ = {};
    received_.clear();
    last_.clear();
    return true;
}

void GdbConnection::drop() {
    if (client_ >= 0) close(client_);
    client_ = -1;
}

std::optional<GdbEvent> GdbConnection::receive(int wait_ms) {
    while (connected()) {
        for (std::size_t i = 0; i < received_.size(); ++i) {
            const auto event = reader_.feed(received_[i]);
            if (!event) continue;
            received_.erase(0, i + 1);
            if (event == GdbEvent::INTERRUPT) return event;
            if (event == GdbEvent::REPEAT) send_raw(last_);
            if (event == GdbEvent::CORRUPT && acks_) send_raw("-");
            if (event == GdbEvent::PACKET) {
                if (acks_) send_raw("+");
                return event;
            }
            i = static_cast<std::size_t>(-1);  // from the new beginning
        }
        received_.clear();
        if (!connected() || !readable(client_, wait_ms)) break;
        char bytes[4096];
        const ssize_t count = recv(client_, bytes, sizeof bytes, 0);
        if (count > 0)
            received_.assign(bytes, static_cast<std::size_t>(count));
        else if (count == 0 || errno != EINTR)
            drop();
    }
    return std::nullopt;
}

void GdbConnection::send(std::string_view text) {
    last_ = gdb_packet(text);
    send_raw(last_);
}

void GdbConnection::send_raw(std::string_view bytes) {
    while (connected() && !bytes.empty()) {
        const ssize_t count = ::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count > 0)
            bytes.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            drop();
    }
}

}  // namespace sim
