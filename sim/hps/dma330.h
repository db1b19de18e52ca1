// dma330.h - the HPS's DMA controller (ARM CoreLink DMA-330), with its eight channels
//
//   +0x000 manager's status and PC   +0x020 which events interrupt   +0x024 events   +0x028
//   interrupts   +0x02C clears them   +0x030 - 0x05C faults   +0x100 channels' status and PC
//   +0x400 channels' source, destination, control, loop counters   +0xD00 debug: a DMAGO, a DMASEV
//   or a DMAKILL by its bytes in 0xD08 and 0xD0C, done by writing 0 to 0xD04   +0xE00 configuration
//
// Channels run their programs of the memory in turn, an instruction each 5 ns (200 MHz), in
// addition to what the bus takes.  All of the instruction set: loads and stores in bursts of 1 to
// 16 beats of 1 to 8 bytes (16 count as faults), loops, events, barriers.
//
// Peripherals 0 to 7 are the FPGA's, see connect().  DMAWFP waits for a request of theirs, which is
// seen within 1 us; ack is 1 from the end of DMALDP or DMASTP until the request has been taken
// back.
//
// Sources: ARM DDI 0424D (CoreLink DMA-330 r1p2); Cyclone V HPS TRM, chapter DMA Controller.
//
// Not handled: requests of other peripherals: a channel that waits for one waits for ever, which is
// reported; a peripheral's last request, by which DMALPFE would end; security, endian swaps, the
// watchdog, and that the processor's caches do not know.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "sim/hps/axi_attributes.h"
#include "sim/hps/fabric_wires.h"
#include "sim/hps/registers.h"

namespace sim {

class Dma330 : public Registers {
public:
    static constexpr unsigned CHANNELS = 8, EVENTS = 8;

    struct Wires {
        // A burst as a master on the bus, of `bytes` together; false: refused.  May wait.
        std::function<bool(bool write, std::uint32_t address, std::uint8_t* data, unsigned bytes,
                           AxiAttributes& how, sc_core::sc_time& delay)>
            access;
        std::function<void(unsigned event, bool up)> interrupt;
        std::function<void(bool up)> abort;
        std::function<void(const std::string& line)> log;
    };
    Dma330(const sc_core::sc_module_name& module_name, Wires wires);

    // As the reset manager resets the block.
    void reset();

    // Requests come from the FPGA; before the program begins.  `moved` is to be called with what
    // the design does: bits 7:0 request bursts, 15:8 single transfers.
    void connect(FabricWires wires) { wires_in_fabric_ = std::move(wires); }
    void moved(std::uint64_t requests);

private:
    enum class State : std::uint8_t {
        STOPPED = 0,
        EXECUTING = 1,
        WAITS_FOR_EVENT = 4,
        WAITS_FOR_PERIPHERAL = 7,
        FAULTING = 15
    };
    struct Channel {
        State state = State::STOPPED;
        std::uint32_t pc = 0, source = 0, destination = 0, control = 0x00800200, fault = 0;
        std::array<std::uint32_t, 2> loops{};
        std::uint8_t event = 0;  // waited for, or a peripheral
        enum Request : std::uint8_t { NONE, SINGLE, BURST } request = NONE;  // the last one
        bool bursts_alone = false, of_its_kind = false;  // what it waits for: DMAWFPB, DMAWFPP
        std::deque<std::uint8_t> fifo{};                 // loaded and not stored yet
    };

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;

    void serve();
    void step(unsigned number, sc_core::sc_time& delay);
    enum class Beats { OF_CONTROL, ONE };
    void load(Channel& channel, unsigned number, Beats beats, sc_core::sc_time& delay);
    void store(Channel& channel, unsigned number, Beats beats, bool zeros, sc_core::sc_time& delay);
    void wait_for_peripheral(Channel& channel, unsigned number, std::uint8_t op, unsigned which);
    bool takes_request(Channel& channel);
    void acknowledge(unsigned peripheral, Channel::Request request);
    void put_acknowledgements();
    void signal(unsigned event);
    void fail(unsigned number, std::uint32_t why);
    void debug();
    void update();

    std::array<Channel, CHANNELS> channels_;
    std::uint32_t enabled_ = 0, events_ = 0;  // INTEN; events and interrupts that are raised
    std::uint32_t instruction_[2] = {0, 0};   // DBGINST
    std::uint32_t up_ = 0;                    // interrupt lines, with the abort in bit 8
    Wires wires_;
    std::optional<FabricWires> wires_in_fabric_;
    std::uint32_t requests_ = 0;          // as the design makes them
    std::uint32_t acknowledged_ = 0;      // those of them which it has not taken back yet
    std::uint32_t acknowledgements_ = 0;  // at the wires
    sc_core::sc_event start_;
};

}  // namespace sim
