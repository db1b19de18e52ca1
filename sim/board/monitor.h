// monitor.h - a VGA monitor: finds the picture in HS, VS, BLANK_N and the colours
//
//   pins --+--> FrameMeter --> lock_on --> Raster --> Frame
//          +--> VesaCheck
//
//              locks on to                     picture                       violations
//   STRICT     nothing: 640 x 480 at 60 Hz,    where BLANK_N is high         what is not VESA's
//              HS and VS negative, always
//   TOLERANT   any mode of video_mode.h, in    as picture_lock.h finds it    none
//              two frames that are alike
//
// A tolerant monitor shows the frames that are like those it has locked on to.  It loses the lock
// with the third frame in a row that is not, or when no frame has ended for 100 ms.  What it has
// locked on to is reported once per lock, a second without a lock once as "no signal".  A strict
// one measures and reports the same, and shows what it shows regardless.
//
// The samples are the pins before each rising edge of VGA_CLK, as the DAC takes them.  The time is
// the number of samples times the clock's period, unless idle() says more.
//
// Not handled: interlace, sync on green, composite sync, a line without its HS.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/board/frame_meter.h"
#include "sim/board/raster.h"
#include "sim/board/vesa_check.h"

namespace sim {

class Monitor {
public:
    enum class Strictness { STRICT, TOLERANT };

    struct Frame {
        std::uint64_t number;  // 1 is the first one since power-on
        bool is_new;  // its picture differs from the frame before, or it is the first of a lock
        const std::vector<std::uint32_t>& pixels;  // 0x00RRGGBB, row by row
        unsigned width, height;
    };
    using Sink = std::function<void(const Frame&)>;
    using Report = std::function<void(const std::string& line)>;

    // `has_blank`: the board has BLANK_N.
    explicit Monitor(Sink sink, Strictness strictness = Strictness::STRICT, Report report = {},
                     bool has_blank = true);

    // The period of the samples from the next one on, more than 0; without it that of our own
    // system's 25 MHz.  The lock is lost when it changes.
    void clock_ps(std::uint64_t period);
    // The pins, in order (bits: sim/fpga/fabric.h, video).
    void samples(const std::uint32_t* pins, std::size_t count);
    // There was no sample up to this time since power-on.  Nothing happens if it is in the past.
    void idle(std::uint64_t until_ps);

    // What was reported last: "640 x 480 at 59.5 Hz, HS and VS negative, 800 x 525 clocks", "out of
    // range: ..." or "no signal: ..."; empty before.
    const std::string& signal() const { return signal_; }

    // Why there is no picture.  Nothing is reported of that in the first second.
    std::string no_signal() const;

    // It has been notified of its pins, or that they stand still: there is something to look at.
    bool is_connected() const { return now_ps_ > 0; }

    std::uint64_t frames() const { return frames_; }
    std::uint64_t new_pictures() const { return new_pictures_; }

    // Of a strict monitor.
    std::uint64_t violations() const { return check_.violations(); }
    const std::vector<std::string>& messages() const { return check_.messages(); }

private:
    // Since the lock was lost or power came.
    struct Unlocked {
        std::uint64_t since_ps = 0, samples = 0, coloured = 0;
        std::uint64_t hs_edges = 0, vs_edges = 0;  // before that
        bool reported = false;
    };

    bool strict() const { return strictness_ == Strictness::STRICT; }
    void run_of(std::uint32_t control, const std::uint32_t* pins, unsigned count);
    void end_frame();
    void judge();
    void lock();
    void unlock();
    void look_at_the_time();
    void report(const std::string& line);

    Sink sink_;
    Strictness strictness_;
    Report report_;
    const bool has_blank_;

    VesaCheck check_;
    FrameMeter meter_;
    Raster raster_;
    std::uint32_t control_ = ~0u;  // HS, VS, BLANK_N of the sample before; ~0: none yet

    std::optional<VideoSignal> lock_;
    bool in_range_ = false;  // and the raster shows it
    VideoSignal before_;     // the frame before
    unsigned unlike_ = 0;    // frames in a row that are not like the lock's
    Unlocked unlocked_;
    std::string signal_;
    bool porch_reported_ = false;  // of this lock

    std::uint64_t sample_ps_, now_ps_ = 0, frame_ps_ = 0;  // frame_ps_: when the last frame ended
    std::uint64_t frames_ = 0, new_pictures_ = 0;
};

}  // namespace sim
