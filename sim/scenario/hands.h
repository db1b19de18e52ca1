// hands.h - a person who presses a control again lets go of it for a while.
//
// A press that follows the release of the same control at the same instant comes 50 ms later.  With
// time between them, however short, they are where the scenario has them.
#pragma once

#include <map>
#include <string>

#include <systemc>

namespace sim {

class Hands {
public:
    static sc_core::sc_time pause() { return {50, sc_core::SC_MS}; }

    // Controls by any names.
    void let_go(const std::string& control) { let_go_[control] = sc_core::sc_time_stamp(); }
    bool has_just_let_go(const std::string& control) const {
        const auto found = let_go_.find(control);
        return found != let_go_.end() && found->second == sc_core::sc_time_stamp();
    }

private:
    std::map<std::string, sc_core::sc_time> let_go_;  // when
};

}  // namespace sim
