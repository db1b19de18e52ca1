// page.h - a run on one page of HTML: nothing outside of it is needed, a script only adds comfort
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/page/film.h"
#include "sim/page/sound_log.h"
#include "sim/report/report.h"

namespace sim::page {

// What the console printed, with the time of each line's first character.
class ConsoleLog {
public:
    static constexpr std::size_t MOST_BYTES = 100'000;

    void print(double time_s, char character);

    struct Line {
        double time_s;
        std::string text;
    };
    const std::vector<Line>& lines() const { return lines_; }
    std::uint64_t left_out() const { return left_out_; }  // characters after them

private:
    std::vector<Line> lines_;
    std::size_t bytes_ = 0;
    std::uint64_t left_out_ = 0;
    bool begins_ = true;
};

// All that the page shows and report.json does not have.
struct Page {
    struct Picture {
        std::string name;  // of its file
        std::vector<std::uint8_t> png;
    };
    struct Step {
        int line = 0;
        std::string text;
        double from_s = 0, to_s = 0;
        bool begun = false;
        std::optional<bool> met = {};  // if it is an expectation
        std::string detail = {};
        std::uint64_t frame = 0;             // on the monitor when it was done; 0: not kept
        std::vector<Picture> pictures = {};  // that it has saved; of a golden that did not match
                                             // actual, expected and difference
    };
    std::string command, version;
    std::vector<Step> steps;
    Film film;
    SoundLog sound;
    ConsoleLog console;
    std::vector<FrameUse> frames;
};

std::string to_html(const RunReport& report, const Page& page);

}  // namespace sim::page
