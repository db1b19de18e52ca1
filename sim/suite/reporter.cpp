#include "sim/suite/reporter.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/text/messages.h"
#include "sim/text/printable.h"

namespace sim::suite {

Reporter::Reporter(const std::vector<Case>& cases, unsigned jobs)
    : count_{cases.size()},
      jobs_{jobs},
      terminal_{isatty(STDERR_FILENO) == 1},
      begin_{std::chrono::steady_clock::now()},
      cases_{cases} {
    std::sort(cases_.begin(), cases_.end(),
              [](const Case& a, const Case& b) { return a.name < b.name; });
    for (const Case& one : cases_) expected_left_s_ += one.expected_s;
}

double Reporter::wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

// From the estimates that are left, by how those before have turned out.
double Reporter::left_s() const {
    const double ratio = expected_done_s_ > 0 ? measured_s_ / expected_done_s_ : 1;
    return expected_left_s_ * ratio / jobs_;
}

void Reporter::done(const Result& result) {
    const auto one =
        std::lower_bound(cases_.begin(), cases_.end(), result.name,
                         [](const Case& a, const std::string& name) { return a.name < name; });
    if (one != cases_.end() && one->name == result.name) {
        expected_left_s_ -= one->expected_s;
        expected_done_s_ += one->expected_s;
        measured_s_ += result.wall_s;
    }
    ++done_;
    if (!result.passed()) ++failed_;
    message(fmt::format("{} {:7.2f} s  {}", result.passed() ? "ok    " : "FAILED", result.wall_s,
                        result.name));
    if (terminal_ && done_ < count_)
        show_status(fmt::format("{} of {}, {} failed, about {:.0f} s left", done_, count_, failed_,
                                std::ceil(left_s())));
}

bool summarise(const Results& results, double wall_s, const std::filesystem::path& out) {
    std::size_t passed = 0, renewed = 0;
    for (const Result& result : results.all) {
        passed += result.passed();
        if (result.passed() && result.failures.empty()) continue;
        message("");
        message(fmt::format("{}: {}", result.file, result.passed() ? "renewed" : result.end));
        for (const Failure& f : result.failures) {
            renewed += f.met;
            message(fmt::format("  {}{}", f.line ? fmt::format("line {}: ", f.line) : "", f.step));
            message("    " + f.detail);
        }
        if (result.failures.empty() && !result.said.empty()) {
            const std::size_t end = result.said.find_last_not_of('\n');
            const std::size_t begin = result.said.rfind('\n', end);
            message("  " +
                    result.said.substr(begin == std::string::npos ? 0 : begin + 1,
                                       end - (begin == std::string::npos ? 0 : begin + 1) + 1));
        }
    }
    if (!results.missing.empty()) message("");
    for (const std::string& name : results.missing) message(name + ": has no result");
    const std::size_t count = results.all.size() + results.missing.size();
    return print_result(
        fmt::format("{} of {} scenarios passed{} in {:.1f} s; see {}\n", passed, count,
                    renewed ? fmt::format(", {} golden pictures renewed,", renewed) : "", wall_s,
                    printable((out / "index.html").string())));
}

}  // namespace sim::suite
