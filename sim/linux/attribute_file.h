// attribute_file.h - a file below /sys: a value that is read and written, and changes by itself
//
// A read at the beginning shows the value as it is then.  poll() returns POLLPRI and POLLERR when
// the value has changed since the last read, also before the first.
//
// Source: Linux 6.1, fs/kernfs/file.c, fs/sysfs/file.c.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "sim/linux/device.h"

namespace sim {

class AttributeFile final : public LinuxDevice {
public:
    // Of one whose changes poll() reports; the owner of the file keeps it.
    struct Changes {
        std::uint64_t count = 1;
        bool gone = false;  // what it belonged to: reads and writes are ENODEV
    };
    struct Attribute {
        std::function<std::string()> show{};                  // none: it cannot be read
        std::function<int(const std::string& text)> store{};  // 0, or minus the error; likewise
        std::shared_ptr<const Changes> changes{};             // or none
    };

    AttributeFile(std::string path, Attribute attribute)
        : path_{std::move(path)}, attribute_{std::move(attribute)} {}

    bool allows(bool reads, bool writes) const {
        return (attribute_.show || !reads) && (attribute_.store || !writes);
    }

    FileStatus status() const override;
    std::string name() const override { return "a change of " + path_; }
    unsigned can_do() const override;
    std::uint64_t arrivals() const override {
        return attribute_.changes ? attribute_.changes->count : 0;
    }
    std::int64_t read(void* data, std::size_t bytes) override;
    std::int64_t read_at(void* data, std::size_t bytes, std::int64_t offset) override;
    std::int64_t write(const void* data, std::size_t bytes) override;
    std::int64_t write_at(const void* data, std::size_t bytes, std::int64_t) override {
        return write(data, bytes);
    }
    std::int64_t seek(std::int64_t offset, int whence) override;
    int truncate(std::int64_t) override { return 0; }

private:
    bool is_gone() const { return attribute_.changes && attribute_.changes->gone; }

    const std::string path_;
    const Attribute attribute_;
    std::string shown_;       // by the last read at the beginning
    std::uint64_t seen_ = 0;  // changes
    std::int64_t at_ = 0;
};

namespace attribute {

// The whole number that a program has written, a newline after it or not: 0, or EINVAL or ERANGE.
// Base 0 as in C: 0x10, 010, 10.
int number_in(const std::string& text, int base, long& value);
// Whether it has written this word, likewise.
bool is_word(const std::string& text, const char* word);

}  // namespace attribute

}  // namespace sim
