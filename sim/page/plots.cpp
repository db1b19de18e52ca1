// plots.cpp - see plots.h
#include "sim/page/plots.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/page/html.h"

namespace sim::page {

namespace {

constexpr double WIDTH = 1000, LEFT = 64;

class Plot {
public:
    Plot(double height, double end_s, const std::string& what) : end_s_{std::max(end_s, 1e-9)} {
        text_ = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
                            LEFT + WIDTH + 16, height + 18, escape(what));
        // About ten marks, 1, 2 or 5 times a power of ten apart.
        const double power = std::pow(10, std::floor(std::log10(end_s_ / 5)));
        const double of_power = end_s_ / 5 / power;
        const double apart = power * (of_power >= 5 ? 5 : of_power >= 2 ? 2 : 1);
        for (int i = 0; i * apart <= end_s_; ++i)
            add("<path class=\"grid\" d=\"M{0:.1f} 0V{1}\"/>"
                "<text x=\"{0:.1f}\" y=\"{2}\" class=\"mark\">{3:.6g} s</text>\n",
                x(i * apart), height, height + 14, i * apart);
    }

    double x(double time_s) const { return LEFT + WIDTH * std::min(time_s / end_s_, 1.0); }
    void name(double y, const std::string& name) {
        add("<text x=\"{}\" y=\"{:.1f}\" class=\"name\">{}</text>\n", LEFT - 6, y, escape(name));
    }
    void bar(double from_s, double to_s, double y, double height, const char* look,
             const std::string& title) {
        add("<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\">"
            "<title>{}</title></rect>\n",
            look, x(from_s), y, std::max(x(to_s) - x(from_s), 1.5), height, escape(title));
    }
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        text_ += fmt::format(format, std::forward<Args>(args)...);
    }
    std::string done() { return text_ + "</svg>\n"; }

private:
    double end_s_;
    std::string text_;
};

// The path through the largest of the values, at most one per half a pixel.
template <class Value>
std::string line(const Plot& plot, const std::vector<FrameUse>& frames, double y, double height,
                 double most, Value value) {
    const std::size_t group = frames.size() / static_cast<std::size_t>(WIDTH) + 1;
    std::string path;
    for (std::size_t i = 0; i < frames.size(); i += group) {
        double top = 0;
        for (std::size_t j = i; j < std::min(i + group, frames.size()); ++j)
            top = std::max(top, value(frames[j]));
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", plot.x(frames[i].time_s),
                            y + height * (1 - (most > 0 ? top / most : 0)));
    }
    return path;
}

std::string text_of(const RunReport::Shown::Fields& fields) {
    return fields.empty() ? "" : fields.front().second;
}

}  // namespace

std::string step_plot(const Page& page, double end_s) {
    if (page.steps.empty()) return "";
    constexpr double ROW = 16;
    Plot plot{2 * ROW + 4, end_s, "Steps over time"};
    plot.name(ROW - 4, "actions");
    plot.name(2 * ROW - 4, "expected");
    for (std::size_t i = 0; i < page.steps.size(); ++i) {
        const Page::Step& step = page.steps[i];
        if (!step.begun) continue;
        plot.add("<a href=\"#s{}\">", i);
        plot.bar(step.from_s, step.to_s, step.met ? ROW : 0, ROW - 4,
                 !step.met   ? "action"
                 : *step.met ? "good"
                             : "bad",
                 fmt::format("{:.3f} s: {}", step.from_s, step.text));
        plot.add("</a>");
    }
    return plot.done();
}

std::string sound_plot(const SoundLog& sound, double end_s) {
    if (sound.envelope().empty()) return "";
    constexpr double MIDDLE = 50, HALF = 46, TONES = 110;
    Plot plot{TONES + 14, end_s, "Sound over time"};
    plot.name(MIDDLE + 4, "level");
    plot.name(TONES + 4, "tones");
    std::string there, back;
    for (std::size_t i = 0; i < sound.envelope().size(); ++i) {
        const double x = plot.x((static_cast<double>(i) + 0.5) * sound.span_s());
        const auto y = [&](std::int16_t sample) { return MIDDLE - HALF * sample / 32768; };
        there +=
            fmt::format("{}{:.1f} {:.1f}", i ? "L" : "M", x, y(sound.envelope()[i].high) - 0.3);
        back = fmt::format("L{:.1f} {:.1f}", x, y(sound.envelope()[i].low) + 0.3) + back;
    }
    plot.add("<path class=\"sound\" d=\"{}{}Z\"/>\n", there, back);
    double free_x = 0;
    for (const SoundLog::Tone& tone : sound.tones()) {
        plot.bar(tone.from_s, tone.to_s, TONES - 6, 4, "action",
                 fmt::format("{:.0f} Hz at {:.0f} dBFS, {:.3f} s to {:.3f} s", tone.hz,
                             tone.level_dbfs, tone.from_s, tone.to_s));
        const double x = plot.x(tone.from_s);
        if (x < free_x) continue;
        plot.add("<text x=\"{:.1f}\" y=\"{}\" class=\"label\">{:.0f} Hz</text>\n", x, TONES + 10,
                 tone.hz);
        free_x = x + 46;
    }
    return plot.done();
}

std::string lamp_plot(const std::vector<RunReport::Shown>& shown, double end_s) {
    constexpr double ROW = 18;
    std::vector<const RunReport::Shown*> changing;
    for (const RunReport::Shown& one : shown)
        if (!one.changes.empty()) changing.push_back(&one);
    if (changing.empty()) return "";
    Plot plot{ROW * static_cast<double>(changing.size()) + 2, end_s, "Lamps and digits over time"};
    for (std::size_t row = 0; row < changing.size(); ++row) {
        const auto& changes = changing[row]->changes;
        const double y = ROW * static_cast<double>(row) + 2;
        plot.name(y + 11, changing[row]->name);
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const double from = changes[i].first;
            const bool last = i + 1 == changes.size();
            const double to = !last ? changes[i + 1].first : changing[row]->left_out ? from : end_s;
            const std::string text = text_of(changes[i].second);
            const bool dark =
                text.find_first_not_of(" 0x") == std::string::npos && changing[row]->name != "hex";
            plot.bar(from, to, y, ROW - 4, dark ? "dark" : "lit",
                     fmt::format("{:.3f} s: {}", from, text));
            if (plot.x(to) - plot.x(from) > 7.0 * static_cast<double>(text.size()))
                plot.add("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"label\">{}</text>\n",
                         plot.x(from) + 3, y + 11, escape(text));
        }
    }
    return plot.done();
}

std::string frame_plot(const std::vector<FrameUse>& frames, double end_s) {
    if (frames.empty()) return "";
    constexpr double HEIGHT = 70, SHARES = 84;
    double most = 0;
    for (const FrameUse& frame : frames) most = std::max(most, frame.instructions);
    Plot plot{SHARES + HEIGHT, end_s, "Instructions and bus share per frame"};
    plot.name(10, fmt::format("{:.3g}", most));
    plot.name(HEIGHT, "instr.");
    plot.name(SHARES + 10, "100 %");
    plot.name(SHARES + HEIGHT, "share");
    plot.add("<path class=\"line\" d=\"{}\"/>\n",
             line(plot, frames, 2, HEIGHT - 2, most, [](auto& f) { return f.instructions; }));
    plot.add("<path class=\"line busy\" d=\"{}\"/>\n",
             line(plot, frames, SHARES, HEIGHT, 1, [](auto& f) { return f.busy_share; }));
    plot.add("<path class=\"line bus\" d=\"{}\"/>\n",
             line(plot, frames, SHARES, HEIGHT, 1, [](auto& f) { return f.bus_share; }));
    return plot.done();
}

}  // namespace sim::page
