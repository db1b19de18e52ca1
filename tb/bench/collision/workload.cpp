// workload.cpp - see workload.h
#include "workload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace bench {
namespace {

constexpr double PI = 3.14159265358979;
constexpr double WORLD = 1 << 23;   // sides of the square in which the boxes begin
constexpr double PAIRS = 1.5;       // per box
constexpr double MEAN_SIDE = 0.75;  // of sides between 0.5 and 1
constexpr double RATIO = 1000;      // of the largest side to the smallest

using Random = std::mt19937;

double between(Random& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

collision::Aabb box(double x, double y, double width, double height) {
    const auto at = [](double position) { return static_cast<std::int32_t>(std::floor(position)); };
    return {{at(x), at(y)}, {at(x + width), at(y + height)}};
}

// Two boxes of mean sides s that begin anywhere in a square of the area A overlap with a
// probability of (2 s)^2 / A; this is the s that makes it PAIRS pairs for each of `size` boxes.
double mean_side(unsigned size, double area) { return std::sqrt(PAIRS * 2 * area / size) / 2; }

struct Cluster {
    double x, y, deviation;
};

std::array<Cluster, 20> clusters() {
    Random random(7);
    std::array<Cluster, 20> made;
    for (Cluster& cluster : made)
        cluster = {between(random, WORLD / 4, WORLD * 3 / 4),
                   between(random, WORLD / 4, WORLD * 3 / 4),
                   between(random, WORLD / 200, WORLD / 30)};
    return made;
}

template <class Make>
Workload workload(const char* name, unsigned size, unsigned ticks, Make make) {
    Workload made = {name, {}};
    Random random(1);
    for (unsigned tick = 0; tick < ticks; ++tick) {
        Boxes& boxes = made.ticks.emplace_back();
        for (unsigned i = 0; i < size; ++i) boxes.push_back(make(random));
    }
    return made;
}

}  // namespace

Workload uniform(unsigned size, unsigned ticks) {
    const double side = mean_side(size, WORLD * WORLD) / MEAN_SIDE;
    return workload("uniform", size, ticks, [side](Random& random) {
        const double x = between(random, 0, WORLD), y = between(random, 0, WORLD);
        const double width = between(random, side / 2, side);
        return box(x, y, width, between(random, side / 2, side));
    });
}

// The clusters do not move.  Two points of one normal distribution of deviation d are as likely to
// be close as two in a square of the area 4 pi d^2.
Workload clustered(unsigned size, unsigned ticks) {
    const auto places = clusters();
    double density = 0;
    for (const Cluster& cluster : places)
        density += 1 / (4 * PI * cluster.deviation * cluster.deviation);
    const double side = mean_side(size, places.size() * places.size() / density) / MEAN_SIDE;
    return workload("clustered", size, ticks, [&places, side](Random& random) {
        const Cluster& cluster =
            places[std::uniform_int_distribution<std::size_t>(0, places.size() - 1)(random)];
        std::normal_distribution<double> off(0, cluster.deviation);
        const double x = std::clamp(cluster.x + off(random), 0.0, WORLD);
        const double y = std::clamp(cluster.y + off(random), 0.0, WORLD);
        const double width = between(random, side / 2, side);
        return box(x, y, width, between(random, side / 2, side));
    });
}

Workload heavy_tailed(unsigned size, unsigned ticks) {
    const double least = mean_side(size, WORLD * WORLD) / (std::log(RATIO) / (1 - 1 / RATIO));
    return workload("heavy-tailed", size, ticks, [least](Random& random) {
        const auto side = [least, &random] {  // the distribution function, inverted
            return least / (1 - between(random, 0, 1) * (1 - 1 / RATIO));
        };
        const double x = between(random, 0, WORLD), y = between(random, 0, WORLD);
        const double width = side();
        return box(x, y, width, side());
    });
}

Workload coherent(unsigned size, unsigned ticks) {
    Workload made = uniform(size, 1);
    made.name = "coherent";
    Random random(2);
    std::vector<collision::Vec2> steps;
    for (const auto& [min, max] : made.ticks[0]) {
        const double angle = between(random, 0, 2 * PI), way = (max.x - min.x) / 10.0;
        steps.push_back({static_cast<std::int32_t>(std::lround(way * std::cos(angle))),
                         static_cast<std::int32_t>(std::lround(way * std::sin(angle)))});
    }
    while (made.ticks.size() < ticks) {
        Boxes moved = made.ticks.back();
        for (unsigned i = 0; i < size; ++i) {
            moved[i].min = {moved[i].min.x + steps[i].x, moved[i].min.y + steps[i].y};
            moved[i].max = {moved[i].max.x + steps[i].x, moved[i].max.y + steps[i].y};
        }
        made.ticks.push_back(std::move(moved));
    }
    return made;
}

}  // namespace bench
