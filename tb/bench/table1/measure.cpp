// measure.cpp - times every algorithm on the paper's workloads and writes one row per cell.
//
//   table1_measure BUILD SIZE COUNTS ALGORITHMS SECONDS >> CSV
//
// BUILD is a word for the first column; COUNTS and ALGORITHMS are separated by commas, "all" for
// all; SECONDS is the most that one workload may take.  A row with settled = no means that the
// machine was too noisy to know the median within 3 % in that time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/workload.h"
#include "collision/detector.h"
#include "tb/bench/table1/stopwatch.h"

namespace {

using namespace collision;
using namespace table1;
using namespace bench;

constexpr double BATCH_MS = 2, WANTED = 0.03;
constexpr unsigned MOST_BATCHES = 2000;

// Ticks of a film: as many as all algorithms can process in some seconds.
unsigned ticks_of(unsigned inserted) { return inserted > 1000 ? 4 : inserted >= 100 ? 24 : 64; }

// One algorithm on one workload.
struct Cell {
    Algorithm algorithm;
    Detector detector{};
    PairList pairs{};
    unsigned ticks = 0;  // per batch
    unsigned next = 0;   // tick of the film
    std::vector<double> clock_ms{}, fine_ms{};
    double spent_ms = 0;

    // The shapes are always at the same addresses, as in a program that moves them: each tick of
    // the film is first copied there.  The time of the copying alone is subtracted.
    void batch(const std::vector<Tick>& film) {
        Tick shapes = film[0];
        const auto play = [&](bool detect) {
            const CpuTime begin = CpuTime::now();
            for (unsigned i = 0, at = next; i < ticks; ++i) {
                std::copy(film[at].begin(), film[at].end(), shapes.begin());
                if (detect) (void)detector.find(algorithm, shapes, pairs);
                at = at + 1 < film.size() ? at + 1 : 0;
            }
            return CpuTime::now() - begin;
        };
        const CpuTime took = play(true) - play(false);
        next = (next + ticks) % static_cast<unsigned>(film.size());
        clock_ms.push_back(took.clock_ms / ticks);
        fine_ms.push_back(took.fine_ms / ticks);
        spent_ms += took.fine_ms;
    }

    bool settled() const { return spread(fine_ms).uncertainty < WANTED; }
};

// Runs once through the film: as warm-up, to check that all find the same pairs, and to choose the
// size of the batches.
void rehearse(Cell& cell, const std::vector<Tick>& film, std::vector<PairList>& expected) {
    const CpuTime begin = CpuTime::now();
    for (std::size_t i = 0; i < film.size(); ++i) {
        if (cell.detector.find(cell.algorithm, film[i], cell.pairs) != Error::NONE)
            throw std::runtime_error("a tick is refused");
        if (expected.size() == i) expected.push_back(cell.pairs);
        if (!(expected[i] == cell.pairs))
            throw std::runtime_error(fmt::format("{} finds other pairs", name(cell.algorithm)));
    }
    const double a_tick = (CpuTime::now() - begin).fine_ms / static_cast<double>(film.size());
    cell.ticks = static_cast<unsigned>(BATCH_MS / (a_tick + 1e-9)) + 1;
}

Tally counts(Algorithm algorithm, const std::vector<Tick>& film) {
    CountingDetector detector;
    PairList pairs;
    for (const Tick& tick : film) (void)detector.find(algorithm, tick, pairs);
    return detector.counter;
}

double average_pairs(const std::vector<PairList>& ticks) {
    double sum = 0;
    for (const PairList& pairs : ticks) sum += static_cast<double>(pairs.size());
    return sum / static_cast<double>(ticks.size());
}

void print_row(const char* build, const Workload& work, const Cell& cell, const Tally& tally,
               std::size_t ticks, double pairs) {
    const Spread fine = spread(cell.fine_ms);
    const auto a_tick = [ticks](std::uint64_t count) {
        return static_cast<double>(count) / static_cast<double>(ticks);
    };
    fmt::print("{},{},{},{},{},{:.7f},{:.7f},{:.7f},{:.7f},{:.4f},{},{},", build, work.size,
               work.shape == app::Shape::X ? "X" : "square", work.inserted, name(cell.algorithm),
               spread(cell.clock_ms).median, fine.median, fine.low, fine.high, fine.uncertainty,
               cell.fine_ms.size(), cell.settled() ? "yes" : "no");
    fmt::print("{:.1f},{:.1f},{:.1f},{:.1f},{:.1f},{:.1f}\n", a_tick(tally.box_tests),
               a_tick(tally.interval_pairs), a_tick(tally.polygon_tests), a_tick(tally.line_tests),
               a_tick(tally.copies), pairs);
    std::fflush(stdout);
}

// All algorithms in turn, one batch each, so that a slow moment of the machine affects all alike.
void measure(const char* build, const Workload& work, const std::vector<Algorithm>& algorithms,
             double seconds) {
    const std::vector<Tick> ticks = film(work, ticks_of(work.inserted));
    std::vector<PairList> expected;
    std::vector<Cell> cells;
    for (const Algorithm algorithm : algorithms) {
        cells.push_back({algorithm});
        rehearse(cells.back(), ticks, expected);
    }
    const double limit_ms = 1e3 * seconds / static_cast<double>(cells.size());
    for (bool more = true; more;) {
        more = false;
        for (Cell& cell : cells) {
            if (cell.fine_ms.size() >= 9 && cell.spent_ms > limit_ms) continue;
            if (cell.fine_ms.size() >= MOST_BATCHES) continue;
            cell.batch(ticks);
            more |= !cell.settled();
        }
    }
    for (const Cell& cell : cells)
        print_row(build, work, cell, counts(cell.algorithm, ticks), ticks.size(),
                  average_pairs(expected));
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream in{text};
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

unsigned number(const std::string& text) {
    char* end = nullptr;
    const unsigned long value = std::strtoul(text.c_str(), &end, 10);
    if (text.empty() || *end || value == 0 || value > 100'000)
        throw std::runtime_error("not a number from 1 to 100000: " + text);
    return static_cast<unsigned>(value);
}

std::vector<Algorithm> algorithms(const std::string& text) {
    std::vector<Algorithm> found;
    if (text == "all") return {ALGORITHMS.begin(), ALGORITHMS.end()};
    for (const std::string& word : split(text)) {
        const auto algorithm = algorithm_named(word);
        if (!algorithm) throw std::runtime_error("no algorithm is called " + word);
        found.push_back(*algorithm);
    }
    return found;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 6) {
        fmt::print(stderr, "usage: table1_measure BUILD SIZE COUNTS ALGORITHMS SECONDS\n");
        return 2;
    }
    for (const std::string& count : split(argv[3]))
        for (const app::Shape shape : {app::Shape::SQUARE, app::Shape::X})
            measure(argv[1], {shape, number(count), number(argv[2])}, algorithms(argv[4]),
                    number(argv[5]));
} catch (const std::exception& e) {
    fmt::print(stderr, "table1_measure: {}\n", e.what());
    return 2;
}
