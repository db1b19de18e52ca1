#include "sim/live/listener.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace sim::live {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr auto NO_ROOM_TIME = std::chrono::milliseconds{200};  // until another connection is tried

}  // namespace

Listener::Listener(asio::io_context& io, const std::string& address, unsigned port)
    : address_{address}, acceptor_{io}, room_{io} {
    boost::system::error_code error;
    const auto parsed = asio::ip::make_address(address, error);
    if (error)
        throw std::runtime_error{"--listen: expected an address such as 0.0.0.0, got " + address};
    const tcp::endpoint here{parsed, static_cast<unsigned short>(port)};
    acceptor_.open(here.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address{true}, error);
    if (!error) acceptor_.bind(here, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (error)
        throw std::runtime_error{
            fmt::format("cannot listen at {}:{}: {}", address, port, error.message())};
}

void Listener::accept(const std::function<void(tcp::socket)>& connected) {
    acceptor_.async_accept([this, connected](boost::system::error_code error, tcp::socket socket) {
        if (!error) {
            boost::system::error_code ignored;
            socket.set_option(tcp::no_delay{true}, ignored);
            connected(std::move(socket));
            return accept(connected);
        }
        room_.expires_after(NO_ROOM_TIME);
        room_.async_wait([this, connected](boost::system::error_code) { accept(connected); });
    });
}

std::vector<std::string> Listener::hosts() const {
    const auto here = acceptor_.local_endpoint();
    std::vector<std::string> names{fmt::format("{}:{}", address_, here.port())};
    if (here.address().is_loopback()) names.push_back(fmt::format("localhost:{}", here.port()));
    return names;
}

bool Listener::is_own_host(const std::string& host) const {
    if (!acceptor_.local_endpoint().address().is_loopback()) return true;
    const auto names = hosts();
    return std::find(names.begin(), names.end(), host) != names.end();
}

}  // namespace sim::live
