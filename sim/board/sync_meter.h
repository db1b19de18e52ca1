// sync_meter.h - one sync signal, HS or VS: where its pulses begin, whatever its polarity
//
//   negative  ------------____--------------------____--------     positive: the other way round
//                         ^ begin    period       ^ begin
//
// The pulse is at the level at which the signal is for the shorter time.  Of the times before a
// rise half is forgotten with it: a change of polarity is followed within three periods, and a few
// wrong samples change nothing.
//
// Not handled: composite sync, in which VS inverts HS.
#pragma once

#include <cstdint>

namespace sim {

class SyncMeter {
public:
    // The signal's level in the next `count` samples.  True: a pulse begins with the first of them.
    bool run(bool level, unsigned count);

    bool positive() const { return samples_at_[1] < samples_at_[0]; }
    // Samples since the last pulse began; before the first one, all of them.
    std::uint64_t since_begin() const { return since_begin_; }
    std::uint64_t edges() const { return edges_; }  // since power-on

private:
    bool known_ = false;  // there was a sample
    bool level_ = false;
    std::uint64_t samples_at_[2] = {0, 0};  // low, high
    std::uint64_t since_begin_ = 0, edges_ = 0;
};

}  // namespace sim
