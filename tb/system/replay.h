// replay.h - the same world as the firmware's, stepped in time with the pictures on the monitor.
//
// Which tick takes a key depends on the contacts' bounce.  So a picture may be that of the next
// tick with or without the expected key; the replay accepts either.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/draw.h"
#include "app/world.h"
#include "tb/support/whole_board.h"

namespace tb {

class Replay {
public:
    explicit Replay(std::uint32_t seed) : world_{seed} {}

    const app::World& world() const { return world_; }

    // The pairs are to be found by the algorithm that is not the chosen one.
    void use_the_other_algorithm() { other_ = true; }

    // The key that will be pressed; the previous one must have been taken.
    void expect_key(char key) { key_ = key; }
    bool key_is_due() const { return key_ != 0; }

    // True if every pixel of `picture` is the one of the next tick; `world` is then at that tick.
    bool follow(const Picture& picture) {
        differing_ = 0;
        if (try_step("", picture)) return true;
        if (!key_ || !try_step({key_}, picture)) return false;
        key_ = 0;
        return true;
    }

    // Of the last picture that was not followed.
    unsigned differing_pixels() const { return differing_; }

private:
    static constexpr int WIDTH = gfx::Canvas::WIDTH, HEIGHT = gfx::Canvas::HEIGHT;
    static constexpr int TEXT_ROWS = 16;

    bool try_step(const std::string& keys, const Picture& picture) {
        app::World next = world_;
        app::advance(next, {keys});
        const collision::Algorithm chosen = next.algorithm;
        if (other_) next.algorithm = collision::next(chosen);
        app::find_pairs(next);
        next.algorithm = chosen;
        app::respond(next);
        app::draw(next, {time_on(picture, next)}, canvas_);
        differing_ = differing(picture, HEIGHT);
        if (differing_ == 0) world_ = next;
        return differing_ == 0;
    }

    // The time of a tick depends on the processor, so it is read from the picture, digit by digit.
    std::uint32_t time_on(const Picture& picture, const app::World& world) {
        std::uint32_t time_us = 0;
        for (const std::uint32_t weight_us : {1000u, 100u, 10u}) {
            unsigned fewest = ~0u, best = 0;
            for (unsigned digit = 0; digit < 10; ++digit) {
                app::draw(world, {time_us + digit * weight_us}, canvas_);
                const unsigned wrong = differing(picture, TEXT_ROWS);
                if (wrong < fewest) fewest = wrong, best = digit;
            }
            time_us += best * weight_us;
        }
        return time_us;
    }

    // Each pixel is shown 2 x 2; colours are widened by repeating their top bits.
    static std::uint32_t shown(gfx::Colour colour) {
        const std::uint32_t red = colour >> 11, green = colour >> 5 & 0x3f, blue = colour & 0x1f;
        return (red << 3 | red >> 2) << 16 | (green << 2 | green >> 4) << 8 |
               (blue << 3 | blue >> 2);
    }

    unsigned differing(const Picture& picture, int rows) const {
        unsigned count = 0;
        for (int y = 0; y < 2 * rows; ++y) {
            const std::uint32_t* pixel = &picture.pixels[static_cast<unsigned>(y * 2 * WIDTH)];
            const gfx::Colour* row = canvas_.row(y / 2);
            for (int x = 0; x < 2 * WIDTH; ++x) count += pixel[x] != shown(row[x / 2]);
        }
        return count;
    }

    app::World world_;
    gfx::Canvas canvas_;
    bool other_ = false;
    char key_ = 0;
    unsigned differing_ = 0;
};

}  // namespace tb
