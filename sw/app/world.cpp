// world.cpp - see world.h
#include "app/world.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "gfx/canvas.h"

namespace app {
namespace {

using collision::PIXEL;
using collision::Vec2;

constexpr std::int32_t WIDTH = gfx::Canvas::WIDTH * PIXEL, HEIGHT = gfx::Canvas::HEIGHT * PIXEL;

constexpr gfx::Colour COLOURS[] = {gfx::rgb(255, 80, 80),   gfx::rgb(255, 160, 40),
                                   gfx::rgb(240, 220, 0),   gfx::rgb(80, 220, 80),
                                   gfx::rgb(0, 210, 210),   gfx::rgb(90, 140, 255),
                                   gfx::rgb(190, 110, 255), gfx::rgb(255, 110, 200)};

void insert(World& world, Shape shape) {
    world.last_shape = shape;
    if (world.count == World::CAPACITY) return;
    Random& random = world.random;
    Body& body = world.bodies[world.count++];
    body = {};
    body.shape = shape;
    body.size = static_cast<unsigned>(random.between(MIN_SIZE, MAX_SIZE));
    const std::int32_t margin = (static_cast<std::int32_t>(body.size) / 2 + 2) * PIXEL;
    body.position.x = random.between(margin, WIDTH - margin);
    body.position.y = random.between(margin, HEIGHT - margin);
    const Angle direction = random.next();
    const std::int64_t speed = random.between(PIXEL_PER_TICK / 2, PIXEL_PER_TICK * 3 / 2);
    body.velocity.x = static_cast<std::int32_t>(speed * cosine(direction) / SINE_ONE);
    body.velocity.y = static_cast<std::int32_t>(speed * sine(direction) / SINE_ONE);
    body.angle = random.next();
    body.spin = random.between(-(1 << 25), 1 << 25);  // up to 1/128 turn per tick
    body.colour = COLOURS[random.between(0, std::size(COLOURS) - 1)];
}

void press(World& world, char key) {
    switch (key) {
        case '1':
        case '2':
        case '3':
        case '4':
        case '5':
        case '6': insert(world, static_cast<Shape>(key - '1')); break;
        case '0':
            for (int i = 0; i < 10; ++i) insert(world, world.last_shape);
            break;
        case 'A': world.algorithm = next(world.algorithm); break;
        case 'B': world.paused = !world.paused; break;
        case 'C':
            world.count = 0;
            world.pairs_before.clear();  // their indices are no longer valid
            break;
        case 'D': world.show_boxes = !world.show_boxes; break;
        case 'E':
            if (world.speed_level > 0) --world.speed_level;
            break;
        case 'F':
            if (world.speed_level + 1 < World::SPEED_LEVELS) ++world.speed_level;
            break;
        default: break;
    }
}

void move(Body& body, unsigned speed_level) {
    const auto at_speed = [speed_level](std::int64_t a_tick) {
        return a_tick * (1 << speed_level) / (1 << World::NORMAL_SPEED);
    };
    constexpr std::int32_t TO_POSITION = PIXEL_PER_TICK / PIXEL;
    body.position.x += static_cast<std::int32_t>(at_speed(body.velocity.x) / TO_POSITION);
    body.position.y += static_cast<std::int32_t>(at_speed(body.velocity.y) / TO_POSITION);
    body.angle += static_cast<Angle>(at_speed(body.spin));
}

// The body's polygon; a body that would stick out of the screen is moved back in first.
collision::Polygon place(Body& body) {
    const auto outline = [&body] {
        return polygon(body.shape, body.position, body.angle, body.size);
    };
    const collision::Polygon placed = outline();
    const auto [min, max] = placed.aabb;
    const auto excess = [](std::int32_t low, std::int32_t high, std::int32_t size) {
        return low < 0 ? low : std::max(high - (size - 1), std::int32_t{0});
    };
    const Vec2 back = {-excess(min.x, max.x, WIDTH), -excess(min.y, max.y, HEIGHT)};
    if (back == Vec2{}) return placed;
    body.position = {body.position.x + back.x, body.position.y + back.y};
    return outline();
}

}  // namespace

World::World(std::uint32_t seed) : random{seed} {
    // The edges lie in the middle of the outermost pixels, with a tiny gap at the corners: so edges
    // never collide with each other, yet no corner of a shape fits between them.
    constexpr std::int32_t NEAR = PIXEL / 2, FAR_X = WIDTH - NEAR, FAR_Y = HEIGHT - NEAR;
    polygons[LEFT].lines[0] = {{NEAR, 0}, {NEAR, HEIGHT}};
    polygons[RIGHT].lines[0] = {{FAR_X, 0}, {FAR_X, HEIGHT}};
    polygons[TOP].lines[0] = {{NEAR + 1, NEAR}, {FAR_X - 1, NEAR}};
    polygons[BOTTOM].lines[0] = {{NEAR + 1, FAR_Y}, {FAR_X - 1, FAR_Y}};
    for (unsigned edge = 0; edge < EDGES; ++edge) {
        polygons[edge].count = 1;
        polygons[edge].update();
    }
}

void advance(World& world, const Input& input) {
    std::swap(world.pairs_before, world.pairs);
    world.pairs.clear();
    for (const char key : input.keys) press(world, key);
    for (unsigned i = 0; i < world.count; ++i) {
        Body& body = world.bodies[i];
        if (!world.paused) move(body, world.speed_level);
        world.polygons[EDGES + i] = place(body);
    }
    ++world.tick;
}

void find_pairs(World& world) {
    const collision::Polygons shapes{world.polygons.data(), EDGES + world.count};
    (void)world.detector.find(world.algorithm, shapes, world.pairs);  // all lie on the screen
}

void respond(World& world) {
    if (world.paused) return;
    for (const auto& [first, second] : world.pairs) {
        Body& body = world.bodies[second - EDGES];
        if (first < EDGES)
            bounce_off(static_cast<Edge>(first), body);
        else
            bounce(world.bodies[first - EDGES], body);
    }
}

void step(World& world, const Input& input) {
    advance(world, input);
    find_pairs(world);
    respond(world);
}

}  // namespace app
