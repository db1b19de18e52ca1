// bench.cpp - make bench-collision: the broad phases beside their peers, each row with its target.
//
//     bench_collision            all rows, some minutes
//     bench_collision --quick    few and small worlds, once: only that it runs and all pairs agree
//
// Exit code 0, or 1 if any contender's pairs were not the reference's, or 2 for wrong usage.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>

#include "collision/broad_phase.h"
#include "race.h"
#include "table.h"

namespace {

using namespace bench;

using Wanted = std::map<unsigned, double>;  // by number of boxes

struct Plan {
    std::vector<unsigned> screens, worlds, special;  // numbers of boxes
    Limits limits;
};

const Plan FULL = {{10, 100, 200}, {1'000, 10'000, 100'000, 1'000'000}, {10'000, 100'000}, {4, 3}};
const Plan QUICK = {{10, 100}, {1'000}, {500}, {0, 1}};

// Enough for a median; few of the large ones, which fill the memory.
unsigned ticks(unsigned size) { return std::clamp(400'000 / size, 3u, 32u); }

std::vector<Entry> peers(unsigned size) {
    std::vector<Entry> all = cgal();
    if (size <= 100'000)
        for (const auto& more : {bullet(), box2d(), rtree()})
            all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::vector<Entry> with_peers(std::vector<Entry> ours, unsigned size) {
    for (const Entry& peer : peers(size)) ours.push_back(peer);
    return ours;
}

void print_row(const std::string& what, const std::vector<Result>& results, const char* ours,
               const char* theirs, std::optional<double> wanted = std::nullopt) {
    const auto them = best(results, theirs);
    print_ratio(what, best(results, ours)->ns_a_box, them ? them->name : theirs,
                them ? std::optional<double>(them->ns_a_box) : std::nullopt, wanted);
}

std::string title(const Workload& workload) {
    std::size_t pairs = 0;
    collision::PairList list;
    strips()->tick(workload.ticks[0], list);
    pairs = list.size();
    const auto size = workload.ticks[0].size();
    return fmt::format("{} {}, {:.2f} pairs per box", workload.name, size,
                       static_cast<double>(pairs) / static_cast<double>(size));
}

// As many shapes as a screen holds: no target, only which algorithm is the best.
void screens(const Plan& plan) {
    for (const unsigned size : plan.screens) {
        const Workload world = uniform(size, ticks(size));
        const auto results =
            race(world, {{"simd", simd}, {"strips", strips}, {"sweep", sweep}}, plan.limits);
        print_row("simd: " + title(world), results, "simd", "strips");
        print_row("", results, "simd", "sweep");
    }
}

void worlds(const Plan& plan) {
    const Wanted cgal_wanted = {{1'000, 10}, {10'000, 15}, {100'000, 25}, {1'000'000, 30}};
    const Wanted bullet_wanted = {{1'000, 25}, {10'000, 45}, {100'000, 150}};
    const Wanted box2d_wanted = {{1'000, 45}, {10'000, 85}, {100'000, 300}};
    std::map<unsigned, double> strips_ns;
    for (const unsigned size : plan.worlds) {
        const Workload world = uniform(size, ticks(size));
        const auto results = race(world, with_peers({{"strips", strips}}, size), plan.limits);
        strips_ns[size] = best(results, "strips")->ns_a_box;
        print_row("strips: " + title(world), results, "strips", "CGAL", cgal_wanted.at(size));
        if (!bullet_wanted.count(size)) continue;
        print_row("", results, "strips", "Bullet", bullet_wanted.at(size));
        print_row("", results, "strips", "Box2D", box2d_wanted.at(size));
    }
    print_limit(fmt::format("strips: ns per box at {} over {}", strips_ns.rbegin()->first,
                            strips_ns.begin()->first),
                strips_ns.rbegin()->second / strips_ns.begin()->second, "x", 2.5);
}

void special(const Plan& plan) {
    for (const unsigned size : plan.special) {
        for (const auto make : {clustered, heavy_tailed}) {
            const Workload world = make(size, ticks(size));
            const auto results =
                race(world, with_peers({{"strips", strips}, {"sweep", sweep}}, size), plan.limits);
            std::vector<Result> others;
            for (const Result& result : results)
                if (result.name != "strips" && result.name != "sweep") others.push_back(result);
            const auto them = best(others, "");
            print_ratio("strips: " + title(world), best(results, "strips")->ns_a_box,
                        them ? "best: " + them->name : "the best peer",
                        them ? std::optional<double>(them->ns_a_box) : std::nullopt, 3);
            print_row("", results, "strips", "sweep", 1);
        }
    }
}

void coherence(const Plan& plan) {
    for (const unsigned size : plan.special) {
        const Workload world = coherent(size, 4 * ticks(size));
        const auto results = race(world,
                                  {{"strips", strips},
                                   {"anew: strips", strips_anew},
                                   {"sweep", sweep},
                                   {"anew: sweep", sweep_anew}},
                                  plan.limits);
        print_row("strips: " + title(world), results, "strips", "anew: strips", 1);
        print_row("sweep: the same", results, "sweep", "anew: sweep", 1);
    }
}

void memory(const Plan& plan) {
    const unsigned size = plan.worlds.back();
    double most = 0;
    for (const auto make : {uniform, clustered, heavy_tailed}) {
        const Workload world = make(size, 1);
        collision::Strips algorithm;
        collision::PairList pairs;
        algorithm.find(world.ticks[0].data(), size, pairs);
        most = std::max(most, static_cast<double>(algorithm.bytes()) / size);
    }
    print_limit(fmt::format("strips: memory a box at {}", size), most, "bytes", 100);
}

}  // namespace

int main(int argc, char** argv) {
    const bool quick = argc == 2 && std::strcmp(argv[1], "--quick") == 0;
    if (argc > 1 && !quick) {
        fmt::print(stderr, "usage: bench_collision [--quick]\n");
        return 2;
    }
    const Plan& plan = quick ? QUICK : FULL;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try {
        print_header();
        screens(plan);
        worlds(plan);
        special(plan);
        coherence(plan);
        memory(plan);
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_collision: {}\n", error.what());
        return 1;
    }
}
