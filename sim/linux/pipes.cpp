#include "sim/linux/pipes.h"

#include <sys/stat.h>

#include <algorithm>

#include "sim/linux/arm_abi.h"

namespace sim {

namespace {

class PipeEnd final : public LinuxDevice {
public:
    PipeEnd(std::shared_ptr<BytePipe> pipe, bool reads) : pipe_{std::move(pipe)}, reads_{reads} {}
    ~PipeEnd() override { (reads_ ? pipe_->has_reader : pipe_->has_writer) = false; }

    FileStatus status() const override { return {S_IFIFO | 0600, 0, 1, 0}; }
    std::string name() const override { return reads_ ? "input from a pipe" : "room in a pipe"; }
    bool is_inside() const override { return true; }
    // Source: Linux 6.1, fs/pipe.c, pipe_poll().
    unsigned can_do() const override {
        if (reads_) return (pipe_->size() > 0 ? READ : 0) | (pipe_->has_writer ? 0 : HUNG_UP);
        return (pipe_->can_do() & WRITE) | (pipe_->has_reader ? 0 : BROKEN);
    }
    std::uint64_t arrivals() const override { return reads_ ? pipe_->writes() : pipe_->rooms(); }
    std::int64_t read(void* data, std::size_t bytes) override {
        return reads_ ? pipe_->read(data, bytes) : -EBADF;
    }
    std::int64_t write(const void* data, std::size_t bytes) override {
        return reads_ ? -EBADF : pipe_->write(data, bytes);
    }
    std::int64_t pipe_size() const override { return static_cast<std::int64_t>(pipe_->capacity()); }
    std::int64_t set_pipe_size(std::uint32_t bytes) override { return pipe_->set_capacity(bytes); }
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override {
        if (request != arm_ioctl::READABLE) return -ENOTTY;
        const auto count = static_cast<std::uint32_t>(pipe_->size());
        return memory.write(at, &count, sizeof count) ? 0 : -EFAULT;
    }

private:
    std::shared_ptr<BytePipe> pipe_;
    bool reads_;
};

}  // namespace

std::int64_t BytePipe::read(void* data, std::size_t bytes, bool peek) {
    if (bytes == 0) return 0;
    if (bytes_.empty()) return has_writer ? -EAGAIN : 0;
    const std::size_t count = std::min(bytes, bytes_.size());
    const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(bytes_.begin(), end, static_cast<std::uint8_t*>(data));
    if (peek) return static_cast<std::int64_t>(count);
    const bool was_full = !(can_do() & LinuxDevice::WRITE);
    bytes_.erase(bytes_.begin(), end);
    rooms_ += was_full && (can_do() & LinuxDevice::WRITE);
    return static_cast<std::int64_t>(count);
}

std::int64_t BytePipe::write(const void* data, std::size_t bytes) {
    if (!has_reader) return -EPIPE;
    const std::size_t room = capacity_ - bytes_.size();
    if (bytes > 0 && (room == 0 || (bytes <= WHOLE && room < bytes))) return -EAGAIN;
    const std::size_t count = std::min(bytes, room);
    const auto* const from = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), from, from + count);
    writes_ += count > 0;
    return static_cast<std::int64_t>(count);
}

std::int64_t BytePipe::set_capacity(std::uint32_t bytes) {
    if (bytes > LARGEST) return -EPERM;
    std::size_t wish = WHOLE;
    while (wish < bytes) wish *= 2;
    if (wish < bytes_.size()) return -EBUSY;
    rooms_ += wish > capacity_;
    capacity_ = wish;
    return static_cast<std::int64_t>(wish);
}

unsigned BytePipe::can_do() const {
    const bool readable = !bytes_.empty() || !has_writer;
    const bool writable = capacity_ - bytes_.size() >= WHOLE || !has_reader;
    return (readable ? LinuxDevice::READ : 0) | (writable ? LinuxDevice::WRITE : 0);
}

std::pair<std::shared_ptr<LinuxDevice>, std::shared_ptr<LinuxDevice>> make_pipe() {
    const auto pipe = std::make_shared<BytePipe>();
    return {std::make_shared<PipeEnd>(pipe, true), std::make_shared<PipeEnd>(pipe, false)};
}

}  // namespace sim
