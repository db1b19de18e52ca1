#include "sim/live/client.h"

#include "sim/live/wire.h"

namespace sim::live {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

namespace {

constexpr std::size_t MOST_INCOMING = 64 << 10, MOST_TEXT = 4 << 20, MOST_SOUND = 256 << 10,
                      MOST_OF_ALL = 64 << 20;

}  // namespace

Client::Client(boost::asio::ip::tcp::socket socket, const PictureStore& pictures, Take take,
               std::function<void(Client&)> closed)
    : stream_{std::move(socket)},
      pictures_{pictures},
      take_{std::move(take)},
      closed_{std::move(closed)} {}

void Client::accept(const Request& request, std::function<std::deque<std::string>()> greeting) {
    websocket::permessage_deflate deflate;  // pictures of few colours shrink to a few percent
    deflate.server_enable = true;
    deflate.compLevel = 1;
    deflate.memLevel = 8;
    stream_.set_option(deflate);
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.read_message_max(MOST_INCOMING);
    stream_.async_accept(request, [self = shared_from_this(),
                                   greeting = std::move(greeting)](beast::error_code error) {
        if (error) return self->gone();
        self->open_ = true;
        for (const std::string& text : greeting()) self->send_text(text);
        self->send_picture();
        self->read();
    });
}

void Client::send_text(const std::string& text) {
    if (unsent_ > (keeps_all_ ? MOST_OF_ALL : MOST_TEXT))
        return close(keeps_all_ ? "too slow: 64 MiB are unread"
                                : "too slow: 4 MiB of text are unread");
    push(text, false);
}

void Client::send_sound(const std::string& message) {
    if (keeps_all_ || unsent_ <= MOST_SOUND) push(message, true);
}

void Client::send_picture() {
    if (!outgoing_.empty() || seen_ == pictures_.version()) return;
    std::string message = pictures_.since(seen_);
    seen_ = pictures_.version();
    push(std::move(message), true);
}

void Client::close(const std::string& why) {
    if (!open_ || closing_) return;
    closing_ = true;
    stream_.async_close({websocket::close_code::policy_error, why},
                        [self = shared_from_this()](beast::error_code) { self->gone(); });
}

void Client::push(std::string bytes, bool binary) {
    if (!open_ || closing_) return;
    unsent_ += bytes.size();
    outgoing_.push_back({std::move(bytes), binary});
    if (outgoing_.size() == 1) write();
}

void Client::write() {
    stream_.binary(outgoing_.front().binary);
    stream_.async_write(boost::asio::buffer(outgoing_.front().bytes),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                            if (error) return self->gone();
                            self->unsent_ -= self->outgoing_.front().bytes.size();
                            self->outgoing_.pop_front();
                            if (!self->outgoing_.empty())
                                self->write();
                            else
                                self->send_picture();
                        });
}

void Client::read() {
    stream_.async_read(
        incoming_, [self = shared_from_this()](beast::error_code error, std::size_t) {
            if (error) return self->gone();
            const std::string text = beast::buffers_to_string(self->incoming_.data());
            self->incoming_.consume(self->incoming_.size());
            if (self->stream_.got_text())
                self->take_(*self, text);
            else
                self->send_text("{\"error\": \"expected a text in JSON, got a binary message\"}");
            self->read();
        });
}

void Client::gone() {
    open_ = false;
    if (const auto closed = std::exchange(closed_, {})) closed(*this);
}

}  // namespace sim::live
