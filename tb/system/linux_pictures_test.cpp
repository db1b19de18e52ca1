// linux_pictures_test.cpp - one scenario on three processors shows the same pictures.
#include <gmock/gmock.h>

#include <algorithm>
#include <future>

#include "gfx/font.h"
#include "sim/files/png.h"
#include "tb/system/cli.h"

namespace {

// Thirty-four shapes, two algorithms, faster, with boxes, paused and cleared, in three seconds.
//
// Keys are pressed where a frame begins.  The scanner starts when the program enables it, at a time
// that depends on the processor.  So the times at which it reports a key differ by up to a scan,
// 0.2 ms.  A key is pressed at a frame's begin and reported after 5 ms of bounce and 5 ms of
// debounce: then all processors read it in the same tick.  Close to a frame's end they might not.
constexpr const char* MANY_KEYS =
    "duration: 3s\nsteps:\n"
    "  - wait-frame: next\n  - press: {keypad: \"2\", for: 60ms}\n"
    "  - delay: 60ms\n"
    "  - wait-frame: next\n  - press: {keypad: [\"1\", \"5\"], for: 60ms}\n"
    "  - delay: 60ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"0\", for: 60ms}\n"
    "  - delay: 60ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"3\", for: 60ms}\n"
    "  - delay: 60ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"0\", for: 60ms}\n"
    "  - delay: 60ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"0\", for: 60ms}\n"
    "  - delay: 300ms\n"
    "  - expect-hex: \"    34\"\n"
    "  - wait-frame: next\n  - press: {keypad: \"A\", for: 60ms}\n"
    "  - delay: 200ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"D\", for: 60ms}\n"
    "  - delay: 200ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"F\", for: 60ms}\n"
    "  - delay: 300ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"B\", for: 60ms}\n"
    "  - delay: 100ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"B\", for: 60ms}\n"
    "  - delay: 300ms\n"
    "  - wait-frame: next\n  - press: {keypad: \"C\", for: 60ms}\n"
    "  - delay: 60ms\n";

class Pictures : public tb::CommandLine {
protected:
    std::filesystem::path played(const std::string& name,
                                 const std::vector<std::string>& cpu) const {
        const std::filesystem::path to = folder / name;
        std::vector<std::string> arguments{"run", "s.yaml", "--quiet",   "--frames",
                                           "all", "--out",  to.string(), "--cpu"};
        arguments.insert(arguments.end(), cpu.begin(), cpu.end());
        tb::Command command;
        const tb::Outcome outcome = de1sim(arguments, command);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return to;
    }
};

// The area of the tick's time: from after the shortest text before it to the end of the longest
// time, and as high as the text with its background; pixels are shown 2 x 2.
bool shows_time(unsigned x, unsigned y) {
    constexpr unsigned MARGIN = 5;
    const unsigned begin = MARGIN + gfx::text_width("1 shape  simd  ");
    const unsigned end = MARGIN + gfx::text_width("100 shapes  original  999.99 ms") + 1;
    return x >= 2 * begin && x < 2 * end && y >= 2 * (MARGIN - 2) &&
           y < 2 * (MARGIN + gfx::CELL_HEIGHT);
}

unsigned pixels_that_differ(const sim::Image& a, const sim::Image& b) {
    unsigned count = 0;
    for (unsigned y = 0; y < a.height; ++y)
        for (unsigned x = 0; x < a.width; ++x) {
            const std::size_t at = 3 * (std::size_t{y} * a.width + x);
            const bool same = std::equal(&a.rgb[at], &a.rgb[at] + 3, &b.rgb[at]);
            if (!same && !shows_time(x, y)) ++count;
        }
    return count;
}

TEST_F(Pictures, AreTheSameTickByTickOnEveryProcessor) {
    const auto start = [this](const std::string& name, const std::vector<std::string>& cpu) {
        return std::async(std::launch::async, [=] { return played(name, cpu); });
    };
    scenario(MANY_KEYS);
    auto first = start("native", {"native"});
    auto second = start("bare", {"arm", "--elf", FIRMWARE "collide.elf"});
    auto third = start("linux", {"arm", "--elf", FIRMWARE "collide-linux"});
    const auto native = first.get(), bare = second.get(), on_linux = third.get();
    unsigned compared = 0;
    for (unsigned number = 1; number <= 178; ++number) {
        const sim::Image expected = sim::read_png(native / frame(number));
        for (const auto& other : {bare, on_linux})
            EXPECT_EQ(pixels_that_differ(expected, sim::read_png(other / frame(number))), 0u)
                << other.filename() << ", frame " << number;
        ++compared;
    }
    EXPECT_EQ(compared, 178u);
}

}  // namespace
