// arm_system.h - test fixture: the processor and its silicon, with a probe where the FPGA would be.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/cpu/arm_cpu.h"
#include "sim/hps/bus.h"
#include "sim/hps/memory.h"
#include "sim/hps/peripherals.h"
#include "tb/sim/probe.h"

// Names and bits that the small programs' tests speak of.
namespace tb::arm {

constexpr std::uint32_t NOBODY = 0x80000000;  // no target on the bus
constexpr std::uint32_t SVC_MODE = 0x13, IRQ_MODE = 0x12, FIQ_MODE = 0x11, ABT_MODE = 0x17,
                        UND_MODE = 0x1b, MODE = 0x1f, I = 0x80, F = 0x40, THUMB = 0x20;

}  // namespace tb::arm

namespace tb {

// Memory on a bridge that takes bursts, 100 ns each, and records them.
class Bridge : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Bridge> socket;

    explicit Bridge(const sc_core::sc_module_name& name_) : sc_module{name_}, socket{"socket"} {
        socket.register_b_transport(this, &Bridge::b_transport);
    }

    struct Store {
        std::uint32_t offset;
        std::vector<std::uint8_t> bytes;
        sc_core::sc_time at;
    };
    std::vector<Store> stores;
    std::uint32_t answers = 0x8000,
                  device = 0x100000;  // where it does: below, and 4 KB from there on

private:
    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
        const auto offset = static_cast<std::uint32_t>(tx.get_address());
        if (offset >= answers && offset - device >= 0x1000)
            return tx.set_response_status(tlm::TLM_GENERIC_ERROR_RESPONSE);
        const unsigned char* const data = tx.get_data_ptr();
        if (tx.is_write())
            stores.push_back(
                {offset, {data, data + tx.get_data_length()}, sc_core::sc_time_stamp() + delay});
        delay += sc_core::sc_time{100, sc_core::SC_NS};
        tx.set_response_status(tlm::TLM_OK_RESPONSE);
    }
};

struct ArmSystem : sc_core::sc_module, private sim::SteadyBus {
    std::string printed;
    std::vector<std::string> log;
    std::uint32_t brgmodrst = 0;
    sim::Memory ddr3{"ddr3", 0x40000000, sc_core::sc_time{60, sc_core::SC_NS}};
    Probe probe{"probe"};
    Bridge bridge{"bridge"};
    sim::Memory more_ram{"more_ram", 0x1000, sc_core::SC_ZERO_TIME};
    sim::Bus bus{"bus"};
    sim::ArmCpu cpu;
    sim::Peripherals hps{
        "hps",
        {[this](char c) { printed += c; }, [this](bool irq, bool fiq) { cpu.interrupt(irq, fiq); },
         [this](bool) { cpu.warm_reset(); }, [this](std::uint32_t bits) { brgmodrst = bits; }}};

    ArmSystem(const sc_core::sc_module_name& name_, sim::ArmProgram program)
        : sc_module{name_}, cpu{"cpu", std::move(program), [this](const std::string& line) {
                                    log.push_back(line);
                                }} {
        cpu.socket.bind(bus.socket);
        bus.window("ddr3", 0x00000000, 0x40000000).bind(ddr3.socket);
        bus.window("probe", 0xFF200000, 0x1000).bind(probe.socket);
        bus.window("bridge", 0xC0000000, 0x200000).bind(bridge.socket);
        bus.window("more_ram", 0xD0000000, 0x1000).bind(more_ram.socket);
        hps.bind(bus);
        cpu.set_steady_bus(this);
    }

private:
    // The probe's registers and the private timer's status.
    std::uint64_t changes() const override { return 0; }
    bool is_plain(std::uint32_t address, bool write, std::uint32_t) const override {
        return !write && (address >> 12 == 0xFF200 || address == 0xFFFEC60C);
    }
    std::uint64_t fixed_ps(std::uint32_t) const override { return 10'000; }
    std::optional<std::uint64_t> again(bool, std::uint64_t) override { return {}; }
    void left_out(bool write, std::uint64_t accesses) override { bus.left_out(write, accesses); }
};

class ArmTest : public ::testing::Test {
protected:
    explicit ArmTest(const char* file = CPU_TEST_ELF)
        : elf{sim::load_elf(file, {{0, 0x40000000}})} {}

    sim::ElfProgram elf;
    std::unique_ptr<ArmSystem> system;

    std::uint32_t address_of(const std::string& name) const {
        for (const sim::ElfFunction& f : elf.functions)
            if (f.name == name) return f.address;
        throw std::runtime_error{"no symbol " + name};
    }

    // The system stands ready to run from the function `entry` on.
    void load(const std::string& entry, double cpi = 1, bool thumb = false) {
        elf.entry = address_of(entry) | (thumb ? 1 : 0);
        system = std::make_unique<ArmSystem>("system", sim::ArmProgram{elf, cpi});
    }
    void run_ms(double ms) { sc_core::sc_start(sc_core::sc_time{ms, sc_core::SC_MS}); }
    // Runs to the program's last WFI.
    void run_to_end(const std::string& entry, bool thumb = false) {
        load(entry, 1, thumb);
        run_ms(5);
        ASSERT_FALSE(system->cpu.fault()) << *system->cpu.fault();
        ASSERT_TRUE(system->cpu.position().sleeping) << system->cpu.position().function;
        EXPECT_FALSE(system->cpu.unfinished()) << "it has come back from its exceptions";
    }

    std::uint32_t word(const std::string& name, unsigned index) const {
        std::uint32_t value = 0;
        EXPECT_TRUE(system->cpu.read_memory(address_of(name) + 4 * index, &value, 4));
        return value;
    }
    std::uint32_t result(unsigned index = 0) const { return word("result", index); }

    // When the program wrote to the probe, once.
    sc_core::sc_time written() const {
        const auto& writes = system->probe.writes;
        EXPECT_EQ(writes.size(), 1u);
        return writes.empty() ? sc_core::SC_ZERO_TIME : writes[0].second;
    }

    // What the handler saw: vector 1 undefined, 2 SVC, 3 prefetch, 4 data abort, 6 IRQ, 7 FIQ.
    struct Record {
        std::uint32_t vector, link, spsr, status, address, cpsr;
    };
    Record record() const {
        return {word("record", 0), word("record", 1), word("record", 2),
                word("record", 3), word("record", 4), word("record", 5)};
    }
};

}  // namespace tb
