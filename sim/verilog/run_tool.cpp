#include "sim/verilog/run_tool.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "sim/verilog/project_error.h"
#include "sim/verilog/quartus/words.h"

namespace sim::project {

namespace {

constexpr std::string_view BLANK = "\u00a0";  // one that does not end a word
constexpr const char* PACKAGES = "apt install verilator g++ zlib1g-dev (packages of Debian)";

}  // namespace

std::string without_blanks(std::string name) {
    for (std::size_t at = 0; (at = name.find(' ', at)) != std::string::npos; at += BLANK.size())
        name.replace(at, 1, BLANK);
    return name;
}

std::string with_blanks(std::string text) {
    for (std::size_t at = 0; (at = text.find(BLANK, at)) != std::string::npos;)
        text.replace(at, BLANK.size(), " ");
    return text;
}

TimeLimit::TimeLimit(unsigned seconds)
    : seconds_{seconds}, end_{std::chrono::steady_clock::now() + std::chrono::seconds{seconds}} {}

unsigned TimeLimit::left_s() const {
    const auto left = end_ - std::chrono::steady_clock::now();
    return left.count() <= 0
               ? 0
               : static_cast<unsigned>(std::chrono::ceil<std::chrono::seconds>(left).count());
}

std::string error_of(const Outcome& outcome, const std::string& tool, const TimeLimit& limit) {
    if (outcome.code == TIMED_OUT)
        return fmt::format("the build has not ended in {} s (--build-limit): {} was at work",
                           limit.seconds(), tool);
    if (outcome.code == 127) return tool + " is not installed: " + PACKAGES;
    for (const char* missing : {"zlib.h: No such file", "cannot find -lz"})
        if (outcome.output.find(missing) != std::string::npos)
            return std::string{"zlib's headers are not installed: "} + PACKAGES;
    std::istringstream lines{outcome.output};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t mark = line.find("%Error");
        if (mark != std::string::npos) {
            if (line.find("Exiting due to") != std::string::npos) continue;
            const std::size_t colon = line.find(": ", mark);
            if (colon == std::string::npos) return line;
            const auto after = static_cast<std::size_t>(std::max<std::streamoff>(lines.tellg(), 0));
            return error_in_our_words(line.substr(colon + 2),
                                      std::string_view{outcome.output}.substr(after));
        }
        if (first.empty() && line.find("error:") != std::string::npos) first = line;
    }
    return first.empty() ? fmt::format("{} ended with code {}: {}", tool, outcome.code,
                                       outcome.output.substr(0, 200))
                         : first;
}

std::string run_tool(const std::vector<std::string>& words, const std::filesystem::path& folder,
                     const TimeLimit& limit) {
    const Outcome outcome = run_command(words, folder, limit.left_s());
    if (outcome.code != 0) throw ProjectError{with_blanks(error_of(outcome, words[0], limit))};
    return outcome.output;
}

}  // namespace sim::project
