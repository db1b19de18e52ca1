// race.cpp - see race.h
#include "race.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "reference.h"

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

double ns(Clock::duration duration) {
    return std::chrono::duration<double, std::nano>(duration).count();
}

struct Lane {
    std::string name;
    std::unique_ptr<Contender> contender;
    std::vector<double> times;  // ns per tick
};

// The data of an application: its boxes, which it has just moved, and one list of pairs.
struct Application {
    Boxes boxes;
    collision::PairList pairs;
};

// First all ticks, then the check of their pairs: checking in between would evict the caches.  The
// first tick finds the caches filled by the previous contender, and is not counted.
std::vector<double> round(Lane& lane, const Workload& workload, Application& application,
                          std::vector<collision::PairList>& found,
                          const std::vector<collision::PairList>& truth) {
    std::vector<double> times;
    for (std::size_t tick = 0; tick < workload.ticks.size(); ++tick) {
        application.boxes = workload.ticks[tick];
        const auto start = Clock::now();
        lane.contender->tick(application.boxes, application.pairs);
        const auto end = Clock::now();
        if (tick > 0) times.push_back(ns(end - start));
        found[tick] = application.pairs;
    }
    for (std::size_t tick = 0; tick < workload.ticks.size(); ++tick)
        if (!agrees(found[tick], truth[tick]))
            throw std::runtime_error(lane.name + " found " + std::to_string(found[tick].size()) +
                                     " pairs in a " + workload.name + " world that has " +
                                     std::to_string(truth[tick].size()));
    return times;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

std::vector<Result> race(const Workload& workload, const std::vector<Entry>& entries,
                         const Limits& limits) {
    std::vector<collision::PairList> truth, found(workload.ticks.size());
    for (const Boxes& boxes : workload.ticks) truth.push_back(reference(boxes));
    std::vector<Lane> lanes;
    for (const Entry& entry : entries) lanes.push_back({entry.name, entry.make(), {}});

    Application application;
    for (Lane& lane : lanes) round(lane, workload, application, found, truth);
    const auto start = Clock::now();
    for (unsigned rounds = 0;
         rounds < limits.rounds || ns(Clock::now() - start) < limits.seconds * 1e9; ++rounds)
        for (Lane& lane : lanes)
            for (const double time : round(lane, workload, application, found, truth))
                lane.times.push_back(time);

    std::vector<Result> results;
    const auto boxes = static_cast<double>(workload.ticks[0].size());
    for (const Lane& lane : lanes) results.push_back({lane.name, median(lane.times) / boxes});
    return results;
}

std::optional<Result> best(const std::vector<Result>& results, const std::string& name) {
    std::optional<Result> least;
    for (const Result& result : results)
        if (result.name.rfind(name, 0) == 0 && (!least || result.ns_a_box < least->ns_a_box))
            least = result;
    return least;
}

}  // namespace bench
