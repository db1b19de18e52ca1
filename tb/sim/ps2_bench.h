// ps2_bench.h - test fixture: a PS/2 device at the board's PS/2 port in Verilog, one tick per
// clock.
#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "Vps2_port.h"
#include "sim/pins/agenda.h"
#include "tb/support/register_bus.h"

namespace tb {

template <class Device>
class Ps2Bench : public RegisterBus<Vps2_port> {
protected:
    using Bytes = std::vector<int>;

    sim::Agenda agenda;
    Device device{agenda, [] {}};

    void SetUp() override {
        dut.tick_i = 1;
        after_clock();
        reset();
    }
    void after_clock() override {
        agenda.run_to(agenda.now_ps() + TICK_PS);
        if (clk_low_ != dut.ps2_clk_low_o || dat_low_ != dut.ps2_dat_low_o)
            device.host(clk_low_ = dut.ps2_clk_low_o, dat_low_ = dut.ps2_dat_low_o);
        dut.ps2_clk_i = !(device.clk_low() || dut.ps2_clk_low_o);
        dut.ps2_dat_i = !(device.dat_low() || dut.ps2_dat_low_o);
    }

    void run_ms(double ms) {
        const auto end_ps = agenda.now_ps() + static_cast<std::uint64_t>(ms * 1e9);
        while (agenda.now_ps() < end_ps) clock();
    }
    // What has come, oldest first.
    Bytes received() {
        Bytes bytes;
        for (std::uint32_t data; (data = read(DATA)) & RVALID;)
            bytes.push_back(static_cast<int>(data & 0xff));
        return bytes;
    }
    // What comes within a time.
    Bytes within_ms(double ms) {
        run_ms(ms);
        return received();
    }
    // What is answered to bytes, each sent when the one before has been answered.
    Bytes answers(const std::vector<std::uint8_t>& bytes) {
        Bytes all;
        for (const std::uint8_t byte : bytes) {
            write(DATA, byte);
            const Bytes some = within_ms(8);
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }
    // Past the test after power-on.
    void power_on() {
        run_ms(510);
        received();
    }

    static constexpr std::uint64_t TICK_PS = 1'280'000;
    static constexpr int DATA = 0x0, CONTROL = 0x4;
    static constexpr std::uint32_t RVALID = 1 << 15, ERROR = 1 << 10;

private:
    bool clk_low_ = false, dat_low_ = false;
};

}  // namespace tb
