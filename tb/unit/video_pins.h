// video_pins.h - the VGA pins of a video signal, sample by sample, and a monitor that looks at them
//
// Clocks and lines are counted as modelines do: the picture is at 0, then comes the sync.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "sim/board/monitor.h"
#include "sim/fpga/fabric.h"
#include "tb/unit/video_modelines.h"

namespace tb {

struct VideoPins {
    enum class Blank { PICTURE, HIGH, LOW, SYNCS, WINDOW };

    Modeline mode = VGA;
    Blank blank = Blank::PICTURE;
    double sample_mhz = 0;                // 0: the pixel clock
    int vs_late = 0;                      // clocks from the begin of HS to that of VS
    unsigned window_w = 0, window_h = 0;  // where BLANK_N is high for WINDOW, from the corner
    // Whatever is wrong with the pins at a clock.
    std::function<std::uint32_t(std::uint64_t clock, std::uint32_t pins)> fault = {};

    double period_ps() const { return 1e6 / (sample_mhz != 0 ? sample_mhz : mode.mhz); }

    static std::uint32_t colour(std::uint64_t x, std::uint64_t y) {
        return static_cast<std::uint32_t>((x * 3 + y * 7 + 1) % 256 << 16 | x % 256 << 8 | y % 256);
    }

    // 0 is the first clock of a picture.
    std::uint32_t at(std::uint64_t clock) const {
        const Modeline& m = mode;
        const std::uint64_t x = clock % m.htotal, y = clock / m.htotal % m.vtotal;
        const bool hs = x >= m.hsyncstart && x < m.hsyncend;
        // VS begins with the HS that comes before the line that is counted as its first.
        const std::uint64_t vs_begin = std::uint64_t{m.vsyncstart - 1} * m.htotal + m.hsyncstart;
        const std::uint64_t from_vs =
            (clock + 2 * m.clocks() - vs_begin - static_cast<std::uint64_t>(vs_late)) % m.clocks();
        const bool vs = from_vs < std::uint64_t{m.vsyncend - m.vsyncstart} * m.htotal;
        const bool shown = x < m.hdisp && y < m.vdisp;
        bool blank_n = shown;
        switch (blank) {
            case Blank::PICTURE: break;
            case Blank::HIGH: blank_n = true; break;
            case Blank::LOW: blank_n = false; break;
            case Blank::SYNCS: blank_n = !hs && !vs; break;
            case Blank::WINDOW: blank_n = x < window_w && y < window_h; break;
        }
        std::uint32_t pins = shown ? colour(x, y) : 0;
        if (hs == m.hpositive) pins |= sim::video::HS;
        if (vs == m.vpositive) pins |= sim::video::VS;
        if (blank_n) pins |= sim::video::BLANK_N;
        return fault ? fault(clock, pins) : pins;
    }
};

class MonitorBench : public ::testing::Test {
protected:
    struct Picture {
        unsigned width, height;
        std::vector<std::uint32_t> pixels;
        std::uint32_t at(unsigned x, unsigned y) const { return pixels.at(y * width + x); }
    };

    std::vector<Picture> pictures;
    std::vector<bool> is_new;
    std::vector<std::string> reported;
    sim::Monitor monitor;

    explicit MonitorBench(sim::Monitor::Strictness how = sim::Monitor::Strictness::TOLERANT)
        : monitor{[this](const sim::Monitor::Frame& f) {
                      EXPECT_EQ(f.number, pictures.size() + 1);
                      pictures.push_back({f.width, f.height, f.pixels});
                      is_new.push_back(f.is_new);
                  },
                  how, [this](const std::string& line) { reported.push_back(line); }} {}

    // From the middle of a picture on, for so many frames and a bit, in batches of odd lengths.
    void show(const VideoPins& video, unsigned frames) {
        monitor.clock_ps(static_cast<std::uint64_t>(video.period_ps() + 0.5));
        const double clocks_per_sample = video.mode.mhz * video.period_ps() * 1e-6;
        const std::uint64_t begin = video.mode.clocks() / 2;
        const auto samples = static_cast<std::uint64_t>(static_cast<double>(video.mode.clocks()) *
                                                        (frames + 0.2) / clocks_per_sample);
        std::vector<std::uint32_t> pins;
        for (std::uint64_t i = 0; i < samples; ++i) {
            // The pixel clock runs a tenth of a clock after the samples.
            const auto clock = static_cast<std::uint64_t>(
                static_cast<double>(i) * clocks_per_sample + 0.1 * clocks_per_sample);
            pins.push_back(video.at(begin + clock));
            if (pins.size() == 777 || i + 1 == samples) {
                monitor.samples(pins.data(), pins.size());
                pins.clear();
            }
        }
    }
    // All pixels of the last picture that are not as `expected`.
    unsigned wrong_pixels(const std::function<std::uint32_t(unsigned x, unsigned y)>& expected =
                              VideoPins::colour) const {
        if (pictures.empty()) return ~0u;
        const Picture& picture = pictures.back();
        unsigned wrong = 0;
        for (unsigned y = 0; y < picture.height; ++y)
            for (unsigned x = 0; x < picture.width; ++x)
                wrong += picture.at(x, y) != expected(x, y);
        return wrong;
    }
    std::pair<unsigned, unsigned> size() const {
        if (pictures.empty()) return {0, 0};
        return {pictures.back().width, pictures.back().height};
    }
};

}  // namespace tb
