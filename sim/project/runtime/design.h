// design.h - a design, Verilated: its pins as de1sim_chip.v has them, and what is known of it.
//
// design.cpp, which is compiled with each design, offers this; model.cpp, which is compiled once,
// plays it.  Neither Verilator's headers nor the board's are needed, so that designs compile fast.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace sim {
class FpgaModel;
class PinListener;
}  // namespace sim

namespace sim::project {

struct ModelSettings;

// The ports of de1sim_chip.v.
#define DE1SIM_CHIP_PORTS(PORT)        \
    PORT(std::uint8_t, moved_i)        \
    PORT(std::uint8_t, clock_50_i)     \
    PORT(std::uint8_t, clock_27_i)     \
    PORT(std::uint64_t, pll_clocks_i)  \
    PORT(std::uint16_t, sw_i)          \
    PORT(std::uint8_t, key_ni)         \
    PORT(std::uint16_t, ledr_o)        \
    PORT(std::uint64_t, hex_no)        \
    PORT(std::uint8_t, clocks_o)       \
    PORT(std::uint32_t, pins_o)        \
    PORT(std::uint32_t, vga_o)         \
    PORT(std::uint32_t, dram_o)        \
    PORT(std::uint16_t, dram_dq_o)     \
    PORT(std::uint16_t, dram_dq_i)     \
    PORT(std::uint8_t, dram_dq_en_i)   \
    PORT(std::uint64_t, gpio_0_low_i)  \
    PORT(std::uint64_t, gpio_0_o)      \
    PORT(std::uint64_t, gpio_0_oe_o)   \
    PORT(std::uint64_t, gpio_1_low_i)  \
    PORT(std::uint64_t, gpio_1_o)      \
    PORT(std::uint64_t, gpio_1_oe_o)   \
    PORT(std::uint8_t, aud_i)          \
    PORT(std::uint8_t, aud_en_i)       \
    PORT(std::uint8_t, aud_adcdat_i)   \
    PORT(std::uint8_t, i2c_sdat_low_i) \
    PORT(std::uint8_t, adc_dout_i)     \
    PORT(std::uint8_t, gsensor_low_i)  \
    PORT(std::uint8_t, ps2_clk_low_i)  \
    PORT(std::uint8_t, ps2_dat_low_i)  \
    PORT(std::uint8_t, irda_rxd_i)     \
    PORT(std::uint8_t, td_data_i)      \
    PORT(std::uint8_t, hps_moved_i)    \
    PORT(std::uint8_t, hps_request_i)  \
    PORT(std::uint8_t, hps_reset_i)    \
    PORT(std::uint32_t, hps_gp_i)      \
    PORT(std::uint8_t, hps_answer_o)   \
    PORT(std::uint8_t, hps_size_o)     \
    PORT(std::uint64_t, hps_waits_o)   \
    PORT(std::uint64_t, hps_irq_o)     \
    PORT(std::uint32_t, hps_gp_o)      \
    PORT(std::uint8_t, hps_reset_requests_o)

struct ChipPorts {
#define DE1SIM_DECLARE(type, name) type& name;
    DE1SIM_CHIP_PORTS(DE1SIM_DECLARE)
#undef DE1SIM_DECLARE
};

class Design {
public:
    virtual ~Design() = default;

    virtual ChipPorts ports() = 0;  // valid as long as the design
    // After inputs have moved.  `now_ps` is what $time gives.  May throw Diverged (endings.h).
    virtual void eval(std::uint64_t now_ps) = 0;
    virtual void final() = 0;

    // Waveforms, in FST; false, and nothing is done, in a design that was compiled without.
    virtual bool begin_trace(const std::string& file) = 0;
    virtual void dump(std::uint64_t time_ps) = 0;
    virtual void end_trace() = 0;
};

struct PllTimes {
    std::uint64_t period_fs, phase_fs, high_fs;
    unsigned pins;    // bits of clocks_o, if it drives these alone; else 0
    bool only_rises;  // nothing sees its fall
};

// A UART of the processor's, at the place of this number.
struct PlacedUart {
    const char* instance;
    unsigned number;
};

struct DesignFacts {
    const PllTimes* pll_clocks;
    unsigned pll_clock_count;
    bool pulses;  // a change of a clock that only rises is a pulse, else its falls have to come
    bool clock_50_only_rises;
    bool td_clk27_used, vga_used, aud_xck_used, aud_clocks_driven;
    const char* const* source_folders;  // from the project's on, for init files
    unsigned source_folder_count;
    const PlacedUart* placed_uarts;  // up to one without a name
    const char* loops;               // signals that depend on themselves; "": none
};

// The caller deletes it.
FpgaModel* play(std::unique_ptr<Design> design, const DesignFacts& facts, PinListener& pins,
                const ModelSettings& settings);

}  // namespace sim::project
