#include "sim/live/simulation.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace sim::live {

Simulation::Simulation(RunDescription run, const std::string& first) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::runtime_error{std::string{"no socket pair: "} + std::strerror(errno)};
    wire_ = std::make_unique<Wire>(ends[0]);
    run.outputs.live_socket = ends[1];
    const DescriptionFile description{run};
    std::vector<std::string> command = description.command();
    std::vector<char*> argv;
    for (std::string& word : command) argv.push_back(word.data());
    argv.push_back(nullptr);
    if (!first.empty()) wire_->send(Kind::TEXT, first);
    child_ = fork();
    if (child_ == 0) {
        // Ctrl-C is for the server, which then ends this process in order.
        setpgid(0, 0);
        fcntl(ends[1], F_SETFD, 0);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(ends[1]);
    if (child_ < 0) throw std::runtime_error{std::string{"no process: "} + std::strerror(errno)};
}

int Simulation::reap() {
    if (child_ <= 0) return code_;
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    return code_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int Simulation::end() {
    if (child_ <= 0) return code_;
    wire_->send(Kind::TEXT, "{\"quit\": true}");
    auto limit = std::chrono::steady_clock::now() + std::chrono::seconds{10};
    while (std::chrono::steady_clock::now() < limit && wire_->poll(100))
        while (wire_->receive()) {
        }
    kill(child_, SIGTERM);
    limit += std::chrono::seconds{2};
    while (std::chrono::steady_clock::now() < limit) {
        siginfo_t gone{};
        if (waitid(P_PID, static_cast<id_t>(child_), &gone, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            gone.si_pid == child_)
            return reap();
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    kill(child_, SIGKILL);
    return reap();
}

}  // namespace sim::live
