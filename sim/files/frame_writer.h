// frame_writer.h - writes OUT/frames/frame_NNNNNN.png in parallel with the simulation, in a thread
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>

#include "sim/files/png.h"

namespace sim {

// After the first failure nothing more is written, and every push() and close() throws that
// failure: IoError for a full or unwritable disk.
class FrameWriter {
public:
    // Makes the folder `out`/frames.
    explicit FrameWriter(const std::filesystem::path& out);
    ~FrameWriter();  // like close(), but errors are lost: call close() to get them

    // Waits while eight pictures are queued.
    void push(std::uint64_t number, Image image);

    // Returns when all that was pushed is written.
    void close();

private:
    struct Frame {
        std::uint64_t number;
        Image image;
    };

    void work();
    void finish();

    std::filesystem::path folder_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Frame> queue_;  // the picture being written stays in front
    std::exception_ptr error_;
    bool closing_ = false;
    std::thread worker_;  // last: it uses all of the above
};

}  // namespace sim
