// frame_writer.cpp - a bounded queue and the thread that empties it
#include "sim/files/frame_writer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "sim/files/whole_file.h"

namespace sim {

namespace {

constexpr std::size_t QUEUE_FRAMES = 8;

}  // namespace

FrameWriter::FrameWriter(const std::filesystem::path& out) : folder_(out / "frames") {
    make_folder(folder_);
    worker_ = std::thread([this] { work(); });
}

FrameWriter::~FrameWriter() { finish(); }

void FrameWriter::push(std::uint64_t number, Image image) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (closing_) throw std::logic_error("FrameWriter: push after close");
    changed_.wait(lock, [this] { return error_ || queue_.size() < QUEUE_FRAMES; });
    if (error_) std::rethrow_exception(error_);
    queue_.push_back({number, std::move(image)});
    changed_.notify_all();
}

void FrameWriter::close() {
    finish();
    if (error_) std::rethrow_exception(error_);
}

void FrameWriter::finish() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    if (worker_.joinable()) worker_.join();
}

void FrameWriter::work() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return closing_ || !queue_.empty(); });
        if (queue_.empty()) return;
        const Frame& frame = queue_.front();  // a push does not move a deque's front
        lock.unlock();
        std::exception_ptr error;
        try {
            write_png(folder_ / fmt::format("frame_{:06}.png", frame.number), frame.image);
        } catch (...) {
            error = std::current_exception();
        }
        lock.lock();
        queue_.pop_front();
        changed_.notify_all();
        if (!error) continue;
        error_ = error;
        return;
    }
}

}  // namespace sim
