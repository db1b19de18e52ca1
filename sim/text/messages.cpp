// messages.cpp - see messages.h
#include "sim/text/messages.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "sim/text/printable.h"

namespace sim {

namespace {

// 0 or an error number.  Waits for a descriptor that another program made non-blocking.
int write_all(int descriptor, std::string_view text) noexcept {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EAGAIN) {
            pollfd room{descriptor, POLLOUT, 0};
            poll(&room, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

// What stands on the present line of the two streams.
std::atomic<bool> status_shown{false};       // on stderr
std::atomic<bool> output_unfinished{false};  // on stdout, without an end of the line
std::atomic<bool> output_failed{false};

bool streams_are_one() noexcept {
    static const bool one = [] {
        struct stat out {
        }, err{};
        return fstat(STDOUT_FILENO, &out) == 0 && fstat(STDERR_FILENO, &err) == 0 &&
               out.st_dev == err.st_dev && out.st_ino == err.st_ino;
    }();
    return one;
}

void line_to_stderr(const char* before, std::string_view line) noexcept {
    clear_status();
    if (streams_are_one() && output_unfinished.exchange(false)) write_all(STDERR_FILENO, "\n");
    try {
        write_all(STDERR_FILENO, before + printable(line) + "\n");
    } catch (const std::exception&) {  // no memory for it
        write_all(STDERR_FILENO, "de1sim: out of memory\n");
    }
}

}  // namespace

void prepare_standard_streams() noexcept {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) [[maybe_unused]]
            const int opened = open("/dev/null", O_RDWR);  // the lowest free one
    std::signal(SIGPIPE, SIG_IGN);
}

void message(std::string_view line) noexcept { line_to_stderr("", line); }

void complain(std::string_view line) noexcept { line_to_stderr("de1sim: ", line); }

void show_status(std::string_view text) noexcept {
    if (streams_are_one() && output_unfinished) return;
    write_all(STDERR_FILENO, "\r\033[K");
    write_all(STDERR_FILENO, text);
    status_shown = true;
}

void clear_status() noexcept {
    if (status_shown.exchange(false)) write_all(STDERR_FILENO, "\r\033[K");
}

void print_output(std::string_view text) noexcept {
    if (text.empty() || output_failed) return;
    if (streams_are_one()) clear_status();
    output_failed = write_all(STDOUT_FILENO, text) != 0;
    output_unfinished = text.back() != '\n';
}

bool print_result(std::string_view text) noexcept {
    if (streams_are_one()) clear_status();
    if (output_unfinished.exchange(false)) write_all(STDOUT_FILENO, "\n");
    const int error = write_all(STDOUT_FILENO, text);
    if (error == 0) return true;
    try {
        complain("standard output could not be written: " + std::generic_category().message(error));
    } catch (const std::exception&) {
        complain("standard output could not be written");
    }
    return false;
}

}  // namespace sim
