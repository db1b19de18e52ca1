// http_connection.h - a request to the server, and what it is answered.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

namespace sim::live {

struct HttpConnection {
    explicit HttpConnection(boost::asio::ip::tcp::socket socket);

    boost::beast::tcp_stream stream;
    boost::beast::flat_buffer buffer;
    boost::beast::http::request_parser<boost::beast::http::string_body> parser;
};

// Sends it, and then ends the connection.
void answer(const std::shared_ptr<HttpConnection>& connection, boost::beast::http::status status,
            std::string_view type, std::string_view body);

// The value of a name in "/ws?token=...&x=..."; values are not decoded.
std::string query(boost::beast::string_view target, const std::string& name);

}  // namespace sim::live
