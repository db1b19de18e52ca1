// chip_pins.h - where in the ports of de1sim_chip.v what is, by the table of wires: for model.cpp.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "sim/pins/header_pin.h"
#include "sim/project/runtime/design.h"

namespace sim::project {

// Whether these wires are the bits of a port from `lsb` on, bit 0 first.
constexpr bool are_in_order(ChipPort port, unsigned lsb, std::initializer_list<ChipWire> wires) {
    for (const ChipWire wire : wires) {
        if (lsb_of(port, wire) != lsb) return false;
        lsb += row_of(wire).width;
    }
    return true;
}

// ---- pins_o and aud_i: groups, each of which is looked at as one number ----

constexpr unsigned in_pins(ChipWire wire) { return lsb_of(ChipPort::pins_o, wire); }
constexpr unsigned ADC_LSB = in_pins(ChipWire::ADC_CS_N), ADC_MASK = 7;
constexpr unsigned PS2_LSB = in_pins(ChipWire::PS2_CLK);
constexpr unsigned CODEC_LSB = in_pins(ChipWire::AUD_ADCLRCK);
constexpr unsigned GSENSOR_LSB = in_pins(ChipWire::GSENSOR_CS_N), GSENSOR_MASK = 15;
static_assert(are_in_order(ChipPort::pins_o, ADC_LSB,
                           {ChipWire::ADC_CS_N, ChipWire::ADC_SCLK, ChipWire::ADC_DIN}));
static_assert(are_in_order(ChipPort::pins_o, PS2_LSB,
                           {ChipWire::PS2_CLK, ChipWire::PS2_CLK2, ChipWire::PS2_DAT,
                            ChipWire::PS2_DAT2}));
static_assert(are_in_order(ChipPort::pins_o, CODEC_LSB,
                           {ChipWire::AUD_ADCLRCK, ChipWire::AUD_DACLRCK, ChipWire::AUD_BCLK,
                            ChipWire::AUD_DACDAT, ChipWire::FPGA_I2C_SCLK,
                            ChipWire::FPGA_I2C_SDAT}));
static_assert(are_in_order(ChipPort::pins_o, GSENSOR_LSB,
                           {ChipWire::GSENSOR_CS_N, ChipWire::GSENSOR_SCLK, ChipWire::GSENSOR_SDI,
                            ChipWire::GSENSOR_SDO}));
static_assert(are_in_order(ChipPort::aud_i, 0,
                           {ChipWire::AUD_ADCLRCK, ChipWire::AUD_DACLRCK, ChipWire::AUD_BCLK}));

// ---- clocks_o ----

constexpr unsigned in_clocks(ChipWire wire) { return 1u << lsb_of(ChipPort::clocks_o, wire); }
constexpr unsigned AUD_XCK = in_clocks(ChipWire::AUD_XCK), DRAM_CLK = in_clocks(ChipWire::DRAM_CLK),
                   VGA_CLK = in_clocks(ChipWire::VGA_CLK);

// ---- vga_o, as in namespace video; dram_o ----

static_assert(are_in_order(ChipPort::vga_o, 0,
                           {ChipWire::VGA_B, ChipWire::VGA_G, ChipWire::VGA_R, ChipWire::VGA_HS,
                            ChipWire::VGA_VS, ChipWire::VGA_BLANK_N, ChipWire::VGA_SYNC_N}));

constexpr unsigned in_dram(ChipWire wire) { return lsb_of(ChipPort::dram_o, wire); }
constexpr unsigned CKE_LSB = in_dram(ChipWire::DRAM_CKE), CS_LSB = in_dram(ChipWire::DRAM_CS_N),
                   RAS_LSB = in_dram(ChipWire::DRAM_RAS_N), CAS_LSB = in_dram(ChipWire::DRAM_CAS_N),
                   WE_LSB = in_dram(ChipWire::DRAM_WE_N), BA_LSB = in_dram(ChipWire::DRAM_BA),
                   ADDR_LSB = in_dram(ChipWire::DRAM_ADDR), DQM_LSB = in_dram(ChipWire::DRAM_LDQM);
static_assert(are_in_order(ChipPort::dram_o, WE_LSB,
                           {ChipWire::DRAM_WE_N, ChipWire::DRAM_CAS_N, ChipWire::DRAM_RAS_N,
                            ChipWire::DRAM_CS_N}));
static_assert(are_in_order(ChipPort::dram_o, DQM_LSB, {ChipWire::DRAM_LDQM, ChipWire::DRAM_UDQM}));

// With what is on DQ, and whether the chip drives that.
inline SdramPins sdram_of(std::uint32_t dram, std::uint16_t dq, bool dq_driven) {
    const auto bit = [dram](unsigned lsb) { return (dram >> lsb & 1) != 0; };
    return {bit(CS_LSB),
            bit(RAS_LSB),
            bit(CAS_LSB),
            bit(WE_LSB),
            static_cast<std::uint8_t>(dram >> BA_LSB & 3),
            static_cast<std::uint8_t>(dram >> DQM_LSB & 3),
            static_cast<std::uint16_t>(dram >> ADDR_LSB & 0x1fff),
            dq,
            dq_driven,
            bit(CKE_LSB)};
}

// ---- The headers' ports ----

inline HeaderPins headers_of(const ChipPorts& chip) {
    HeaderPins pins{};
#define CHIP_HEADER(wire, port)                             \
    pins.levels[header_of(ChipWire::wire)] = chip.port##_o; \
    pins.enable[header_of(ChipWire::wire)] = chip.port##_oe_o;
#include "sim/pins/chip_wires.def"
    return pins;
}

// Not 0: the chip's levels are others.
inline std::uint64_t levels_moved(const HeaderPins& pins, const ChipPorts& chip) {
    std::uint64_t moved = 0;
#define CHIP_HEADER(wire, port) moved |= pins.levels[header_of(ChipWire::wire)] ^ chip.port##_o;
#include "sim/pins/chip_wires.def"
    return moved;
}

// Not 0: the chip drives other pins.  It is so only where levels have moved, or what the board
// pulls low.
inline std::uint64_t enable_moved(const HeaderPins& pins, const ChipPorts& chip) {
    std::uint64_t moved = 0;
#define CHIP_HEADER(wire, port) moved |= pins.enable[header_of(ChipWire::wire)] ^ chip.port##_oe_o;
#include "sim/pins/chip_wires.def"
    return moved;
}

// Where the board's level is low and the chip does not drive.
inline void pull_headers(const ChipPorts& chip, const HeaderMasks& levels,
                         const HeaderMasks& enable) {
#define CHIP_HEADER(wire, port)                                                   \
    chip.port##_low_i = static_cast<PortWord<row_of(ChipWire::wire).width>>(      \
        ~levels[header_of(ChipWire::wire)] & ~enable[header_of(ChipWire::wire)] & \
        pins_of(ChipWire::wire));
#include "sim/pins/chip_wires.def"
}

}  // namespace sim::project
