#include "sim/live/server.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>

#include <boost/asio.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/files/whole_file.h"
#include "sim/live/client.h"
#include "sim/live/greeting.h"
#include "sim/live/http_connection.h"
#include "sim/live/listener.h"
#include "sim/live/page_files.h"
#include "sim/live/simulation.h"
#include "sim/report/exit_code.h"
#include "sim/text/messages.h"

namespace sim::live {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

namespace {

constexpr unsigned PROTOCOL = 1;
constexpr std::size_t MOST_CLIENTS = 16;
constexpr auto HTTP_TIME = std::chrono::seconds{30};

std::string new_token() {
    std::random_device random;
    std::string token;
    for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
    return token;
}

std::string json_text(const nlohmann::json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

class Server {
public:
    explicit Server(const ServerSettings& settings)
        : settings_{settings},
          run_{settings.run},
          listener_{io_, settings.address, settings.port},
          signals_{io_, SIGINT, SIGTERM} {
        const auto temporary = std::filesystem::temp_directory_path();
        std::string folder = temporary / "de1sim-live-XXXXXX";
        if (!mkdtemp(folder.data()))
            throw std::runtime_error{fmt::format("no folder for dropped files in {}: {}",
                                                 temporary.string(), std::strerror(errno))};
        folder_ = folder;
        struct sigaction hang_up {};
        sigaction(SIGHUP, nullptr, &hang_up);
        if (hang_up.sa_handler != SIG_IGN) signals_.add(SIGHUP);  // nohup
    }
    ~Server() {
        std::error_code error;
        std::filesystem::remove_all(folder_, error);
    }

    std::string url() const {
        return fmt::format("http://{}/?token={}", listener_.hosts().front(), token_);
    }

    // The exit code of the simulation that was the last.
    int run() {
        power_on();
        listener_.accept([this](tcp::socket socket) {
            read(std::make_shared<HttpConnection>(std::move(socket)));
        });
        signals_.async_wait([this](beast::error_code, int) { io_.stop(); });
        io_.run();
        return simulation_ ? simulation_->end() : WRONG_INPUT;
    }

private:
    // ---- The simulation ----

    void power_on() {
        simulation_.reset();
        wire_ready_.reset();
        pictures_.clear();
        greeting_.clear();
        for (const auto& client : clients_) client->forget_pictures();
        simulation_ =
            std::make_unique<Simulation>(run_, settings_.driven ? "{\"pause\": true}" : "");
        wire_ready_.emplace(io_, dup(simulation_->wire().descriptor()));
        send(json_text({{"power", true}}));
        wait_for_wire();
    }
    // Where there is no process or no descriptor for another simulation, the clients get an error.
    void power_on_again() {
        try {
            power_on();
        } catch (const std::exception& error) {
            simulation_.reset();
            send(json_text({{"error", error.what()}}));
            send_end(WRONG_INPUT);
        }
    }

    void wait_for_wire() {
        wire_ready_->async_wait(asio::posix::descriptor_base::wait_read,
                                [this](beast::error_code error) {
                                    if (error) return;  // another simulation has begun
                                    Wire& wire = simulation_->wire();
                                    const bool there = wire.poll(0);
                                    while (const auto message = wire.receive()) handle(*message);
                                    for (const auto& client : clients_) client->send_picture();
                                    if (there) return wait_for_wire();
                                    send_end(simulation_->reap());
                                });
    }

    void handle(const Message& message) {
        switch (message.kind) {
            case Kind::PICTURE: pictures_.update(message.bytes); break;
            case Kind::SOUND: {
                const std::string sound = static_cast<char>(Kind::SOUND) + message.bytes;
                for (const auto& client : clients_) client->send_sound(sound);
                break;
            }
            case Kind::TEXT:
                greeting_.add(message.bytes);
                send(message.bytes);
                break;
        }
    }

    // Those who connect later get it as well.
    void send_end(int exit_code) {
        const std::string text = json_text({{"ended", exit_code}});
        greeting_.add(text);
        send(text);
    }

    void send(const std::string& text) {
        for (const auto& client : clients_) client->send_text(text);
    }

    // ---- Clients ----

    void handle_from(Client& client, const std::string& text) {
        const auto json = nlohmann::json::parse(text, nullptr, false);
        if (!json.is_object())
            return client.send_text(
                json_text({{"error", "expected an object in JSON, got " + text.substr(0, 100)}}));
        if (json.contains("reset")) return power_on_again();
        if (!simulation_) return client.send_text(json_text({{"error", "the power is off"}}));
        if (json.contains("run")) client.leave_nothing_out();
        simulation_->wire().send(Kind::TEXT, text);
    }

    void read(const std::shared_ptr<HttpConnection>& connection) {
        connection->stream.expires_after(HTTP_TIME);
        http::async_read(connection->stream, connection->buffer, connection->parser,
                         [this, connection](beast::error_code error, std::size_t) {
                             if (error == http::error::body_limit)
                                 return answer(connection, http::status::payload_too_large,
                                               "text/plain", "expected a file of at most 64 MiB\n");
                             if (!error) request(connection);
                         });
    }

    void request(const std::shared_ptr<HttpConnection>& connection) {
        const auto& request = connection->parser.get();
        const auto target = request.target();
        const std::string path{target.substr(0, target.find('?'))};
        const auto refuse = [&](const char* why) {
            answer(connection, http::status::forbidden, "text/plain", why);
        };
        if (!listener_.is_own_host(std::string{request[http::field::host]}))
            return refuse("expected this server's own name as Host\n");
        const auto origin = request[http::field::origin];
        if (!origin.empty() && origin != "http://" + std::string{request[http::field::host]})
            return refuse("expected a page of this server as Origin\n");
        const bool page = request.method() == http::verb::get && path != "/ws";
        if (!(page && path != "/") && query(target, "token") != token_)
            return refuse("expected the token of the address that de1sim live has printed\n");
        if (path == "/ws" && beast::websocket::is_upgrade(request)) return upgrade(connection);
        if (path == "/run" && request.method() == http::verb::post) return run_file(connection);
        const PageFile* file = page ? page_file(std::string_view{path}.substr(1)) : nullptr;
        if (!file)
            return answer(connection, http::status::not_found, "text/plain", "no such page\n");
        answer(connection, http::status::ok, file->type, file->bytes);
    }

    void upgrade(const std::shared_ptr<HttpConnection>& connection) {
        if (clients_.size() >= MOST_CLIENTS)
            return answer(connection, http::status::service_unavailable, "text/plain",
                          "expected at most 16 clients\n");
        connection->stream.expires_never();
        const auto client = std::make_shared<Client>(
            connection->stream.release_socket(), pictures_,
            [this](Client& from, const std::string& text) { handle_from(from, text); },
            [this](Client& gone) {
                clients_.erase(gone.shared_from_this());
                if (settings_.driven && clients_.empty()) io_.stop();
            });
        clients_.insert(client);
        client->accept(connection->parser.get(), [this] {
            std::deque<std::string> texts = greeting_.texts();
            texts.push_front(
                json_text({{"hello", {{"protocol", PROTOCOL}, {"title", settings_.title}}}}));
            return texts;
        });
    }

    // A program or a scenario, from now on instead of what has run.
    void run_file(const std::shared_ptr<HttpConnection>& connection) {
        const std::string& bytes = connection->parser.get().body();
        const bool elf = bytes.compare(0, 4, "\177ELF") == 0;
        const auto file = folder_ / (elf ? "dropped.elf" : "dropped.yaml");
        try {
            write_whole_file(file, bytes);
        } catch (const IoError& error) {
            return answer(connection, http::status::insufficient_storage, "text/plain",
                          error.what());
        }
        run_.scenario = elf ? "" : file;
        run_.program.elf = elf ? file : "";
        answer(connection, http::status::ok, "text/plain", "runs\n");
        power_on_again();
    }

    const ServerSettings& settings_;
    const std::string token_ = new_token();
    RunDescription run_;
    std::filesystem::path folder_;  // of dropped files
    asio::io_context io_;
    Listener listener_;
    asio::signal_set signals_;
    std::unique_ptr<Simulation> simulation_;
    std::optional<asio::posix::stream_descriptor> wire_ready_;  // the wire's descriptor, to wait at
    PictureStore pictures_;
    Greeting greeting_;
    std::set<std::shared_ptr<Client>> clients_;
};

}  // namespace

int serve(const ServerSettings& settings,
          const std::function<void(const std::string& url)>& listening) {
    Server server{settings};
    listening(server.url());
    return server.run();
}

}  // namespace sim::live
