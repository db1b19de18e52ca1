// parts.h - the parts that people act on and observe, by their names
//
// Those of the board have names with a blank or a slash, which a scenario's parts cannot have; the
// list is in board.cpp.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/board/part_plan.h"

namespace sim {

class Parts {
public:
    // With those that a scenario hangs on the headers.
    Parts(const std::vector<PartPlan>& plans, PartSocket socket) : socket_{std::move(socket)} {
        for (const PartPlan& plan : plans) {
            if (!plan.hang) continue;
            on_headers_.push_back(plan.hang(socket_));
            add(plan.name, *on_headers_.back());
        }
    }

    // One of the board, which outlives this.
    void add(const std::string& name, Part& part) { parts_[name] = &part; }

    // The wires of the headers have these levels from now on.
    void look(const HeaderMasks& levels, std::uint64_t time_ps) {
        for (const auto& part : on_headers_) part->look(levels, time_ps);
    }

    // Throws std::out_of_range if there is none of that name.
    Part& get(const std::string& name) { return *parts_.at(name); }

    // Calls `action` with the name and the part of each of that kind.
    template <class Kind, class Action>
    void for_each(Action action) {
        for (const auto& [name, part] : parts_)
            if (auto* const one = dynamic_cast<Kind*>(part)) action(name, *one);
    }

private:
    const PartSocket socket_;
    std::vector<std::unique_ptr<HeaderPart>> on_headers_;
    std::map<std::string, Part*> parts_;
};

}  // namespace sim
