#include "sim/live/wire.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace sim::live {

namespace {

constexpr std::size_t HEAD = 5;  // length of the bytes, 4 bytes in this machine's order; the kind

}  // namespace

Wire::Wire(int descriptor) : descriptor_{descriptor} {
    fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) | O_NONBLOCK);
    fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

Wire::~Wire() { close(descriptor_); }

void Wire::send(Kind kind, std::string_view bytes) {
    if (gone_) return;
    const auto length = static_cast<std::uint32_t>(bytes.size());
    char head[HEAD];
    std::memcpy(head, &length, sizeof length);
    head[4] = static_cast<char>(kind);
    out_.append(head, HEAD);
    out_.append(bytes);
    flush();
}

bool Wire::flush() {
    while (sent_ < out_.size()) {
        const ssize_t done =
            ::send(descriptor_, out_.data() + sent_, out_.size() - sent_, MSG_NOSIGNAL);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0 && errno != EAGAIN && errno != EWOULDBLOCK) return false;
        if (done < 0) {  // the other side does not keep up: what it has read is of no use any more
            if (sent_ > (1u << 20)) {
                out_.erase(0, sent_);
                sent_ = 0;
            }
            return true;
        }
        sent_ += static_cast<std::size_t>(done);
    }
    out_.clear();
    sent_ = 0;
    return true;
}

bool Wire::fill() {
    char buffer[65536];
    for (;;) {
        const ssize_t got = recv(descriptor_, buffer, sizeof buffer, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
        if (got == 0) return false;
        in_.append(buffer, static_cast<std::size_t>(got));
    }
}

bool Wire::poll(int wait_ms) {
    if (gone_) return false;
    pollfd entry{descriptor_, static_cast<short>(POLLIN | (unsent() ? POLLOUT : 0)), 0};
    if (::poll(&entry, 1, wait_ms) > 0 && !(flush() && fill())) gone_ = true;
    return !gone_;
}

std::optional<Message> Wire::receive() {
    std::uint32_t length = 0;
    if (in_.size() - taken_ < HEAD) return {};
    std::memcpy(&length, in_.data() + taken_, sizeof length);
    if (in_.size() - taken_ < HEAD + length) return {};
    Message message{static_cast<Kind>(in_[taken_ + 4]), in_.substr(taken_ + HEAD, length)};
    taken_ += HEAD + length;
    if (taken_ == in_.size() || taken_ > (1u << 20)) {
        in_.erase(0, taken_);
        taken_ = 0;
    }
    return message;
}

}  // namespace sim::live
