// running_program.h - test fixture: the program on the board, and a replay that keeps up with it.
#pragma once

#include <algorithm>
#include <string>

#include "app/app.h"
#include "sim/scenario/controls.h"
#include "tb/system/replay.h"

namespace tb {

class RunningProgram : public WholeBoard {
protected:
    std::unique_ptr<Replay> replay;

    // Powers on with SW9-SW0 as given and runs to the program's first picture.
    void start(std::uint16_t switches = 0) {
        power_on(app::run);
        board->hold(0, 0, switches);
        replay = std::make_unique<Replay>(1 + switches);
        Picture first = next_picture();
        while (is_black(first)) {
            ASSERT_LE(first.number, 2u) << "the program shows nothing";
            first = next_picture();
        }
        ASSERT_TRUE(replay->follow(first));
        after_picture();
    }

    // The next `count` pictures, each of which has to be exactly one tick on.
    void follow(unsigned count) {
        for (; count > 0; --count) {
            const Picture picture = next_picture();
            ASSERT_TRUE(replay->follow(picture))
                << "frame " << picture.number << ", tick " << replay->world().tick + 1 << ": "
                << replay->differing_pixels() << " pixels differ";
            after_picture();
        }
    }

    // Presses and releases the keys one after the other.
    void press(const std::string& caps) {
        for (const char cap : caps) {
            const auto key = static_cast<std::uint16_t>(1u << *sim::keypad_key(cap));
            replay->expect_key(cap);
            board->hold(key, 0, 0);
            ASSERT_NO_FATAL_FAILURE(follow(2));
            board->release(key, 0, 0);
            ASSERT_NO_FATAL_FAILURE(follow(1));
            ASSERT_FALSE(replay->key_is_due()) << "key " << cap << " had no effect";
        }
    }

    // Called with the replay at the tick that the monitor has just shown.
    virtual void after_picture() {}

private:
    static bool is_black(const Picture& picture) {
        return std::all_of(picture.pixels.begin(), picture.pixels.end(),
                           [](std::uint32_t pixel) { return pixel == 0; });
    }
};

}  // namespace tb
