// fabric_bench.h - fpga.v at its pins and bridges, with the SDRAM and wires on PS/2 and the headers
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "regmap.h"
#include "sim/board/adv7180.h"
#include "sim/board/is42s16320d.h"
#include "sim/fpga/fabric.h"
#include "tb/rtl/fabric_burst.h"

namespace tb {

// What the PS/2 ports pull low since the clock, bit n of port n.
struct Ps2Pulls {
    std::uint64_t clock;
    unsigned clk_low, dat_low;
};

// PS/2 wires with pull-ups, which a device may pull low, too; on_headers answers what is driven
// there.
struct Pins : sim::PinListener {
    std::function<std::uint64_t()> clocks;
    std::vector<Ps2Pulls> pulls;
    unsigned device_clk_low = 0, device_dat_low = 0;
    std::uint64_t samples = 0, with_sync = 0;
    std::vector<std::uint32_t> lit;  // pixels that are not black
    sim::HeaderPins driven{};
    std::function<void(sim::ChipInputs& in)> on_headers;
    sim::Is42s16320d memory;
    sim::Adv7180 camera;

    void wires(sim::ChipInputs& in) const {
        const Ps2Pulls host = pulls.empty() ? Ps2Pulls{} : pulls.back();
        in.ps2_clk = static_cast<std::uint8_t>(3 & ~(device_clk_low | host.clk_low));
        in.ps2_dat = static_cast<std::uint8_t>(3 & ~(device_dat_low | host.dat_low));
    }
    void ps2(unsigned clk_low, unsigned dat_low, std::uint64_t, sim::ChipInputs& in) override {
        pulls.push_back({clocks(), clk_low, dat_low});
        wires(in);
    }
    void video(const std::uint32_t* pins, std::size_t count) override {
        samples += count;
        for (std::size_t i = 0; i < count; ++i) {
            with_sync += (pins[i] & sim::video::SYNC_N) != 0;
            if (pins[i] & sim::video::RGB) lit.push_back(pins[i] & sim::video::RGB);
        }
    }
    void codec(const sim::CodecPins&, std::uint64_t, sim::ChipInputs&) override {}
    void headers(const sim::HeaderPins& pins, std::uint64_t, sim::ChipInputs& in) override {
        driven = pins;
        if (on_headers) on_headers(in);
    }
    void adc(const sim::AdcPins&, std::uint64_t, sim::ChipInputs&) override {}
    std::uint8_t td_data(std::uint64_t rise) override { return camera.data(rise); }
    void sdram(const sim::SdramPins& pins, std::uint64_t time_ps, std::uint16_t& dq,
               bool& more) override {
        memory.clock({pins.cs_n, pins.ras_n, pins.cas_n, pins.we_n, pins.ba, pins.addr, pins.dqm,
                      pins.dq_driven, pins.dq},
                     time_ps);
        dq = memory.dq();
        more = memory.busy();
    }
};

class FabricPorts : public ::testing::Test {
protected:
    Pins pins;
    sim::Fabric fabric{pins};

    void SetUp() override {
        pins.clocks = [this] { return fabric.clocks(); };
        fabric.run_clocks(1000);
    }
    // Whether it is answered in so many clocks.
    bool answered(std::uint64_t within_clocks = 10'000) {
        return fabric.run_to_answer((fabric.clocks() + within_clocks) * sim::FABRIC_PERIOD_PS) &&
               fabric.answer().error == sim::BridgeBurst::OKAY;
    }
    std::vector<std::uint8_t> read_bytes(bool full, std::uint32_t offset, unsigned count) {
        fabric.begin(burst_of(full, false, offset, nullptr, count));
        EXPECT_TRUE(answered());
        std::vector<std::uint8_t> bytes(count);
        for (unsigned n = 0; n < count; ++n)
            bytes[n] = fabric.answer().beat[(offset + n) / 4 - offset / 4].lanes[(offset + n) % 4];
        return bytes;
    }
    std::uint32_t read(std::uint32_t address) {
        const std::vector<std::uint8_t> bytes = read_bytes(false, address - 0xFF200000, 4);
        std::uint32_t value;
        std::memcpy(&value, bytes.data(), 4);
        return value;
    }
    void write(std::uint32_t address, std::uint32_t value) {
        std::uint8_t bytes[4];
        std::memcpy(bytes, &value, 4);
        fabric.begin(burst_of(false, true, address - 0xFF200000, bytes, 4));
        EXPECT_TRUE(answered());
        fabric.run_clocks(10);
    }
    // A write for which the bus waits, until written().
    void begin_write(std::uint32_t address, std::uint8_t value) {
        fabric.begin(burst_of(false, true, address - 0xFF200000, &value, 1));
        EXPECT_FALSE(answered(16));
    }
    bool written(std::uint64_t within_clocks = 0) { return answered(within_clocks); }
    // Any bytes, through the bridge of 1 GB.
    std::vector<std::uint8_t> bytes_at(std::uint32_t address, unsigned count) {
        return read_bytes(true, address - 0xC0000000, count);
    }
    void put(std::uint32_t address, const std::vector<std::uint8_t>& bytes) {
        fabric.begin(burst_of(true, true, address - 0xC0000000, bytes.data(),
                              static_cast<unsigned>(bytes.size())));
        EXPECT_TRUE(answered());
    }
    static std::uint64_t irq_of(unsigned id) {
        return std::uint64_t{1} << (id - regmap::TIMER0_IRQ_ID);
    }
};

}  // namespace tb
