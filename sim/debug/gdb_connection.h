// gdb_connection.h - a debugger at a TCP port of 127.0.0.1, one at a time.
//
// Debian has no library of the protocol's stub side: what there is (QEMU's, Valgrind's, OpenOCD's)
// is a part of its program.  The protocol is small; the socket is POSIX.
//
// Answers + and - and repeats by itself.  A connection that fails or ends is not connected() any
// more, and the next debugger may come.  An answer that is not taken within 5 s ends it, too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/debug/gdb_packet.h"

namespace sim {

class GdbConnection {
public:
    // Listens; port 0 takes a free one.  std::runtime_error with the port if it cannot be had.
    explicit GdbConnection(unsigned port);
    ~GdbConnection();
    GdbConnection(const GdbConnection&) = delete;
    GdbConnection& operator=(const GdbConnection&) = delete;

    unsigned port() const { return port_; }
    bool connected() const { return client_ >= 0; }

    // True when somebody has come within the time.
    bool accept(int wait_ms);
    // A packet, see text(), or INTERRUPT; nothing within the time, or the connection is lost.
    std::optional<GdbEvent> receive(int wait_ms);
    const std::string& text() const { return reader_.text(); }

    void send(std::string_view text);
    void no_acks() { acks_ = false; }
    void drop();

private:
    void send_raw(std::string_view bytes);

    int listener_ = -1, client_ = -1;
    unsigned port_ = 0;
    bool acks_ = true;
    GdbPacketReader reader_;
    std::string received_;  // and not yet read
    std::string last_;      // packet that was sent
};

}  // namespace sim
