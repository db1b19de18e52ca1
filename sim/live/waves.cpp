#include "sim/live/waves.h"

#include <chrono>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/project/command.h"
#include "sim/report/whole_file.h"

namespace sim::live {

namespace {

constexpr unsigned LIMIT_S = 24 * 3600;

// Those of the run that is played, without what it plays and for whom.
std::vector<std::string> options_of(const RunOptions& options) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < options.words.size(); ++i) {
        const std::string& word = options.words[i];
        if (word == "--live-socket")
            ++i;
        else if (word != options.scenario.string() && word != options.elf.string())
            words.push_back(word);
        else if (i > 0 && options.words[i - 1] == "--elf")
            words.pop_back();
    }
    if (!options.elf.empty()) words.insert(words.begin(), {"--elf", options.elf.string()});
    return words;
}

}  // namespace

Waves::Waves(const RunOptions& options) : options_{options} {}

Waves::~Waves() {
    given_up_ = true;
    if (running_.valid()) running_.wait();
}

void Waves::begin(const std::string& scenario, SimTime from, SimTime to) {
    if (running_.valid())
        throw std::runtime_error{"waveforms are being written; wait for their end"};
    const std::filesystem::path folder = options_.out / fmt::format("waves-{}", ++number_);
    const std::filesystem::path file = folder.string() + ".yaml", fst = folder / "waves.fst";
    write_whole_file(file, scenario);
    std::filesystem::remove(fst);
    std::vector<std::string> words{std::filesystem::read_symlink("/proc/self/exe").string(),
                                   "run",
                                   file.string(),
                                   "--again",
                                   folder.string(),
                                   "--trace-from",
                                   to_string(from),
                                   "--trace-to",
                                   to_string(to)};
    const std::vector<std::string> others = options_of(options_);
    words.insert(words.end(), others.begin(), others.end());
    running_ = std::async(std::launch::async, [this, words, fst]() -> Done {
        const project::Outcome outcome =
            project::run_command(words, ".", LIMIT_S, [this] { return given_up_.load(); });
        if (std::filesystem::exists(fst)) return {fst.string(), ""};
        const std::size_t end = outcome.output.find_last_not_of('\n');
        const std::size_t begin = outcome.output.rfind('\n', end) + 1;
        return {"", end == std::string::npos ? fmt::format("exit code {}", outcome.code)
                                             : outcome.output.substr(begin, end + 1 - begin)};
    });
}

std::optional<Waves::Done> Waves::done() {
    if (!running_.valid() ||
        running_.wait_for(std::chrono::seconds{0}) != std::future_status::ready)
        return {};
    return running_.get();
}

}  // namespace sim::live
