// linux_network_test.cpp - a Linux program's sockets that reach this machine by --network.
#include <gmock/gmock.h>

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tb/system/cli.h"

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A port of 127.0.0.1, the same for TCP and UDP, at which a process of its own sends back what it
// gets, in capital letters; of a connection when all has come.
class Server {
public:
    Server() : tcp_{::socket(AF_INET, SOCK_STREAM, 0)}, udp_{::socket(AF_INET, SOCK_DGRAM, 0)} {
        sockaddr_in address{};
        socklen_t length = sizeof address;
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        auto* const generic = reinterpret_cast<sockaddr*>(&address);
        EXPECT_EQ(::bind(tcp_, generic, sizeof address), 0);
        EXPECT_EQ(::getsockname(tcp_, generic, &length), 0);
        EXPECT_EQ(::bind(udp_, generic, sizeof address), 0);
        port = std::to_string(ntohs(address.sin_port));
    }
    ~Server() {
        stop();
        ::close(tcp_);
        ::close(udp_);
    }
    void start() {
        EXPECT_EQ(::listen(tcp_, 4), 0);
        process_ = ::fork();
        if (process_ != 0) return;
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (;;) serve();
    }
    // Nobody is there any more.
    void stop() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
        process_ = 0;
    }
    // Nobody is at the port, and nobody else gets it meanwhile: TCP is bound and does not listen.
    void leave_udp() {
        ::close(udp_);
        udp_ = -1;
    }

    std::string port;

private:
    void serve() const {
        char text[64];
        sockaddr_in from{};
        socklen_t length = sizeof from;
        pollfd entries[2] = {{tcp_, POLLIN, 0}, {udp_, POLLIN, 0}};
        ::poll(entries, 2, -1);
        const auto raise = [&](ssize_t count) {
            for (ssize_t i = 0; i < count; ++i)
                text[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[i])));
        };
        if (entries[1].revents & POLLIN) {
            const ssize_t count =
                ::recvfrom(udp_, text, sizeof text, 0, reinterpret_cast<sockaddr*>(&from), &length);
            raise(count);
            ::sendto(udp_, text, static_cast<std::size_t>(count), 0,
                     reinterpret_cast<sockaddr*>(&from), length);
        }
        if (!(entries[0].revents & POLLIN)) return;
        const int one = ::accept(tcp_, nullptr, nullptr);
        ssize_t all = 0;
        for (ssize_t count; (count = ::read(one, text + all, sizeof text - all)) > 0;) all += count;
        raise(all);
        if (::write(one, text, static_cast<std::size_t>(all)) != all) ::_exit(1);
        ::close(one);
    }

    int tcp_, udp_;
    pid_t process_ = 0;
};

class LinuxNetwork : public tb::CommandLine {
protected:
    Server server;

    tb::Outcome run(const std::string& what, const std::string& host = "127.0.0.1") const {
        return play(scenario("steps:\n  - wait-serial: {text: over, timeout: 60s}\n"),
                    {"--elf", LINUX_PROGRAMS "network", "--frames", "none", "--quiet", "--network",
                     host + ":" + server.port, "--", what, host, server.port});
    }
    void prints(const std::string& what, const std::string& text,
                const std::string& host = "127.0.0.1") const {
        const tb::Outcome outcome = run(what, host);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(file("console.txt"), text + "over\n");
        EXPECT_THAT(report()["log"]["first"], IsEmpty());
    }
};

TEST_F(LinuxNetwork, ConnectsToWhatIsNamed) {
    server.start();
    prints("tcp", "connected, Transport endpoint is already connected\nHELLO WORLD, 0\n");
}
TEST_F(LinuxNetwork, FindsTheHostByItsName) {
    addrinfo* found = nullptr;
    const addrinfo over_tcp{0, AF_INET, SOCK_STREAM, 0, 0, nullptr, nullptr, nullptr};
    if (getaddrinfo("localhost", nullptr, &over_tcp, &found) != 0)
        GTEST_SKIP() << "this machine does not know the name localhost";
    freeaddrinfo(found);
    server.start();
    prints("tcp", "connected, Transport endpoint is already connected\nHELLO WORLD, 0\n",
           "localhost");
}
TEST_F(LinuxNetwork, TellsOfWhatComesByEpoll) {
    server.start();
    prints("events", "there: Success\n-1: Resource temporarily unavailable\nEVENTS\n");
}
TEST_F(LinuxNetwork, ExchangesDatagrams) {
    server.start();
    prints("udp", "1 4 4 PIN 1\nconnected, PONG\n");
}
TEST_F(LinuxNetwork, IsRefusedWhereNobodyListens) {
    server.leave_udp();
    prints("refused",
           "Connection refused\nConnection refused\nconnected, -1: Connection refused\n");
}
TEST_F(LinuxNetwork, EndsWaitingForASilentServer) {
    server.start();
    prints("silent", "-1: Resource temporarily unavailable, in time\n");
}
TEST_F(LinuxNetwork, ReachesNothingElse) {
    server.start();
    EXPECT_EQ(run("others").exit_code, 0);
    EXPECT_EQ(file("console.txt"), "Connection refused\nNetwork is unreachable\nover\n");
    EXPECT_THAT(report()["log"]["first"][0].get<std::string>(),
                HasSubstr("has no network but the loopback and what --network names, "));
}
TEST_F(LinuxNetwork, IsInTheReport) {
    EXPECT_EQ(run("others").exit_code, 0);
    EXPECT_THAT(report()["program"]["network"], ElementsAre("127.0.0.1:" + server.port));
}
TEST_F(LinuxNetwork, HasToBeHostAndPort) {
    for (const char* wrong :
         {"localhost", "localhost:", "localhost:0", "localhost:http", "localhost:65536", ":80"}) {
        const tb::Outcome outcome = de1sim({"run", LINUX_PROGRAMS "network", "--out", out.string(),
                                            "--network", wrong, "--", "tcp", "localhost", "80"});
        EXPECT_EQ(outcome.exit_code, 2) << wrong;
        EXPECT_THAT(outcome.err,
                    HasSubstr("--network: expected HOST:PORT, a port from 1 to 65535"));
    }
}

}  // namespace
