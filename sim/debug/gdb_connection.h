// gdb_connection.h - a debugger at a TCP port of 127.0.0.1, one at a time.
//
// Debian has no library of the protocol's stub side: existing ones (QEMU's, Valgrind's, OpenOCD's)
// are parts of their programs.  The protocol is small; the socket is POSIX.
//
// Handles +, - and repetitions by itself.  After a connection fails or ends, connected() is false
// and the next debugger may connect.  An answer that is not received within 5 s ends the
// connection, too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/debug/gdb_packet.h"

namespace sim {

class GdbConnection {
public:
    // Listens; port 0 chooses a free one.  std::runtime_error with the port if it is not available.
    explicit GdbConnection(unsigned port);
    ~GdbConnection();
    GdbConnection(const GdbConnection&) = delete;
    GdbConnection& operator=(const GdbConnection&) = delete;

    unsigned port() const { return port_; }
    bool connected() const { return client_ >= 0; }

    // True if a debugger has connected within the time.
    bool accept(int wait_ms);
    // A packet, see text(), or INTERRUPT; no value if none came in time or the connection is lost.
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
