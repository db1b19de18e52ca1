// page.cpp - see page.h
#include "sim/page/page.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/page/html.h"
#include "sim/page/look.h"
#include "sim/page/plots.h"

namespace sim::page {

namespace {

void section(std::string& out, const char* heading, const std::string& content) {
    if (!content.empty())
        out += fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", heading, content);
}

std::string fact(const char* name, const std::string& value) {
    return value.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escape(value));
}

std::string title_of(const RunReport& report) {
    if (!report.scenario.empty()) return report.scenario;
    return report.program ? std::filesystem::path{report.program->elf}.filename().string()
                          : "a run";
}

std::string head(const RunReport& report) {
    const auto met = std::count_if(report.expectations.begin(), report.expectations.end(),
                                   [](const Expectation& e) { return e.met; });
    std::string out = fmt::format(
        "<header>\n<h1>{}</h1>\n<p><strong class=\"verdict {}\">{}</strong> {}</p>\n<dl>\n",
        escape(title_of(report)), report.passed() ? "passed" : "failed",
        report.passed() ? "passed" : "failed", to_string(report.end));
    if (!report.expectations.empty())
        out += fact("expectations", fmt::format("{} of {} met", met, report.expectations.size()));
    out += fact("simulated", fmt::format("{:.3f} s, {} frames, {} new pictures", report.simulated_s,
                                         report.frames_shown, report.frames_swapped));
    out += fact("picture", report.signal) + fact("at the end", report.lamps);
    out += "</dl>\n";
    std::string wrong;
    for (const std::string& fault : report.faults) wrong += "<li>" + escape(fault) + "</li>\n";
    for (const Check& check : report.checks)
        if (!check.met)
            wrong += "<li>" + escape(check.name + ": not met: " + check.detail) + "</li>\n";
    for (const std::string& line : report.advice) wrong += "<li>" + escape(line) + "</li>\n";
    if (!wrong.empty()) out += "<ul>\n" + wrong + "</ul>\n";
    return out + "</header>\n";
}

std::string pictures_of(const Page::Step& step) {
    std::string out;
    for (const Page::Picture& picture : step.pictures) {
        const char* what = "picture";
        for (const char* one : {"expected", "actual", "difference"})
            if (picture.name.find(fmt::format("_{}.png", one)) != std::string::npos) what = one;
        out += fmt::format(
            "<figure><img data-what=\"{0}\" alt=\"{0}\" src=\"{1}\"><figcaption>{0}: {2}"
            "</figcaption></figure>\n",
            what, data_url(picture.png), escape(picture.name));
    }
    return out.empty() ? "" : "<div class=\"three\">\n" + out + "</div>\n";
}

std::string steps(const Page& page, double end_s) {
    if (page.steps.empty()) return "";
    std::string out = step_plot(page, end_s);
    out += "<table>\n<thead><tr><th>time</th><th></th><th>step</th><th>found</th></tr></thead>\n";
    for (std::size_t i = 0; i < page.steps.size(); ++i) {
        const Page::Step& step = page.steps[i];
        out += fmt::format(
            "<tr id=\"s{}\" class=\"{}\"><td class=\"time\">{}</td><td class=\"mark-of\">{}</td>"
            "<td>{}{}</td><td>{}",
            i,
            !step.met   ? "done"
            : *step.met ? "met"
                        : "missed",
            step.begun ? fmt::format("{:.3f} s", step.to_s) : "never",
            step.met && !*step.met ? " not met" : "", escape(step.text),
            step.line ? fmt::format(" <small>line {}</small>", step.line) : "",
            escape(step.detail));
        if (step.frame) out += fmt::format(" <a href=\"#f{0}\">frame {0}</a>", step.frame);
        out += pictures_of(step) + "</td></tr>\n";
    }
    return out + "</table>\n";
}

std::string film(const Film& film) {
    if (film.pictures().empty()) return "";
    std::string out =
        fmt::format("<p>{} of {} new pictures, half size</p>\n<div class=\"strip\">\n",
                    film.pictures().size(), film.shown());
    for (const Film::Picture& picture : film.pictures())
        out += fmt::format(
            "<figure id=\"f{0}\"><img alt=\"frame {0}\" src=\"{1}\"><figcaption>{0}, {2:.3f} s"
            "</figcaption></figure>\n",
            picture.number, data_url(picture.png), picture.time_s);
    return out + "</div>\n";
}

std::string lamps(const RunReport& report) {
    std::string out = lamp_plot(report.shown, report.simulated_s);
    for (const RunReport::Shown& shown : report.shown)
        if (shown.left_out)
            out += fmt::format("<p>{} changed {} times more.</p>\n", escape(shown.name),
                               shown.left_out);
    const auto block = [&out](const std::string& name, const std::vector<std::string>& lines) {
        out += fmt::format("<h3>{}</h3>\n<pre>", escape(name));
        for (const std::string& line : lines) out += escape(line) + "\n";
        out += "</pre>\n";
    };
    for (const PartReport& part : report.parts)
        if (!part.rows.empty()) block(part.name, part.rows);
    if (std::any_of(report.characters.begin(), report.characters.end(),
                    [](const std::string& row) { return !row.empty(); }))
        block("character buffer", report.characters);
    return out;
}

std::string frames(const Page& page, double end_s) {
    std::string plot = frame_plot(page.frames, end_s);
    if (plot.empty()) return "";
    return plot +
           "<p><span class=\"key\" style=\"background:var(--blue)\"></span> instructions per "
           "frame, "
           "<span class=\"key\" style=\"background:var(--good)\"></span> share of the frame not "
           "asleep, <span class=\"key\" style=\"background:var(--warm)\"></span> share waiting for "
           "the FPGA</p>\n";
}

std::string console(const ConsoleLog& console) {
    if (console.lines().empty()) return "";
    std::string out = "<div class=\"scroll\"><table>\n";
    for (const ConsoleLog::Line& line : console.lines())
        out += fmt::format("<tr><td class=\"time\">{:.3f} s</td><td><code>{}</code></td></tr>\n",
                           line.time_s, escape(line.text));
    out += "</table></div>\n";
    if (console.left_out())
        out += fmt::format("<p>and {} characters more</p>\n", console.left_out());
    return out;
}

std::string again(const RunReport& report, const Page& page) {
    return "<pre>" + escape(page.command) + "</pre>\n<dl>\n" + fact("version", page.version) +
           fact("scenario", report.file) +
           fact("program", report.program ? report.program->elf : "") +
           fact("processor", report.cpu) + fact("seed", std::to_string(report.seed)) +
           fact("last frame", report.last_frame_sha256) +
           fact("took", fmt::format("{:.2f} s on this machine", report.wall_s)) + "</dl>\n";
}

}  // namespace

void ConsoleLog::print(double time_s, char character) {
    if (bytes_ == MOST_BYTES) {
        ++left_out_;
        return;
    }
    ++bytes_;
    if (begins_) lines_.push_back({time_s, ""});
    begins_ = character == '\n';
    if (character != '\n' && character != '\r') lines_.back().text += character;
}

std::string to_html(const RunReport& report, const Page& page) {
    const double end_s = report.simulated_s;
    std::string out = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n"
        "<title>{}: {}</title>\n<style>{}</style>\n</head>\n<body>\n",
        escape(title_of(report)), report.passed() ? "passed" : "failed", STYLE);
    out += head(report) + "<main>\n";
    section(out, "Steps", steps(page, end_s));
    section(out, "Pictures", film(page.film));
    section(out, "Sound", sound_plot(page.sound, end_s));
    section(out, "Lamps and digits", lamps(report));
    section(out, "Frames", frames(page, end_s));
    section(out, "Console", console(page.console));
    section(out, "To repeat it", again(report, page));
    return out + fmt::format("</main>\n<script>{}</script>\n</body>\n</html>\n", SCRIPT);
}

}  // namespace sim::page
