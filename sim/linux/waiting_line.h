// waiting_line.h - threads that wait for the same thing, in the order in which they came.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <utility>

namespace sim {

class WaitingLine {
public:
    // Whoever holds one waits; one that is let go of, however its thread's wait ended, is left.
    using Place = std::shared_ptr<const std::function<bool()>>;

    // The last one; `could_go`: what there is would end its wait.
    Place join(std::function<bool()> could_go) {
        auto place = std::make_shared<const std::function<bool()>>(std::move(could_go));
        places_.push_back(place);
        return place;
    }
    // None of those before it could; without a place, none at all.
    bool has_turn(const Place& place) const {
        for (const auto& entry : places_) {
            const Place other = entry.lock();
            if (place && other == place) return true;
            if (other && (*other)()) return false;
        }
        return true;
    }
    std::size_t size() const {
        std::size_t count = 0;
        for (const auto& entry : places_) count += !entry.expired();
        return count;
    }
    void forget_gone() {
        places_.remove_if([](const auto& entry) { return entry.expired(); });
    }

private:
    std::list<std::weak_ptr<const std::function<bool()>>> places_;
};

}  // namespace sim
