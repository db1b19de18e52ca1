// main.cpp - a square, and the same square turned by 45 degrees, which comes nearer tick by tick.
#include <collision/contact.h>
#include <collision/detector.h>
#include <collision/fixed_box.h>
#include <collision/turn.h>

#include <cstdio>

using namespace collision;

int main() {
    constexpr Vec2 SQUARE[] = {{0, 0}, {8 * PIXEL, 0}, {8 * PIXEL, 8 * PIXEL}, {0, 8 * PIXEL}};
    constexpr Vec2 CENTRE = {4 * PIXEL, 4 * PIXEL};
    constexpr Turn EIGHTH = {46341, 46341};  // cosine and sine of 45 degrees, times 65536
    Polygon square;
    Aabb box;  // large enough for every turn about the centre, so it is not measured in every tick
    if (square.outline(SQUARE, 4) != Error::NONE) return 1;
    if (fixed_box(square, CENTRE, box) != Error::NONE) return 1;

    Detector detector;  // keeps its memory from tick to tick
    PairList pairs;
    std::vector<Contact> contacts;
    for (int tick = 0; tick < 4; ++tick) {
        const Vec2 by = {(12 - 2 * tick) * PIXEL, PIXEL};
        Polygon other = moved(turned(square, CENTRE, EIGHTH), by);
        other.aabb = moved(box, by);
        const std::vector<Polygon> shapes = {square, other};
        const Error error = detector.find(BEST, shapes, pairs);
        if (error != Error::NONE) return std::puts(text(error)), 1;
        find_contacts(shapes, pairs, contacts);
        for (const auto& [pair, at] : contacts)
            std::printf("tick %d: shapes %u and %u meet at %.2f, %.2f pixels\n", tick, pair.first,
                        pair.second, double(at.x) / PIXEL, double(at.y) / PIXEL);
    }
}
