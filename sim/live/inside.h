// inside.h - what goes on inside the board of a live run, for who watches it.
//
// Looks at counters of the models and at signals of the Verilog, in no time and without moving
// anything: a run that is watched is the same as one that is not.  The fabric's are those of the
// last time that it caught up, at most 32 us ago.
//
// Not handled: registers of the fabric other than the audio core's counts.  A read over the bridge
// takes clocks, which the program would notice.  Native firmware has no processor that counts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sim/board/board.h"
#include "sim/chip/program_system.h"
#include "sim/fpga/fabric.h"
#include "sim/report/report.h"

namespace sim::live {

class Inside {
public:
    // Of an ELF, beside what its processor knows.
    struct Program {
        std::string waiting;            // for what, or empty
        std::optional<FrameUse> frame;  // the last one
    };

    // `processor`, `fabric` and `program`: null where there is none.
    Inside(Board& board, ProgramSystem* processor, const Fabric* fabric,
           std::function<Program()> program)
        : board_{board}, processor_{processor}, fabric_{fabric}, program_{std::move(program)} {}

    // To be called once per millisecond: lamps that have stopped to flash are seen as they are.
    void settle_lamps() { board_.settle_lamps(); }

    // To be called at each end of a frame: bus accesses are counted from one to the next.
    void frame_ended();

    // The message "inside" of README.md.
    nlohmann::json look() const;
    // Violations and errors of the board's parts since the last call, a line each; of each part the
    // first 20.
    std::vector<std::string> new_violations();

private:
    Board& board_;
    ProgramSystem* const processor_;
    const Fabric* const fabric_;  // with the DE1-SoC Computer's audio core
    const std::function<Program()> program_;
    BusCounts then_, frame_;
    std::size_t sent_[3] = {};
};

}  // namespace sim::live
