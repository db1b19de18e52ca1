#include "sim/suite/junit.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/text/markup.h"

namespace sim::suite {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t MAX_JUNIT_BYTES = 16u << 20;
constexpr const char *BEGIN = "<testsuite name=\"", *END = "</testsuite>";

std::string suite_of_run(const fs::path& file, const std::string& name) {
    std::string text;
    try {
        text = read_whole_file(file, MAX_JUNIT_BYTES);
    } catch (const IoError&) {
        return "";
    }
    const std::size_t begin = text.find(BEGIN), end = text.rfind(END);
    const std::size_t name_at = begin + std::string{BEGIN}.size(),
                      name_end = text.find('"', name_at);
    if (begin == std::string::npos || end == std::string::npos || name_end > end) return "";
    return "  " + std::string{BEGIN} + escape_markup(name) + text.substr(name_end, end - name_end);
}

std::string suite_of_an_error(const Result& result) {
    return fmt::format(
        "  {0}{1}\" tests=\"1\" failures=\"0\" errors=\"1\" time=\"0\">\n"
        "    <testcase classname=\"{1}\" name=\"the run\" time=\"0\">\n"
        "      <error message=\"{2}\">{3}</error>\n    </testcase>\n  ",
        BEGIN, escape_markup(result.name), escape_markup(result.end), escape_lines(result.said));
}

}  // namespace

std::vector<fs::path> attachments(const fs::path& folder, const Result& result) {
    std::vector<fs::path> found;
    if (result.passed() && result.failures.empty()) return found;
    const fs::path run = folder / result.folder;
    std::error_code error;
    for (const char* part : {"mismatch", "failure"})
        for (const auto& entry : fs::directory_iterator(run / part, error)) {
            const std::string name = entry.path().filename().string();
            const bool own = part == std::string{"mismatch"} || name.rfind("waves.", 0) == 0;
            if (own) found.push_back(fs::path{result.folder} / part / name);
        }
    if (fs::file_size(run / "console.txt", error) > 0 && !error)
        found.push_back(fs::path{result.folder} / "console.txt");
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<fs::path> pictures_of(const fs::path& folder, const Result& result,
                                  const Failure& failure, const std::string& what) {
    const std::string begin = fmt::format("line{}_", failure.line), end = "_" + what + ".png";
    std::vector<fs::path> found;
    for (const fs::path& file : attachments(folder, result)) {
        const std::string name = file.filename().string();
        if (name.rfind(begin, 0) == 0 && name.size() >= end.size() &&
            name.compare(name.size() - end.size(), end.size(), end) == 0)
            found.push_back(file);
    }
    return found;
}

std::string junit_suite(const fs::path& folder, const Result& result) {
    std::string suite = suite_of_run(folder / result.folder / "junit.xml", result.name);
    if (suite.empty()) suite = suite_of_an_error(result);
    std::string out;
    for (const fs::path& file : attachments(folder, result))
        out += "[[ATTACHMENT|" + file.string() + "]]\n";
    if (!out.empty()) suite += "  <system-out>" + escape_lines(out) + "</system-out>\n  ";
    return suite + END + "\n";
}

}  // namespace sim::suite
