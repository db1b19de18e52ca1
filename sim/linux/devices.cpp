#include "sim/linux/devices.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace sim::devices {

namespace {

FileStatus character(unsigned major, unsigned minor) {
    return {S_IFCHR | 0666, 0, 1, major << 8 | minor};
}

// What has a size and a place in it.
class Contents : public LinuxDevice {
public:
    std::int64_t read(void* data, std::size_t bytes) override {
        const std::int64_t count = read_at(data, bytes, at_);
        if (count > 0) at_ += count;
        return count;
    }
    std::int64_t write(const void* data, std::size_t bytes) override {
        const std::int64_t count = write_at(data, bytes, at_);
        if (count > 0) at_ += count;
        return count;
    }
    std::int64_t seek(std::int64_t offset, int whence) override {
        const std::int64_t from = whence == SEEK_SET   ? 0
                                  : whence == SEEK_CUR ? at_
                                                       : static_cast<std::int64_t>(size());
        std::int64_t to;
        if (whence < SEEK_SET || whence > SEEK_END || __builtin_add_overflow(from, offset, &to) ||
            to < 0)
            return -EINVAL;
        return at_ = to;
    }

protected:
    virtual std::uint64_t size() const = 0;

private:
    std::int64_t at_ = 0;
};

class Null final : public LinuxDevice {
    FileStatus status() const override { return character(1, 3); }
    std::string name() const override { return "/dev/null"; }
    std::int64_t read(void*, std::size_t) override { return 0; }
    std::int64_t write(const void*, std::size_t bytes) override {
        return static_cast<std::int64_t>(bytes);
    }
    std::int64_t seek(std::int64_t, int) override { return 0; }
};

class Zero final : public LinuxDevice {
public:
    explicit Zero(bool full) : full_{full} {}
    FileStatus status() const override { return character(1, full_ ? 7 : 5); }
    std::string name() const override { return full_ ? "/dev/full" : "/dev/zero"; }
    std::int64_t read(void* data, std::size_t bytes) override {
        std::memset(data, 0, bytes);
        return static_cast<std::int64_t>(bytes);
    }
    std::int64_t write(const void*, std::size_t bytes) override {
        return full_ ? -ENOSPC : static_cast<std::int64_t>(bytes);
    }
    std::int64_t seek(std::int64_t, int) override { return 0; }
    std::shared_ptr<SharedMemory> memory() override { return std::make_shared<SharedMemory>(); }

private:
    bool full_;
};

class Random final : public LinuxDevice {
public:
    explicit Random(std::function<std::uint8_t()> next) : next_{std::move(next)} {}
    FileStatus status() const override { return character(1, 9); }
    std::string name() const override { return "/dev/urandom"; }
    std::int64_t read(void* data, std::size_t bytes) override {
        bytes = std::min<std::size_t>(bytes, 1 << 25);
        std::generate_n(static_cast<std::uint8_t*>(data), bytes, next_);
        return static_cast<std::int64_t>(bytes);
    }
    std::int64_t write(const void*, std::size_t bytes) override {
        return static_cast<std::int64_t>(bytes);
    }

private:
    std::function<std::uint8_t()> next_;
};

// As it was when it was opened.
class Text final : public Contents {
public:
    Text(std::string path, std::string contents)
        : path_{std::move(path)}, contents_{std::move(contents)} {}
    FileStatus status() const override { return status_of_text(); }
    std::string name() const override { return path_; }
    std::uint64_t size() const override { return contents_.size(); }
    std::int64_t read_at(void* data, std::size_t bytes, std::int64_t offset) override {
        if (offset < 0) return -EINVAL;
        const std::size_t from = std::min(static_cast<std::size_t>(offset), contents_.size());
        const std::size_t count = std::min(bytes, contents_.size() - from);
        std::memcpy(data, contents_.data() + from, count);
        return static_cast<std::int64_t>(count);
    }

private:
    std::string path_, contents_;
};

class Shared final : public Contents {
public:
    explicit Shared(std::shared_ptr<SharedMemory> memory) : memory_{std::move(memory)} {}
    FileStatus status() const override { return status_of_shared(*memory_); }
    std::string name() const override { return "shared memory"; }
    std::uint64_t size() const override { return memory_->size(); }
    std::shared_ptr<SharedMemory> memory() override { return memory_; }
    std::int64_t read_at(void* data, std::size_t bytes, std::int64_t offset) override {
        if (offset < 0) return -EINVAL;
        const std::uint64_t from = std::min(static_cast<std::uint64_t>(offset), memory_->size());
        return ::pread(memory_->fd(), data, std::min<std::uint64_t>(bytes, memory_->size() - from),
                       static_cast<off_t>(from));
    }
    std::int64_t write_at(const void* data, std::size_t bytes, std::int64_t offset) override {
        if (offset < 0) return -EINVAL;
        const std::uint64_t end = static_cast<std::uint64_t>(offset) + bytes;
        if (end > memory_->size() && !memory_->resize(end)) return -ENOSPC;
        return ::pwrite(memory_->fd(), data, bytes, static_cast<off_t>(offset));
    }
    int truncate(std::int64_t bytes) override {
        if (bytes < 0) return -EINVAL;
        if (static_cast<std::uint64_t>(bytes) > AddressSpace::RAM) return -EFBIG;
        return memory_->resize(static_cast<std::uint64_t>(bytes)) ? 0 : -ENOSPC;
    }

private:
    std::shared_ptr<SharedMemory> memory_;
};

// A counter.  Source: eventfd(2).
class Event final : public LinuxDevice {
public:
    Event(std::uint64_t value, bool as_semaphore) : value_{value}, as_semaphore_{as_semaphore} {}
    FileStatus status() const override { return {0600, 0, 1, 0}; }
    std::string name() const override { return "an event"; }
    bool is_inside() const override { return true; }
    unsigned can_do() const override {
        return (value_ > 0 ? READ : 0) | (value_ < MOST ? WRITE : 0);
    }
    std::int64_t read(void* data, std::size_t bytes) override {
        if (bytes < sizeof value_) return -EINVAL;
        if (value_ == 0) return -EAGAIN;
        const std::uint64_t given = as_semaphore_ ? 1 : value_;
        value_ -= given;
        std::memcpy(data, &given, sizeof given);
        return sizeof given;
    }
    std::int64_t write(const void* data, std::size_t bytes) override {
        std::uint64_t more;
        if (bytes < sizeof more) return -EINVAL;
        std::memcpy(&more, data, sizeof more);
        if (more > MOST) return -EINVAL;
        if (more > MOST - value_) return -EAGAIN;
        value_ += more;
        ++writes_;
        return sizeof more;
    }
    std::uint64_t arrivals() const override { return writes_; }

private:
    static constexpr std::uint64_t MOST = ~std::uint64_t{0} - 1;
    std::uint64_t value_, writes_ = 0;
    bool as_semaphore_;
};

class Framebuffer final : public Contents {
public:
    Framebuffer(const PixelBuffer& pixels, WordAccess access)
        : pixels_{pixels}, access_{std::move(access)} {}

private:
    static constexpr std::uint32_t GET_VARIABLE = 0x4600, PUT_VARIABLE = 0x4601, GET_FIXED = 0x4602,
                                   PAN = 0x4606;

    FileStatus status() const override { return character(29, 0); }
    std::string name() const override { return "/dev/fb0"; }
    std::optional<std::pair<std::uint32_t, std::uint32_t>> on_bus() const override {
        return std::pair{pixels_.base, pixels_.bytes};
    }
    // Source: Linux 6.1, drivers/video/fbdev/core/fbmem.c.
    std::int64_t read_at(void* data, std::size_t bytes, std::int64_t at) override {
        if (at < 0) return -EINVAL;
        if (at >= pixels_.bytes) return 0;
        return transfer(false, static_cast<std::uint8_t*>(data), bytes, at);
    }
    std::int64_t write_at(const void* data, std::size_t bytes, std::int64_t at) override {
        if (at < 0) return -EINVAL;
        if (at > pixels_.bytes || (bytes > pixels_.bytes && at == pixels_.bytes)) return -EFBIG;
        if (at == pixels_.bytes && bytes > 0) return -ENOSPC;
        return transfer(true, const_cast<std::uint8_t*>(static_cast<const std::uint8_t*>(data)),
                        bytes, at);
    }
    std::uint64_t size() const override { return 0; }  // for SEEK_END, as Linux has it

    // By words of the bus; of those at the ends, a part.
    std::int64_t transfer(bool write, std::uint8_t* data, std::size_t bytes, std::int64_t at) {
        bytes = std::min<std::size_t>(bytes, static_cast<std::size_t>(pixels_.bytes - at));
        auto address = static_cast<std::uint32_t>(pixels_.base + at);
        for (std::size_t done = 0; done < bytes;) {
            const std::uint32_t first = address % 4;
            const auto part =
                static_cast<std::uint32_t>(std::min<std::size_t>(bytes - done, 4 - first));
            std::uint32_t word = 0;
            if ((!write || part < 4) && !access_(false, address - first, word)) return -EFAULT;
            std::uint8_t* const lanes = reinterpret_cast<std::uint8_t*>(&word) + first;
            std::memcpy(write ? lanes : data + done, write ? data + done : lanes, part);
            if (write && !access_(true, address - first, word)) return -EFAULT;
            done += part;
            address += part;
        }
        return static_cast<std::int64_t>(bytes);
    }

    // Source: Linux 6.1, include/uapi/linux/fb.h.
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override {
        if (request == GET_FIXED) {
            struct {
                char id[16];
                std::uint32_t start, bytes, type, aux, visual;
                std::uint16_t steps[3], pad;
                std::uint32_t line, registers, register_bytes, acceleration;
                std::uint16_t capabilities, reserved[3];
            } fixed{"", pixels_.base, pixels_.bytes, 0, 0, 2, {}, 0, pixels_.line, 0, 0, 0, 0, {}};
            static_assert(sizeof fixed == 68);
            std::strcpy(fixed.id, pixels_.frame_reader ? "altvipfb" : "de1soc pixels");
            return memory.write(at, &fixed, sizeof fixed) ? 0 : -EFAULT;
        }
        if (request == PAN) return -EINVAL;  // neither has a driver that pans
        if (request == GET_VARIABLE || request == PUT_VARIABLE) {
            const bool is_wide = pixels_.bits == 32;  // 8-8-8, else 5-6-5
            const std::uint32_t bits = is_wide ? 8 : 5, green_bits = is_wide ? 8 : 6;
            std::uint32_t variable[40] = {pixels_.width,
                                          pixels_.height,
                                          pixels_.line * 8 / pixels_.bits,
                                          pixels_.bytes / pixels_.line,
                                          0,
                                          0,
                                          pixels_.bits,
                                          0,
                                          bits + green_bits,
                                          bits,
                                          0,
                                          bits,
                                          green_bits,
                                          0,
                                          0,
                                          bits};
            return memory.write(at, variable, sizeof variable) ? 0 : -EFAULT;
        }
        return -ENOTTY;
    }

    const PixelBuffer pixels_;
    const WordAccess access_;
};

}  // namespace

FileStatus status_of_text() { return {S_IFREG | 0444, 0, 1, 0}; }
FileStatus status_of_shared(const SharedMemory& memory) {
    return {S_IFREG | 0666, memory.size(), 1, 0};
}

std::shared_ptr<LinuxDevice> null() { return std::make_shared<Null>(); }
std::shared_ptr<LinuxDevice> zero(bool full) { return std::make_shared<Zero>(full); }
std::shared_ptr<LinuxDevice> random(std::function<std::uint8_t()> next) {
    return std::make_shared<Random>(std::move(next));
}
std::shared_ptr<LinuxDevice> text(const std::string& path, std::string contents) {
    return std::make_shared<Text>(path, std::move(contents));
}
std::shared_ptr<LinuxDevice> shared(std::shared_ptr<SharedMemory> memory) {
    return std::make_shared<Shared>(std::move(memory));
}
std::shared_ptr<LinuxDevice> event(std::uint64_t value, bool as_semaphore) {
    return std::make_shared<Event>(value, as_semaphore);
}
std::shared_ptr<LinuxDevice> framebuffer(const PixelBuffer& pixels, WordAccess access) {
    return std::make_shared<Framebuffer>(pixels, std::move(access));
}

}  // namespace sim::devices
