#include "tb/bench/bus_cost.h"

#include <chrono>
#include <cstdint>
#include <stdexcept>

#include "regmap.h"
#include "sim/chip/fpga_bridges.h"
#include "sim/fpga/fabric.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_initiator_socket.h>

namespace bench {

namespace {

constexpr std::uint32_t LW_BASE = 0xFF200000, H2F_BASE = 0xC0000000;
constexpr unsigned REGISTER_ACCESSES = 1'000'000, ROWS = 240, ROW_BYTES = 640, PICTURES = 20;

struct NoPins : sim::PinListener {
    void sdram(const sim::SdramPins&, std::uint64_t, std::uint16_t&, bool&) override {}
    void video(const std::uint32_t*, std::size_t) override {}
    void codec(const sim::CodecPins&, std::uint64_t, sim::ChipInputs&) override {}
    void headers(const sim::HeaderPins&, std::uint64_t, sim::ChipInputs&) override {}
    void adc(const sim::AdcPins&, std::uint64_t, sim::ChipInputs&) override {}
    void ps2(unsigned, unsigned, std::uint64_t, sim::ChipInputs&) override {}
};

class Processor : public sc_core::sc_module {
public:
    using Socket = tlm_utils::simple_initiator_socket<Processor>;
    Socket lw{"lw"}, h2f{"h2f"};
    BusCost cost{};

    explicit Processor(const sc_core::sc_module_name& name) : sc_module{name} {
        SC_HAS_PROCESS(Processor);
        SC_THREAD(run);
    }

private:
    void access(Socket& socket, tlm::tlm_command command, std::uint32_t offset, unsigned bytes) {
        tlm::tlm_generic_payload tx;
        tx.set_command(command);
        tx.set_address(offset);
        tx.set_data_ptr(data_);
        tx.set_data_length(bytes);
        tx.set_streaming_width(bytes);
        sc_core::sc_time delay;
        socket->b_transport(tx, delay);
        if (!tx.is_response_ok()) throw std::runtime_error("the bus answered with an error");
        wait(delay);
    }
    template <class Body>
    static double ns_each(unsigned count, Body body) {
        const auto begin = std::chrono::steady_clock::now();
        for (unsigned i = 0; i < count; ++i) body(i);
        const std::chrono::duration<double, std::nano> took =
            std::chrono::steady_clock::now() - begin;
        return took.count() / count;
    }
    double row_ns_a_word(tlm::tlm_command command) {
        return 4.0 / ROW_BYTES * ns_each(PICTURES * ROWS, [&](unsigned i) {
                   access(h2f, command, regmap::ONCHIP_BASE - H2F_BASE + i % ROWS * 1024,
                          ROW_BYTES);
               });
    }
    void run() {
        cost.register_read_ns = ns_each(REGISTER_ACCESSES, [this](unsigned) {
            access(lw, tlm::TLM_READ_COMMAND, regmap::SYSID_ID - LW_BASE, 4);
        });
        cost.register_write_ns = ns_each(REGISTER_ACCESSES, [this](unsigned) {
            access(lw, tlm::TLM_WRITE_COMMAND, regmap::LEDR_DATA - LW_BASE, 4);
        });
        cost.burst_write_ns_a_word = row_ns_a_word(tlm::TLM_WRITE_COMMAND);
        cost.burst_read_ns_a_word = row_ns_a_word(tlm::TLM_READ_COMMAND);
        sc_core::sc_pause();
    }

    unsigned char data_[ROW_BYTES] = {};
};

}  // namespace

BusCost bus_cost() {
    NoPins pins;
    sim::Fabric fabric{pins};
    sim::FpgaChip fpga{"fpga", pins, fabric};
    sim::FpgaBridges bridges{"bridges", fpga, sim::FpgaBridges::Bursts::LONG};
    Processor processor{"processor"};
    processor.lw.bind(bridges.lw);
    processor.h2f.bind(bridges.h2f);
    sc_core::sc_start();
    return processor.cost;
}

}  // namespace bench
