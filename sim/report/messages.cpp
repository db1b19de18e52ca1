// messages.cpp - see messages.h
#include "sim/report/messages.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "sim/report/printable.h"

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

void line_to_stderr(const char* before, std::string_view line) noexcept {
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

void draw(std::string_view text) noexcept { write_all(STDERR_FILENO, text); }

bool print_result(std::string_view text) noexcept {
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
