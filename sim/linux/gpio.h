// gpio.h - /sys/class/gpio of the board's Linux: the pins of the HPS's GPIO blocks.
//
//   gpiochip483   ff708000.gpio   29 pins   GPIO0 - GPIO28 of the manuals
//   gpiochip454   ff709000.gpio   29 pins   GPIO29 - GPIO57
//   gpiochip427   ff70a000.gpio   27 pins   GPIO58 - GPIO66; from 13 on HLGPI0 - 13
//
//   gpio478   HPS_LED, GPIO53, which led.h has: EBUSY
//   gpio479   HPS_KEY, GPIO54, 0 = pressed
//   gpio430   INT1 of the accelerometer, GPIO61
//
// export and unexport take a number: EINVAL for one that no chip has, EBUSY for one that is taken,
// EINVAL to unexport what is not exported.  gpioN has direction (in, out; high, low), value, edge
// (none, rising, falling, both) and active_low.  An edge is an interrupt of the block; poll()
// returns POLLPRI and POLLERR for value then, until that is read again from its beginning.
// EPERM: to set an input; EIO: an edge of an output, or an output that has one.
//
// Numbers are those of Linux 4.x, which counts down from 512.  Sources: `ls /sys/class/gpio` on the
// DE0-Nano-SoC (github.com/machinekit/mksocfpga, issue 58) and the labels on the DE10-Nano
// (github.com/intel/meta-de10-nano, recipes-demo/de10-nano-gpio-apps/files/README_gpio.txt), whose
// HPS and kernels are the DE1-SoC's; Linux 4.14, drivers/gpio/gpiolib-sysfs.c, gpio-dwapb.c.
//
// Not handled: /dev/gpiochip0 - 2 (libgpiod); names of pins; chips in the FPGA; later kernels'
// numbers, which count down from 2048; a direction of HLGPI0 - 13, which are inputs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "sim/linux/attribute_file.h"
#include "sim/linux/own_files.h"

namespace sim {

class LinuxGpio {
public:
    static constexpr unsigned HPS_LED = 478;

    struct Outside {
        // Clears and sets bits of a register on the bus; what it was before.
        std::function<std::uint32_t(std::uint32_t address, std::uint32_t clear, std::uint32_t set)>
            change;
        // From now on interrupt() is called for the GIC's interrupt of that number: 0, or minus the
        // error.
        std::function<int(unsigned number)> listen;
        std::function<bool(unsigned pin)> is_taken;  // by a driver
    };
    explicit LinuxGpio(Outside outside) : outside_{std::move(outside)} {}

    void list(OwnFiles& files);
    // By a path without links; nullptr: it is none of its.
    std::shared_ptr<AttributeFile> open(const std::string& path);

    void interrupt(unsigned number);  // of the GIC
    // For a driver, as an output; `pin` is one that a chip has.
    void drive(unsigned pin, bool high) const;
    bool is_exported(unsigned pin) const { return pins_.count(pin) > 0; }

private:
    struct Chip {
        unsigned base, pins;
        std::uint32_t registers;
        unsigned interrupt;
        const char* name;
    };
    static const std::array<Chip, 3>& chips();
    struct Pin {
        const Chip& chip;
        std::uint32_t bit;
        bool active_low = false;
        unsigned edges = 0;
        std::shared_ptr<AttributeFile::Changes> changes =
            std::make_shared<AttributeFile::Changes>();
    };
    using Attributes = std::map<std::string, AttributeFile::Attribute>;  // by path

    static const Chip* chip_of(long number);
    static std::string folder_of(const Chip& chip);
    Attributes attributes();
    void add(Attributes& all, const Chip& chip) const;
    void add(Attributes& all, unsigned number, Pin& pin);
    std::uint32_t read(const Pin& pin, std::uint32_t offset) const;
    void change(const Pin& pin, std::uint32_t offset, bool on) const;
    int export_pin(const std::string& text);
    int unexport_pin(const std::string& text);
    int set_direction(Pin& pin, const std::string& text);
    int set_value(Pin& pin, const std::string& text);
    int set_edge(Pin& pin, const std::string& text);
    int set_active_low(Pin& pin, const std::string& text);
    bool is_output(const Pin& pin) const;
    void await_edges(const Pin& pin) const;

    const Outside outside_;
    std::map<unsigned, Pin> pins_;  // exported, by number
};

}  // namespace sim
