// i2c_bus.h - an I2C bus with a target that acknowledges, and checks of the standard's rules.
//
// Times are those of UM10204, table 10, for 100 kHz.  The target samples SDA when SCL rises and
// moves it one clock after SCL has fallen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tb {

class I2cBus {
public:
    std::vector<std::vector<std::uint8_t>> transfers;  // bytes of each, acknowledged or not
    unsigned stops = 0;
    std::vector<std::string> faults;

    // This byte of this transfer is not acknowledged.
    void refuse(std::size_t transfer, std::size_t byte) {
        refuse_transfer_ = transfer;
        refuse_byte_ = byte;
    }

    bool sda() const { return sda_; }
    bool idle() const { return scl_ && sda_ && !busy_; }

    // One clock of 40 ns.
    void step(bool scl, bool master_pulls) {
        now_ += 40;
        const bool sda = !master_pulls && !pulls_;
        const bool rises = scl && !scl_, falls = !scl && scl_, high = scl && scl_;
        if (sda != sda_) {
            check(high || !(rises || falls), "SDA moves together with SCL");
            if (high)
                sda ? stop() : start();
            else if (master_pulls != master_pulled_)
                check(now_ - fell_ <= 3450, "SDA moves too late after SCL");
            moved_ = now_;
        }
        if (rises) rise(sda);
        if (falls) fall();
        scl_ = scl;
        sda_ = sda;
        master_pulled_ = master_pulls;
    }

private:
    void check(bool ok, const char* fault) {
        if (!ok) faults.push_back(std::to_string(now_) + " ns: " + fault);
    }
    void start() {
        check(!busy_, "START within a transfer");
        check(now_ - stopped_ >= 4700, "START too soon after STOP");
        transfers.emplace_back();
        busy_ = true;
        bits_ = byte_ = 0;
        started_ = now_;
    }
    void stop() {
        check(busy_, "STOP without a START");
        check(bits_ == 1, "STOP within a byte");  // SCL has risen once since the last acknowledge
        check(now_ - rose_ >= 4000, "STOP too soon after SCL");
        busy_ = false;
        stopped_ = now_;
        ++stops;
    }
    void rise(bool sda) {
        check(now_ - fell_ >= 4700, "SCL low too short");
        check(now_ - rose_ >= 10'000, "SCL faster than 100 kHz");
        check(now_ - moved_ >= 250, "SDA moves too late before SCL");
        rose_ = now_;
        if (bits_ < 8) byte_ = byte_ << 1 | sda;
        ++bits_;
    }
    void fall() {
        check(busy_, "SCL moves outside a transfer");
        check(bits_ == 0 || now_ - rose_ >= 4000, "SCL high too short");
        check(now_ - started_ >= 4000, "SCL falls too soon after START");
        fell_ = now_;
        if (bits_ == 8) {
            pulls_ =
                transfers.size() - 1 != refuse_transfer_ || transfers.back().size() != refuse_byte_;
            transfers.back().push_back(static_cast<std::uint8_t>(byte_));
        } else if (bits_ == 9) {
            pulls_ = false;
            bits_ = byte_ = 0;
        }
    }

    std::size_t refuse_transfer_ = ~std::size_t{0}, refuse_byte_ = 0;
    bool scl_ = true, sda_ = true, pulls_ = false, master_pulled_ = false, busy_ = false;
    unsigned bits_ = 0, byte_ = 0;
    std::int64_t now_ = 0;  // ns
    std::int64_t rose_ = -1'000'000, fell_ = -1'000'000, moved_ = -1'000'000;
    std::int64_t started_ = -1'000'000, stopped_ = -1'000'000;
};

}  // namespace tb
