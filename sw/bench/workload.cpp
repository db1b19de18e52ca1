#include "bench/workload.h"

#include <algorithm>
#include <cmath>

#include "app/random.h"

namespace bench {

namespace {

using collision::PIXEL;
using collision::Polygon;
using collision::Vec2;

struct Flying {
    Vec2 at, way;  // grid units; grid units per tick
    app::Angle angle;
    std::int32_t spin;
};

Polygon line(Vec2 a, Vec2 b) {
    Polygon edge;
    edge.lines[0] = {a, b};
    edge.count = 1;
    edge.update();
    return edge;
}

void fly(std::int32_t& at, std::int32_t& way, std::int32_t low, std::int32_t high) {
    at += way;
    if (at < low || at > high) way = -way, at = std::clamp(at, low, high);
}

}  // namespace

std::vector<Tick> film(const Workload& workload, unsigned ticks) {
    const double larger = std::sqrt(std::max(1.0, workload.inserted / 200.0));
    const auto width = static_cast<std::int32_t>(320 * larger) * PIXEL;
    const auto height = static_cast<std::int32_t>(240 * larger) * PIXEL;
    const auto margin = static_cast<std::int32_t>(workload.size) * PIXEL / 2;
    app::Random random{workload.inserted};
    std::vector<Flying> all(workload.inserted);
    for (Flying& one : all)
        one = {{random.between(margin, width - margin), random.between(margin, height - margin)},
               {random.between(-PIXEL, PIXEL), random.between(-PIXEL, PIXEL)},
               random.next(),
               random.between(-(1 << 25), 1 << 25)};

    constexpr std::int32_t NEAR = PIXEL / 2;
    const std::int32_t right = width - NEAR, bottom = height - NEAR;
    std::vector<Tick> made(ticks);
    for (Tick& tick : made) {
        tick = {line({NEAR, 0}, {NEAR, height}), line({right, 0}, {right, height}),
                line({NEAR + 1, NEAR}, {right - 1, NEAR}),
                line({NEAR + 1, bottom}, {right - 1, bottom})};
        for (Flying& one : all) {
            fly(one.at.x, one.way.x, margin, width - margin);
            fly(one.at.y, one.way.y, margin, height - margin);
            one.angle += static_cast<app::Angle>(one.spin);
            tick.push_back(app::polygon(workload.shape, one.at, one.angle, workload.size));
        }
    }
    return made;
}

}  // namespace bench
