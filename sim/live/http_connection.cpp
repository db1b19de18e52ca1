#include "sim/live/http_connection.h"

namespace sim::live {

namespace beast = boost::beast;
namespace http = beast::http;

namespace {

constexpr std::size_t MOST_FILE = 64 << 20;

}  // namespace

HttpConnection::HttpConnection(boost::asio::ip::tcp::socket socket) : stream{std::move(socket)} {
    parser.body_limit(MOST_FILE);
}

void answer(const std::shared_ptr<HttpConnection>& connection, http::status status,
            std::string_view type, std::string_view body) {
    auto response = std::make_shared<http::response<http::string_body>>(status, 11);
    response->set(http::field::content_type, beast::string_view{type.data(), type.size()});
    response->set(http::field::cache_control, "no-store");
    response->set("X-Content-Type-Options", "nosniff");
    response->set("Referrer-Policy", "no-referrer");
    response->set("Content-Security-Policy",
                  "default-src 'self'; connect-src 'self' ws:; img-src data:");
    response->keep_alive(false);
    response->body() = std::string{body};
    response->prepare_payload();
    http::async_write(connection->stream, *response,
                      [connection, response](beast::error_code, std::size_t) {
                          beast::error_code ignored;
                          connection->stream.socket().shutdown(
                              boost::asio::ip::tcp::socket::shutdown_send, ignored);
                      });
}

std::string query(beast::string_view target, const std::string& name) {
    const std::string text{target};
    std::size_t at = text.find('?');
    while (at != std::string::npos) {
        const std::size_t next = text.find('&', at + 1);
        const std::string pair =
            text.substr(at + 1, next == std::string::npos ? next : next - at - 1);
        if (pair.compare(0, name.size() + 1, name + "=") == 0) return pair.substr(name.size() + 1);
        at = next;
    }
    return {};
}

}  // namespace sim::live
