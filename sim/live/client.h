// client.h - one WebSocket client of the server: what it is sent, and what is left out for it.
//
// Texts are kept until it reads them, up to a limit; sound and pictures only while it keeps up.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "sim/live/picture_store.h"

namespace sim::live {

class Client : public std::enable_shared_from_this<Client> {
public:
    using Request = boost::beast::http::request<boost::beast::http::string_body>;
    using Take = std::function<void(Client&, const std::string&)>;

    // `take` gets each text that arrives, `closed` is called once, when the client is gone.
    Client(boost::asio::ip::tcp::socket socket, const PictureStore& pictures, Take take,
           std::function<void(Client&)> closed);

    // Answers the upgrade; then `greeting` is asked for the first texts, which no other is lost
    // after.
    void accept(const Request& request, std::function<std::deque<std::string>()> greeting);

    void send_text(const std::string& text);
    void send_sound(const std::string& message);  // with its kind in front
    void send_picture();                          // what it has not seen yet, if it keeps up
    void close(const std::string& why);
    // From now on it has all of the sound, or is disconnected where that gets too much.
    void leave_nothing_out() { keeps_all_ = true; }
    void forget_pictures() { seen_ = 0; }

private:
    struct Outgoing {
        std::string bytes;
        bool binary;
    };

    void push(std::string bytes, bool binary);
    void write();
    void read();
    void gone();

    boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
    const PictureStore& pictures_;
    const Take take_;
    std::function<void(Client&)> closed_;
    boost::beast::flat_buffer incoming_;
    std::deque<Outgoing> outgoing_;
    std::size_t unsent_ = 0;  // bytes
    std::uint64_t seen_ = 0;  // version of the picture
    bool open_ = false, closing_ = false, keeps_all_ = false;
};

}  // namespace sim::live
