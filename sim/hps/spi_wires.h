// spi_wires.h - the wires of an SPI controller where they are routed to the FPGA, in Motorola's
// format
//
//   SS    ~~\______________________/~~     SCPOL 0, SCPH 0: a bit is there before SCLK rises, where
//   SCLK  ______/~~\__/~~\__/~~\______     it is read, and moves when SCLK falls; SCPH 1: it moves
//   TXD   --X=====X=====X=====X-----       when SCLK rises, and is read when it falls
//
// A frame begins with SS low; half a period later SCLK moves for the first time.  SS is high half a
// period after it has moved for the last time, and then for as long at least.  With SCPH 1 it stays
// low where another frame follows at once.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "sim/hps/fabric_wires.h"

#include <systemc>

namespace sim {

struct SpiFormat {
    unsigned bits;
    bool second_edge, idle_high;  // SCPH, SCPOL
};

class SpiMasterWires : public sc_core::sc_module {
public:
    // `done` is called at the end of each frame; if it sends another, that follows at once.
    SpiMasterWires(const sc_core::sc_module_name& module_name, FabricWires wires,
                   std::function<void()> done);

    struct Frame {
        SpiFormat format;
        std::uint64_t period_ps, sample_delay_ps;  // of SCLK; RXD is read so much later
        unsigned slaves;                           // selected
        std::uint32_t value;
    };
    void send(const Frame& frame);
    std::uint32_t received() const { return received_; }
    // No frame is sent any more; SCLK rests at this level.
    void release(bool idle_high);
    void moved(std::uint64_t levels) { rxd_ = levels & 1; }

private:
    void run();
    void run_frame();
    void pass_until(std::uint64_t time_ps);
    void put(bool sclk, bool is_selected);

    FabricWires wires_;
    std::function<void()> done_;
    Frame frame_{};
    std::optional<Frame> next_;
    std::uint32_t received_ = 0;
    bool rxd_ = false, txd_ = false, idle_high_ = false;
    std::uint64_t free_ps_ = 0;  // SS may be low again
    sc_core::sc_event begin_, released_;
};

// What a slave does at its master's edges.
class SpiSlaveWires {
public:
    struct Frames {
        std::function<std::uint32_t()> next;                // to be sent, as it is up to now
        std::function<void()> begun;                        // it is being sent
        std::function<void(std::uint32_t frame)> received;  // a whole one
        std::function<void(bool txd, bool drives)> put;     // the levels of the slave
    };
    explicit SpiSlaveWires(Frames frames) : frames_{std::move(frames)} {}

    void moved(bool rxd, bool is_selected, bool sclk, const SpiFormat& format);

private:
    Frames frames_;
    bool is_selected_ = false, sclk_ = false;
    unsigned done_ = 0;  // bits of the frame
    std::uint32_t in_ = 0, out_ = 0;
};

}  // namespace sim
