// live_view.h - the observer of a live run: all of it goes to the recorder, and over the wire.
//
// Pictures are sent as the tiles that differ from what was sent before.  While the other side does
// not read, pictures and sound are left out; texts and lamps are not.  For a program that plays,
// nothing is.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/live/text_stream.h"
#include "sim/live/wire.h"
#include "sim/run/recorder.h"

namespace sim::live {

class LiveView final : public BoardObserver {
public:
    LiveView(Recorder& recorder, Wire& wire) : recorder_{recorder}, wire_{wire} {}

    void frame(const Monitor::Frame& frame) override;
    void sample(std::int16_t left, std::int16_t right) override;
    void sample_rate(double hz) override;
    void console(char character, SerialLine line) override;
    void lamps(const Lamps& lamps, double time_s) override;
    void log(const std::string& line) override;

    // What a terminal among the parts shows.
    void terminal(const std::string& part, char character);

    // Sends what has gathered of sound, lamps and text.
    void flush();
    // The run is over, for these reasons.
    void end(const std::vector<std::string>& faults);

    // Called at each end of a frame.
    std::function<void()> on_frame = [] {};

    std::uint64_t frames() const { return frames_; }
    std::uint64_t new_pictures() const { return new_pictures_; }
    std::uint64_t printed() const { return printed_; }  // characters
    // How often LEDs or digits, and the headers' pins, were others than before.
    std::uint64_t lamps_seen() const { return lamps_seen_; }
    std::uint64_t pins_seen() const { return pins_seen_; }
    std::uint64_t sent_frame() const { return sent_frame_; }  // whose picture was the last; or 0

    // From now on the run waits for a slow reader.
    void leave_nothing_out() { waits_ = true; }

private:
    void send_picture(const Monitor::Frame& frame);
    bool has_room();

    Recorder& recorder_;
    Wire& wire_;
    std::uint64_t frames_ = 0, new_pictures_ = 0, printed_ = 0, lamps_seen_ = 0, pins_seen_ = 0,
                  sent_frame_ = 0;
    bool waits_ = false;
    unsigned width_ = 0, height_ = 0;
    std::vector<std::uint32_t> sent_;  // pixels
    std::string sound_;
    TextStream console_;                                     // of all lines
    std::array<TextStream, SERIAL_LINES.size()> terminals_;  // of each
    std::map<std::string, TextStream> part_terminals_;
    double rate_hz_ = 0;
    Lamps lamps_;
    bool lamps_moved_ = true;
};

}  // namespace sim::live
