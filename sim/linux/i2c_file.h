// i2c_file.h - /dev/i2c-0 of the board's Linux: the bus of the HPS's I2C0, 100 kHz.
//
// read() and write() to the address of I2C_SLAVE; I2C_RDWR; I2C_SMBUS but for quick commands, block
// and process calls (EOPNOTSUPP, as by the board's driver).  Nobody who answers is EREMOTEIO.  A
// transfer takes its time, in which no other thread runs.
//
// Source: Linux 6.1, include/uapi/linux/i2c-dev.h, i2c.h, drivers/i2c/i2c-dev.c.
//
// Not handled: addresses of 10 bits, block commands whose length the device says.
#pragma once

#include <functional>
#include <vector>

#include "sim/linux/device.h"
#include "sim/pins/pins.h"

namespace sim {

class I2cFile final : public LinuxDevice {
public:
    // `pass` lets so many ps go by; `now_ps` is the program's time.
    I2cFile(I2cDevices& devices, std::function<std::uint64_t()> now_ps,
            std::function<void(std::uint64_t)> pass)
        : devices_{devices}, now_ps_{std::move(now_ps)}, pass_{std::move(pass)} {}

    FileStatus status() const override;
    std::string name() const override { return "/dev/i2c-0"; }
    std::int64_t read(void* data, std::size_t bytes) override;
    std::int64_t write(const void* data, std::size_t bytes) override;
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override;

private:
    struct Message {
        std::uint8_t address;
        bool reads;
        std::vector<std::uint8_t> bytes;
    };

    std::int64_t transfer(std::vector<Message>& messages);
    std::int64_t messages(std::uint32_t at, AddressSpace& memory);
    std::int64_t smbus(std::uint32_t at, AddressSpace& memory);

    I2cDevices& devices_;
    std::function<std::uint64_t()> now_ps_;
    std::function<void(std::uint64_t)> pass_;
    std::uint8_t address_ = 0;
};

}  // namespace sim
