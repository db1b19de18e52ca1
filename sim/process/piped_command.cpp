#include "sim/process/piped_command.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "sim/process/become.h"

namespace sim {

PipedCommand::PipedCommand(const std::vector<std::string>& command) {
    int ends[2] = {-1, -1};
    output_ = memfd_create("output", MFD_CLOEXEC);
    if (output_ >= 0 && pipe2(ends, O_CLOEXEC) == 0) child_ = fork();
    if (child_ == 0) become(command, ".", ends[0], output_);
    const int reason = errno;
    if (ends[0] >= 0) close(ends[0]);
    input_ = ends[1];
    if (child_ > 0) return;
    if (input_ >= 0) close(input_);
    if (output_ >= 0) close(output_);
    throw std::runtime_error{command[0] + " cannot be started: " + std::strerror(reason)};
}

PipedCommand::~PipedCommand() {
    if (child_ > 0) kill(-child_, SIGKILL);
    finish();
    close(output_);
}

bool PipedCommand::write(const std::string& bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t written = ::write(input_, bytes.data() + at, bytes.size() - at);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        at += static_cast<std::size_t>(written);
    }
    return true;
}

const Outcome& PipedCommand::finish() {
    if (child_ <= 0) return outcome_;
    close(std::exchange(input_, -1));
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    outcome_.code = code_of(status);
    lseek(output_, 0, SEEK_SET);
    char buffer[4096];
    for (ssize_t got; (got = read(output_, buffer, sizeof buffer)) > 0;)
        outcome_.output.append(buffer, static_cast<std::size_t>(got));
    return outcome_;
}

}  // namespace sim
