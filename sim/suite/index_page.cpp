#include "sim/suite/index_page.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include <fmt/format.h>

#include "sim/page/html.h"
#include "sim/page/look.h"
#include "sim/suite/junit.h"

namespace sim::suite {

namespace {

namespace fs = std::filesystem;
using page::escape;

// A file's name as a link has it.
std::string url(const fs::path& file) {
    std::string out;
    for (const char c : file.string()) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) || std::strchr("/._-~", c);
        out += plain ? std::string{c} : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return out;
}

// The golden picture of a failure, what there was, and where they differ: side by side.
std::string pictures(const fs::path& folder, const Result& result, const Failure& failure) {
    std::string out;
    for (const char* what : {"expected", "actual", "difference"})
        for (const fs::path& file : pictures_of(folder, result, failure, what))
            out += fmt::format(
                "<figure><img data-what=\"{0}\" alt=\"{0}\" src=\"{1}\"><figcaption>{0}: {2}"
                "</figcaption></figure>\n",
                what, url(file), escape(file.filename().string()));
    return out.empty() ? "" : "<div class=\"three\">\n" + out + "</div>\n";
}

std::string section(const fs::path& folder, const Result& result) {
    const std::vector<fs::path> files = attachments(folder, result);
    std::string out = fmt::format(
        "<section id=\"{0}\">\n<h2>{0}</h2>\n<p><strong class=\"verdict {1}\">{2}</strong> {3}, "
        "{4:.3f} s simulated in {5:.2f} s</p>\n",
        escape(result.name), result.passed() ? "passed" : "failed",
        result.passed() ? "renewed" : "failed", escape(result.end), result.simulated_s,
        result.wall_s);
    if (!result.failures.empty()) {
        out += "<table>\n<thead><tr><th>line</th><th>expected</th><th>found</th></tr></thead>\n";
        for (const Failure& f : result.failures)
            out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}{}</td></tr>\n",
                               f.line ? std::to_string(f.line) : "", escape(f.step),
                               escape(f.detail), pictures(folder, result, f));
        out += "</table>\n";
    }
    if (!result.said.empty()) out += "<pre>" + escape_lines(result.said) + "</pre>\n";
    std::string links;
    for (const fs::path& file : files)
        links += fmt::format("<li><a href=\"{}\">{}</a></li>\n", url(file),
                             escape(file.lexically_relative(result.folder).string()));
    if (!links.empty()) out += "<ul>\n" + links + "</ul>\n";
    return out + "</section>\n";
}

}  // namespace

std::string to_index(const fs::path& folder, const Results& results) {
    const auto passed = std::count_if(results.all.begin(), results.all.end(),
                                      [](const Result& r) { return r.passed(); });
    const std::size_t count = results.all.size() + results.missing.size();
    const bool good = results.exit_code() == 0;
    std::string out = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>{0} of {1} scenarios passed</title>\n<style>{2}</style>\n</head>\n<body>\n"
        "<header>\n<h1>{0} of {1} scenarios passed</h1>\n"
        "<p><strong class=\"verdict {3}\">{3}</strong></p>\n</header>\n<main>\n",
        passed, count, page::STYLE, good ? "passed" : "failed");
    for (const Result& result : results.all)
        if (!result.passed() || !result.failures.empty()) out += section(folder, result);
    if (!results.missing.empty()) {
        out += "<section>\n<h2>Without a result</h2>\n<ul>\n";
        for (const std::string& name : results.missing) out += "<li>" + escape(name) + "</li>\n";
        out += "</ul>\n</section>\n";
    }
    out +=
        "<section>\n<h2>All</h2>\n<table>\n<thead><tr><th></th><th>scenario</th><th>end</th>"
        "<th>simulated</th><th>took</th></tr></thead>\n";
    for (const Result& r : results.all)
        out += fmt::format(
            "<tr class=\"{}\"><td class=\"mark-of\"></td><td>{}</td><td>{}</td><td class=\"time\">"
            "{:.3f} s</td><td class=\"time\">{:.2f} s</td></tr>\n",
            r.passed() ? "met" : "missed",
            r.passed() ? escape(r.name) : fmt::format("<a href=\"#{0}\">{0}</a>", escape(r.name)),
            escape(r.end), r.simulated_s, r.wall_s);
    out += "</table>\n</section>\n";
    return out + fmt::format("</main>\n<script>{}</script>\n</body>\n</html>\n", page::SCRIPT);
}

}  // namespace sim::suite
