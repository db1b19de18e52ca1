#include "sim/board/sync_meter.h"

namespace sim {

bool SyncMeter::run(bool level, unsigned count) {
    const bool moved = known_ && level != level_;
    const bool begins = moved && level == positive();
    if (moved) {
        ++edges_;
        if (level)
            for (std::uint64_t& samples : samples_at_) samples /= 2;
        if (begins) since_begin_ = 0;
    }
    known_ = true;
    level_ = level;
    samples_at_[level] += count;
    since_begin_ += count;
    return begins;
}

}  // namespace sim
