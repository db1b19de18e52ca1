#include "tb/bench/measured_run.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bench {

namespace {

// Discards its messages: a shortened run misses expectations at its end.  Returns wait4's status.
int run_quietly(std::vector<std::string> words, rusage& used) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        execv(argv[0], argv.data());
        _exit(127);
    }
    int status = -1;
    if (child < 0 || wait4(child, &status, 0, &used) != child)
        throw std::runtime_error("cannot start " + words[0]);
    return status;
}

}  // namespace

MeasuredRun measure_run(const std::string& de1sim, const std::string& scenario,
                        std::optional<unsigned> duration_s, const std::filesystem::path& out,
                        const std::vector<std::string>& options) {
    std::filesystem::remove_all(out);
    rusage used{};
    const auto begin = std::chrono::steady_clock::now();
    std::vector<std::string> words{de1sim, "run", scenario, "--quiet", "--out", out.string()};
    if (duration_s) words.insert(words.end(), {"--duration", fmt::format("{}s", *duration_s)});
    words.insert(words.end(), options.begin(), options.end());
    const int status = run_quietly(words, used);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    if (!WIFEXITED(status) || WEXITSTATUS(status) > (duration_s ? 1 : 0))
        throw std::runtime_error(
            fmt::format("{} run {} ended with status {:#x}", de1sim, scenario, status));

    std::ifstream file{out / "report.json"};
    const auto report = nlohmann::json::parse(file);
    const double simulated_s = report.at("simulated_s").get<double>();
    if ((duration_s && std::abs(simulated_s - *duration_s) > 1e-9) || !report.at("faults").empty())
        throw std::runtime_error("the run did not go as it should: see " + out.string());
    std::uint64_t pictures = 0;
    if (std::filesystem::exists(out / "frames"))
        for ([[maybe_unused]] const auto& entry :
             std::filesystem::directory_iterator{out / "frames"})
            ++pictures;
    std::filesystem::remove_all(out);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    MeasuredRun run;
    run.wall_s = wall.count();
    run.peak_mb = static_cast<double>(used.ru_maxrss) / 1024;
    run.frames = pictures;
    run.cpu_s = seconds(used.ru_utime) + seconds(used.ru_stime);
    run.shown = report.at("frames").at("shown");
    run.swapped = report.at("frames").at("swapped");
    if (report.contains("program")) {
        run.instructions = report["program"]["instructions"];
        if (report["program"].contains("frames"))
            run.busy_share = report["program"]["frames"]["busy_share"]["median"];
    }
    return run;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace bench
