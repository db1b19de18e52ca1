// greeting.h - what is sent of the run so far to a client that comes later.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace sim::live {

class Greeting {
public:
    // A text from the simulation, or that it has ended.
    void add(const std::string& text);
    void clear() { *this = {}; }

    // The last 20 aborts, faults and violations; the board, its lamps and parts as they are; the
    // last 32 KiB or more of what was printed in all and on each line; and the run's end.
    std::deque<std::string> texts() const;

private:
    static constexpr std::size_t MOST_EVENTS = 20;

    std::string board_, lamps_, console_, ended_;
    std::map<std::string, std::string> terminals_;
    nlohmann::json parts_;
    std::deque<std::string> events_;
};

}  // namespace sim::live
