// recorder.h - the observer that writes everything down: pictures, sound, console.
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/board/board.h"
#include "sim/files/console_file.h"
#include "sim/files/frame_writer.h"
#include "sim/files/wav.h"
#include "sim/page/page.h"
#include "sim/run/description.h"
#include "sim/run/lamp_log.h"
#include "sim/run/output_folder.h"
#include "sim/run/program_output.h"
#include "sim/scenario/observations.h"
#include "sim/video/video.h"

namespace sim {

// A failure to write pauses SystemC and is kept for close(): nothing may be thrown through it.
class Recorder : public BoardObserver {
public:
    // Makes and locks the folder, see OutputFolder.  IoError.
    Recorder(const std::filesystem::path& out, FrameChoice frames,
             const std::filesystem::path& video);  // or empty

    void frame(const Monitor::Frame& frame) override;
    void sample(std::int16_t left, std::int16_t right) override;
    void sample_rate(double hz) override;
    void console(char character, SerialLine line) override;  // all in one
    void lamps(const Lamps& lamps, double time_s) override { lamp_log_.show(lamps, time_s); }
    // To stderr as it comes, and kept; from the 21st line on they are only counted.
    void log(const std::string& line) override;

    const std::vector<std::string>& log() const { return log_; }
    std::uint64_t log_lines() const { return log_lines_; }
    // Called at the end of each frame that the monitor shows.
    std::function<void()> on_frame = [] {};
    Observations& observations() { return observations_; }
    // Keeps for a page what passes by, if there is one.
    page::Page* page = nullptr;
    // Prints what the program does, if there is one.
    ProgramOutput* output = nullptr;
    // SHA-256 of the first new pictures, by the numbers of their frames.
    const std::vector<std::pair<std::uint64_t, std::string>>& pictures() const { return pictures_; }
    const LampLog& lamp_log() const { return lamp_log_; }
    bool failed() const { return error_ != nullptr; }

    // Writes what is still open.  IoError or another error, also one from before.
    void close();

private:
    template <class Write>
    void attempt(Write write);

    FrameChoice frames_;
    OutputFolder folder_;  // before what writes into it
    Observations observations_;
    std::optional<FrameWriter> frame_writer_;
    WavWriter wav_;
    ConsoleFile console_;
    std::optional<VideoWriter> video_;
    LampLog lamp_log_;
    std::vector<std::pair<std::uint64_t, std::string>> pictures_;
    std::vector<std::string> log_;
    std::uint64_t log_lines_ = 0;
    std::exception_ptr error_;
};

}  // namespace sim
