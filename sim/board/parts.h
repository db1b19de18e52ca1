// parts.h - the parts that a scenario hangs on the headers, by their names
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/board/part_plan.h"

namespace sim {

class Parts {
public:
    Parts(const std::vector<PartPlan>& plans, PartSocket socket) : socket_{std::move(socket)} {
        for (const PartPlan& plan : plans)
            if (plan.hang) parts_[plan.name] = plan.hang(socket_);
    }

    // The wires have these levels from now on.
    void look(const HeaderMasks& levels, std::uint64_t time_ps) {
        for (auto& [name, part] : parts_) part->look(levels, time_ps);
    }

    // Throws std::out_of_range if there is none of that name.
    HeaderPart& get(const std::string& name) { return *parts_.at(name); }

    // Calls `action` with the name and the part of each of that kind.
    template <class Kind, class Action>
    void for_each(Action action) {
        for (auto& [name, part] : parts_)
            if (auto* const one = dynamic_cast<Kind*>(part.get())) action(name, *one);
    }

private:
    const PartSocket socket_;
    std::map<std::string, std::unique_ptr<HeaderPart>> parts_;
};

}  // namespace sim
