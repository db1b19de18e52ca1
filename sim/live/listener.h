// listener.h - the server's TCP port: who connects, and by which names the server goes
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <boost/asio.hpp>

namespace sim::live {

class Listener {
public:
    // Port 0 takes a free one.  std::runtime_error: no address, or the port is taken.
    Listener(boost::asio::io_context& io, const std::string& address, unsigned port);

    // Each connection that comes, from now on.  Where no descriptor is left for one it waits.
    void accept(const std::function<void(boost::asio::ip::tcp::socket)>& connected);

    // HOST:PORT as a browser on this machine, or in the network, names this server.
    std::vector<std::string> hosts() const;
    // Of a server that listens to the network any name is its own.
    bool is_own_host(const std::string& host) const;

private:
    const std::string address_;
    boost::asio::ip::tcp::acceptor acceptor_;
    boost::asio::steady_timer room_;
};

}  // namespace sim::live
