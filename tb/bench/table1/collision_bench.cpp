// collision_bench.cpp - every algorithm on the paper's workload, by Google Benchmark.
//
//   collision_bench --benchmark_filter=simd/X
//
// Counters per iteration (a tick): pairs tested (boxes compared, pairs put into an axis' set, or
// polygons whose lines were tested, whichever is most), lines tested, pairs found.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/workload.h"
#include "collision/detector.h"

namespace {

using namespace collision;

constexpr unsigned TICKS = 24;

void count(benchmark::State& state, Algorithm algorithm, const std::vector<bench::Tick>& film) {
    CountingDetector detector;
    PairList pairs;
    double found = 0;
    for (const bench::Tick& tick : film) {
        (void)detector.find(algorithm, tick, pairs);
        found += static_cast<double>(pairs.size());
    }
    const Tally& tally = detector.counter;
    const auto tested = std::max({tally.box_tests, tally.interval_pairs, tally.polygon_tests});
    state.counters["pairs_tested"] = static_cast<double>(tested) / TICKS;
    state.counters["lines_tested"] = static_cast<double>(tally.line_tests) / TICKS;
    state.counters["pairs_found"] = found / TICKS;
}

void run(benchmark::State& state, Algorithm algorithm, app::Shape shape) {
    const auto film = bench::film({shape, static_cast<unsigned>(state.range(0)), 16}, TICKS);
    Detector detector;
    PairList pairs;
    unsigned next = 0;
    for (auto _ : state) {
        if (detector.find(algorithm, film[next], pairs) != Error::NONE)
            state.SkipWithError("a tick is refused");
        benchmark::DoNotOptimize(pairs.data());
        next = (next + 1) % TICKS;
    }
    count(state, algorithm, film);
}

}  // namespace

int main(int argc, char** argv) {
    for (const Algorithm algorithm : ALGORITHMS)
        for (const app::Shape shape : {app::Shape::SQUARE, app::Shape::X}) {
            const std::string label =
                std::string{name(algorithm)} + (shape == app::Shape::X ? "/X" : "/square");
            benchmark::RegisterBenchmark(
                label.c_str(), [algorithm, shape](auto& state) { run(state, algorithm, shape); })
                ->Arg(1)
                ->Arg(10)
                ->Arg(100)
                ->Arg(200);
        }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
}
