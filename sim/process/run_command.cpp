#include "sim/process/run_command.h"

#include "sim/process/become.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr int NO_PROGRAM = 127, SIGNALLED = 128, LOOK_MS = 200;

}  // namespace

void become(const std::vector<std::string>& command, const char* folder, int input, int output) {
    setpgid(0, 0);  // so that all of it can be ended
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    dup2(input, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (chdir(folder) == 0) execvp(arguments[0], arguments.data());
    _exit(NO_PROGRAM);
}

int code_of(int status) {
    return WIFSIGNALED(status) ? SIGNALLED + WTERMSIG(status) : WEXITSTATUS(status);
}

std::string Outcome::last_line() const {
    const std::size_t last = output.find_last_not_of('\n');
    if (last == std::string::npos) return "";
    const std::size_t before = output.rfind('\n', last);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return output.substr(begin, last + 1 - begin);
}

Outcome run_command(const std::vector<std::string>& command, const std::filesystem::path& folder,
                    unsigned limit_s, const std::function<bool()>& given_up) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {NO_PROGRAM, "no pipe"};
    const pid_t child = fork();
    if (child < 0) {
        close(ends[0]);
        close(ends[1]);
        return {NO_PROGRAM, "no process"};
    }
    if (child == 0)
        become(command, folder.c_str(), open("/dev/null", O_RDONLY | O_CLOEXEC), ends[1]);
    setpgid(child, child);
    close(ends[1]);
    Outcome outcome{0, {}};
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{limit_s};
    bool late = false;
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now());
        if (left.count() <= 0 || given_up()) {
            late = true;
            kill(-child, SIGKILL);
            break;
        }
        pollfd readable{ends[0], POLLIN, 0};
        const auto moment = std::min<std::int64_t>(left.count(), LOOK_MS);
        if (poll(&readable, 1, static_cast<int>(moment)) <= 0) continue;
        char buffer[4096];
        const ssize_t got = read(ends[0], buffer, sizeof buffer);
        if (got <= 0) break;
        outcome.output.append(buffer, static_cast<std::size_t>(got));
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    outcome.code = late ? TIMED_OUT : code_of(status);
    return outcome;
}

std::vector<Outcome> run_commands(const std::vector<std::vector<std::string>>& commands,
                                  const std::filesystem::path& folder, unsigned limit_s) {
    std::vector<Outcome> outcomes(commands.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t n; (n = next++) < commands.size();)
            outcomes[n] = run_command(commands[n], folder, limit_s);
    };
    std::vector<std::thread> threads;
    const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t n = 1; n < std::min(most, commands.size()); ++n) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    return outcomes;
}

}  // namespace sim
