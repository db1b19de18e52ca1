// parts_view.h - the parts on the page of a live run: those that a scenario has hung on the
// headers, and displays of the board
//
// What a part shows and how a person acts on it, the part itself says (board/header_part.h,
// board/part_plan.h); neither this nor the page knows any kind of part but the terminal.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/board/parts.h"
#include "sim/live/wire.h"

namespace sim::live {

class PartsView {
public:
    PartsView(Parts& parts, const std::vector<PartPlan>& plans, Wire& wire);

    // Sends what is seen otherwise than before; a display is looked at 60 times per simulated
    // second, or now if `all`.
    void flush(std::uint64_t time_ps, bool all);

private:
    struct Shown {
        Part* part;
        std::vector<std::string> rows;
        DisplayPicture picture;
    };

    Wire& wire_;
    std::map<std::string, Shown> shown_;
    std::uint64_t displays_at_ps_ = 0;  // when they are looked at next
};

}  // namespace sim::live
