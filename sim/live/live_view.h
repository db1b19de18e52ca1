// live_view.h - the audience of a live run: all of it goes to the recorder, and over the wire.
//
// Pictures are sent as the tiles that differ from what was sent before.  While the other side does
// not read, pictures and sound are left out; texts and lamps are not.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/live/text_stream.h"
#include "sim/live/wire.h"
#include "sim/run/recorder.h"

namespace sim::live {

class LiveView final : public Audience {
public:
    LiveView(Recorder& recorder, Wire& wire) : recorder_{recorder}, wire_{wire} {}

    void frame(const Monitor::Frame& frame) override;
    void sample(std::int16_t left, std::int16_t right) override;
    void sample_rate(double hz) override;
    void console(char character, SerialLine line) override;
    void lamps(const Lamps& lamps, double time_s) override;
    void log(const std::string& line) override;

    // Sends what has gathered of sound, lamps and text.
    void flush();
    // The run is over, for these reasons.
    void end(const std::vector<std::string>& faults);

    // Called at each end of a frame.
    std::function<void()> on_frame = [] {};

    std::uint64_t frames() const { return frames_; }
    std::uint64_t new_pictures() const { return new_pictures_; }

private:
    void send_picture(const Monitor::Frame& frame);

    Recorder& recorder_;
    Wire& wire_;
    std::uint64_t frames_ = 0, new_pictures_ = 0;
    unsigned width_ = 0, height_ = 0;
    std::vector<std::uint32_t> sent_;  // pixels
    std::string sound_;
    TextStream console_;                                     // of all lines
    std::array<TextStream, SERIAL_LINES.size()> terminals_;  // of each
    double rate_hz_ = 0;
    Lamps lamps_;
    bool lamps_moved_ = true;
};

}  // namespace sim::live
