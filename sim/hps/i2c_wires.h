// i2c_wires.h - the bus of an I2C controller where it is routed to the FPGA, bit by bit
//
//   SDA  ~~\_____/~~~X~~~~~~X~           a START, and the bits that follow; SDA moves `hold` after
//   SCL  ~~~~~\_____/~~\____/~~\         SCL has fallen, and is read when SCL falls
//
// Open drain: the master only ever pulls low.  It waits for as long as the design holds SCL low.
//
// It is to the controller what devices on a bus of the board are: it is asked for what has been on
// the wires.
//
// Not handled: that another master begins, which would have to be seen while the bus is idle.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/hps/fabric_wires.h"
#include "sim/pins/pins.h"

#include <systemc>

namespace sim {

class I2cWires : public sc_core::sc_module, public I2cDevices {
public:
    struct Times {
        std::uint64_t high_ps, low_ps, hold_ps;
    };
    // `done` is called when what send() began is over.
    I2cWires(const sc_core::sc_module_name& module_name, FabricWires wires,
             std::function<void()> done);

    // With what a byte begins: START, also again, or nothing; and whether STOP follows it.
    struct Byte {
        bool begins, reads;
        std::uint8_t value;  // written
        bool ends;
        std::function<bool()> acknowledges;  // asked at the end of a byte that is read
    };
    void send(Byte byte, const Times& times);
    // STOP alone.
    void send_stop(const Times& times);
    // The controller is reset: the bus is released.
    void release();
    // Another held SDA low where the master released it.
    bool is_lost() const { return lost_; }

    void moved(std::uint64_t levels) { levels_ = levels; }

    bool begin(std::uint8_t, bool, std::uint64_t, std::uint64_t) override { return acknowledged_; }
    bool write(std::uint8_t, std::uint64_t) override { return acknowledged_; }
    std::uint8_t read(std::uint64_t) override { return read_; }
    void end(std::uint64_t) override {}

private:
    static constexpr std::uint64_t SCL = 1, SDA = 2;

    void run();
    void start();
    void stop();
    bool bit(bool level);
    void pull(std::uint64_t wire, bool low);
    std::uint64_t levels();
    void rise();
    void pass(std::uint64_t ps);

    FabricWires wires_;
    std::function<void()> done_;
    Byte byte_{};
    Times times_{};
    bool is_stop_ = false, is_idle_ = true;  // is_idle_: the bus is free
    bool acknowledged_ = false, lost_ = false;
    std::uint8_t read_ = 0;
    std::uint64_t low_ = 0, levels_ = 0;  // pulled low; on the wires
    sc_core::sc_event begin_, released_;
};

}  // namespace sim
