// hps_bench.h - test fixture: the silicon around the processor on its bus, and an initiator.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/hps/peripherals.h"

namespace tb {

struct HpsBoard : sc_core::sc_module {
    std::string printed;
    std::vector<std::string> said;
    bool irq = false, fiq = false;
    unsigned resets = 0;
    std::uint32_t bridges_in_reset = 0, gpo = 0, gpi = 0;
    tlm_utils::simple_initiator_socket<HpsBoard> cpu{"cpu"};
    sim::Bus bus{"bus"};
    sim::Peripherals hps{
        "hps",
        {[this](char c) { printed += c; }, [this](bool i, bool f) { irq = i, fiq = f; },
         [this](bool) { ++resets; }, [this](std::uint32_t bits) { bridges_in_reset = bits; },
         [this](auto&&... burst) { return bus.transfer(burst...); },
         [this](std::uint32_t value, const sc_core::sc_time&) { gpo = value; },
         [this](const sc_core::sc_time&) { return gpi; },
         [this](const std::string& line) { said.push_back(line); }}};

    explicit HpsBoard(const sc_core::sc_module_name& name_) : sc_module{name_} {
        cpu.bind(bus.socket);
        hps.bind(bus);
    }
};

class HpsBench : public ::testing::Test {
protected:
    HpsBoard board{"board"};

    void SetUp() override { sc_core::sc_start(sc_core::SC_ZERO_TIME); }

    void wait_ns(double ns) { sc_core::sc_start(sc_core::sc_time{ns, sc_core::SC_NS}); }
    void wait_ms(double ms) { wait_ns(ms * 1e6); }

    tlm::tlm_response_status access(tlm::tlm_command command, std::uint32_t address, void* data,
                                    unsigned bytes) {
        tlm::tlm_generic_payload tx;
        sc_core::sc_time delay;
        tx.set_command(command);
        tx.set_address(address);
        tx.set_data_ptr(static_cast<unsigned char*>(data));
        tx.set_data_length(bytes);
        tx.set_streaming_width(bytes);
        board.cpu->b_transport(tx, delay);
        return tx.get_response_status();
    }
    // Each takes no simulated time: the 10 ns that the target adds are not waited for.
    std::uint32_t read(std::uint32_t address, unsigned bytes = 4) {
        std::uint32_t value = 0;
        EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &value, bytes), tlm::TLM_OK_RESPONSE);
        return value;
    }
    void write(std::uint32_t address, std::uint32_t value, unsigned bytes = 4) {
        EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, address, &value, bytes), tlm::TLM_OK_RESPONSE);
    }

    // The interrupt controller, as programs set it up: `id` on, to this processor.
    static constexpr std::uint32_t GIC = 0xFFFED000, GIC_CPU = 0xFFFEC100;
    void take(unsigned id, std::uint8_t priority = 0x80) {
        write(GIC_CPU + 0x04, 0xF0);
        write(GIC_CPU + 0x00, 1);
        write(GIC + 0x000, 1);
        write(GIC + 0x400 + id, priority, 1);
        write(GIC + 0x800 + id, 1, 1);
        write(GIC + 0x100 + id / 32 * 4, 1u << id % 32);
    }
    std::uint32_t acknowledge() { return read(GIC_CPU + 0x0C); }
    void end(std::uint32_t id) { write(GIC_CPU + 0x10, id); }
};

}  // namespace tb
