#include "tb/support/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

namespace tb {

namespace {

void check(int result, const char* what) {
    if (result < 0) throw std::system_error{errno, std::generic_category(), what};
}

struct Channel {
    int ours = -1, theirs = -1;

    Channel(bool terminal) {
        if (terminal) {
            const winsize size{24, 80, 0, 0};
            check(openpty(&ours, &theirs, nullptr, nullptr, &size), "openpty");
            check(fcntl(ours, F_SETFD, FD_CLOEXEC), "fcntl");
            check(fcntl(theirs, F_SETFD, FD_CLOEXEC), "fcntl");
        } else {
            int ends[2];
            check(pipe2(ends, O_CLOEXEC), "pipe2");
            ours = ends[0], theirs = ends[1];
        }
    }
    ~Channel() {
        close(ours);
        close_theirs();
    }
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    void close_theirs() {
        if (theirs >= 0) close(theirs);
        theirs = -1;
    }

    // False at its end; a terminal without an open end gives an error.
    bool read_into(std::string& text) const {
        char bytes[4096];
        const ssize_t count = read(ours, bytes, sizeof bytes);
        if (count > 0) text.append(bytes, static_cast<std::size_t>(count));
        return count > 0 || (count < 0 && errno == EINTR);
    }
};

[[noreturn]] void become(const Command& command, char** argv, const Channel& out,
                         const Channel& err) {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out.theirs, STDOUT_FILENO);
    dup2(err.theirs, STDERR_FILENO);
    if (command.disk_full) {
        const rlimit limit{*command.disk_full, *command.disk_full};
        setrlimit(RLIMIT_FSIZE, &limit);
        signal(SIGXFSZ, SIG_IGN);  // so that a write fails, as on a full disk
    }
    execv(argv[0], argv);
    _exit(127);
}

}  // namespace

bool has_terminals() {
    int ours = -1, theirs = -1;
    if (openpty(&ours, &theirs, nullptr, nullptr, nullptr) != 0) return false;
    close(ours);
    close(theirs);
    return true;
}

Outcome run_program(const Command& command) {
    std::vector<char*> argv;
    const std::vector<std::string> by_shell{"/bin/sh", "-c", command.shell + "; exec \"$@\"", "sh"};
    if (!command.shell.empty())
        for (const std::string& word : by_shell) argv.push_back(const_cast<char*>(word.c_str()));
    for (const std::string& word : command.arguments)
        argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    check(access(command.arguments.at(0).c_str(), X_OK), command.arguments[0].c_str());

    Channel out{false}, err{command.on_terminal};
    const pid_t child = fork();
    check(child, "fork");
    if (child == 0) become(command, argv.data(), out, err);
    out.close_theirs();
    err.close_theirs();

    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(command.timeout_s);
    Outcome outcome;
    bool interrupted = !command.interrupt_when;
    pollfd ends[] = {{out.ours, POLLIN, 0}, {err.ours, POLLIN, 0}};
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        poll(ends, 2, 2);
        if (ends[0].revents && !out.read_into(outcome.out)) ends[0].fd = -1;
        if (ends[1].revents && !err.read_into(outcome.err)) ends[1].fd = -1;
        if (!interrupted && command.interrupt_when()) {
            kill(child, command.interrupt_by);
            interrupted = true;
        }
        if (!outcome.timed_out && Clock::now() > end) {
            outcome.timed_out = true;
            kill(child, SIGKILL);
        }
    }
    int status = 0;
    check(waitpid(child, &status, 0), "waitpid");
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return outcome;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

}  // namespace tb
