#include "bench/table1.h"

#include <algorithm>
#include <cstdio>

#include "bench/workload.h"
#include "collision/detector.h"

namespace bench {

namespace {

constexpr unsigned SIZE = 16;  // pixels
constexpr std::uint32_t LEAST_US = 2000;

using Film = std::vector<Tick>;

class Cell {
public:
    Cell(hal::Cpu& cpu, collision::Algorithm algorithm, const Film& film)
        : cpu_{cpu}, algorithm_{algorithm}, film_{film}, shapes_{film[0]} {}

    std::uint64_t nanoseconds() {
        (void)play(1, true);  // buffers and caches
        for (unsigned rounds = 1;; rounds *= 2) {
            const std::uint32_t with = play(rounds, true), without = play(rounds, false);
            if (with > without && with - without >= LEAST_US)
                return std::uint64_t{with - without} * 1000 / (rounds * film_.size());
        }
    }

private:
    // Microseconds for `rounds` times the whole film; each tick is first copied to the same place.
    std::uint32_t play(unsigned rounds, bool detect) {
        const std::uint32_t begin = cpu_.micros();
        for (; rounds > 0; --rounds)
            for (const Tick& tick : film_) {
                std::copy(tick.begin(), tick.end(), shapes_.begin());
                if (detect) (void)detector_.find(algorithm_, shapes_, pairs_);
            }
        return cpu_.micros() - begin;
    }

    hal::Cpu& cpu_;
    collision::Algorithm algorithm_;
    const Film& film_;
    Tick shapes_;
    collision::Detector detector_;
    collision::PairList pairs_;
};

void measure(hal::Cpu& cpu, app::Shape shape, unsigned inserted) {
    const Film ticks = film({shape, inserted, SIZE}, inserted >= 100 ? 4 : 16);
    for (const collision::Algorithm algorithm : collision::ALGORITHMS) {
        char line[80];
        std::snprintf(line, sizeof line, "%s,%u,%s,%llu\n", shape == app::Shape::X ? "X" : "square",
                      inserted, name(algorithm),
                      static_cast<unsigned long long>(Cell{cpu, algorithm, ticks}.nanoseconds()));
        cpu.print(line);
    }
}

}  // namespace

void table1(hal::Cpu& cpu) {
    for (const app::Shape shape : {app::Shape::SQUARE, app::Shape::X})
        for (const unsigned inserted : {1u, 10u, 100u, 200u}) measure(cpu, shape, inserted);
    cpu.print("table1 done\n");
}

}  // namespace bench
