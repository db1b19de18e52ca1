#include "sim/hps/i2c_wires.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t STRETCH_PS = 100'000;  // from one look at SCL to the next

struct Released {};

}  // namespace

I2cWires::I2cWires(const sc_core::sc_module_name& module_name, FabricWires wires,
                   std::function<void()> done)
    : sc_module{module_name}, wires_{std::move(wires)}, done_{std::move(done)} {
    SC_HAS_PROCESS(I2cWires);
    SC_THREAD(run);
}

void I2cWires::send(Byte byte, const Times& times) {
    byte_ = std::move(byte);
    times_ = times;
    is_stop_ = false;
    begin_.notify(sc_core::SC_ZERO_TIME);
}

void I2cWires::send_stop(const Times& times) {
    times_ = times;
    is_stop_ = true;
    begin_.notify(sc_core::SC_ZERO_TIME);
}

void I2cWires::release() {
    begin_.cancel();
    released_.notify(sc_core::SC_ZERO_TIME);
}

void I2cWires::run() {
    for (;;) {
        try {
            wait(begin_ | released_);
            if (released_.triggered()) throw Released{};
            lost_ = false;
            if (!is_stop_) {
                if (byte_.begins) start();
                std::uint8_t seen = 0;
                for (unsigned n = 0; n < 8 && !lost_; ++n) {
                    const bool level = byte_.reads || (byte_.value >> (7 - n) & 1);
                    const bool is = bit(level);
                    lost_ = !byte_.reads && level && !is;
                    seen = static_cast<std::uint8_t>(seen << 1 | is);
                }
                if (lost_) {
                    pull(SCL | SDA, false);
                    is_idle_ = true;
                } else if (byte_.reads) {
                    read_ = seen;
                    bit(!byte_.acknowledges());
                } else {
                    acknowledged_ = !bit(true);
                }
            }
            if (!lost_ && (is_stop_ || byte_.ends)) stop();
        } catch (const Released&) {
            pull(SCL | SDA, false);
            is_idle_ = true;
            continue;
        }
        done_();
    }
}

// SCL is low after it, as after each bit.
void I2cWires::start() {
    if (!is_idle_) {  // again: both are released first
        pull(SDA, false);
        pass(times_.low_ps);
        rise();
        pass(times_.high_ps);
    }
    pull(SDA, true);
    pass(times_.high_ps);
    pull(SCL, true);
    is_idle_ = false;
}

bool I2cWires::bit(bool level) {
    pass(times_.hold_ps);
    pull(SDA, !level);
    pass(times_.low_ps - times_.hold_ps);
    rise();
    pass(times_.high_ps);
    const bool is = levels() & SDA;
    pull(SCL, true);
    return is;
}

void I2cWires::stop() {
    pass(times_.hold_ps);
    pull(SDA, true);
    pass(times_.low_ps - times_.hold_ps);
    rise();
    pass(times_.high_ps);
    pull(SDA, false);
    is_idle_ = true;
}

void I2cWires::rise() {
    pull(SCL, false);
    while (!(levels() & SCL)) pass(STRETCH_PS);
}

void I2cWires::pull(std::uint64_t wire, bool low) {
    low_ = low ? low_ | wire : low_ & ~wire;
    wires_.drive(low_, sc_core::sc_time_stamp());
}

std::uint64_t I2cWires::levels() {
    wires_.catch_up(sc_core::sc_time_stamp());
    return levels_;
}

void I2cWires::pass(std::uint64_t ps) {
    wait(sc_core::sc_time::from_value(ps), released_);
    if (released_.triggered()) throw Released{};
}

}  // namespace sim
