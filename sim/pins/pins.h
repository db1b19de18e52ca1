// pins.h - the seam between the chip and the board: the pins, in groups that move together.
//
// On one side is whatever is in the chip, which calls a PinListener when its outputs have moved and
// reads ChipInputs; on the other are the parts of the board, which never ask what drives them.
// A wire that both sides may drive is two values: the level that the chip drives, or that it pulls
// the wire low, and the level that is on the wire.
//
// Whatever crosses the seam has its time, in both directions, also where the chip runs far at once.
// A call says when the outputs have moved.  The board changes ChipInputs in such a call, as an
// answer without delay, or in an entry of its agenda, which the chip keeps; at no other place.
// What changes at a time counts from the first clock edge after it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/pins/agenda.h"
#include "sim/pins/chip_wires.h"
#include "sim/pins/header_bits.h"

namespace sim {

// One sample of the ADV7123's pins at a rising edge of VGA_CLK.
namespace video {
constexpr std::uint32_t RGB = 0x00ffffff;  // R 23:16, G 15:8, B 7:0
constexpr std::uint32_t HS = 1u << 24, VS = 1u << 25, BLANK_N = 1u << 26, SYNC_N = 1u << 27;
constexpr std::uint64_t PERIOD_PS = 40'000;  // until PinListener::video_clock() says another
}  // namespace video

struct CodecPins {
    bool bclk, daclrck, adclrck, dacdat, sclk, sdat_low;  // sdat_low: the FPGA pulls SDAT low
    bool clocks_driven = true;  // the FPGA drives BCLK or an LRCK, or must be doing so
};

// What the codec drives while it is the bus master.
struct CodecClocks {
    bool driven = false, bclk = false, daclrck = false, adclrck = false;
    std::uint64_t bclk_half_fs = 0;  // from one edge of BCLK to the next; 0: it stands still
};

// Of the headers in the table's order: bit n of [0] is GPIO_0[n], of [1] GPIO_1[n], of [2]
// ARDUINO_IO[n].
constexpr unsigned HEADERS = names_of(WireGroup::HEADERS);
using HeaderMasks = std::array<std::uint64_t, HEADERS>;

constexpr HeaderMasks all_header_pins() {
    HeaderMasks all{};
    for (unsigned n = 0; n < HEADERS; ++n) all[n] = ALL_HEADER_PINS;
    return all;
}

struct HeaderPins {
    HeaderMasks levels, enable;  // levels driven, and where they are driven
};

// Before a rising edge of DRAM_CLK.
struct SdramPins {
    bool cs_n, ras_n, cas_n, we_n;
    std::uint8_t ba, dqm;
    std::uint16_t addr, dq;
    bool dq_driven;
    bool cke = true;
};

constexpr unsigned SWITCHES = wires_of(WireGroup::SWITCHES), LEDS = wires_of(WireGroup::LAMPS),
                   DIGITS = names_of(WireGroup::DIGITS);
static_assert(SWITCHES <= 32 && LEDS <= 32 && DIGITS <= 8);
constexpr std::uint64_t ALL_SEGMENTS = (std::uint64_t{1} << 7 * DIGITS) - 1;  // without points

struct LampPins {
    std::uint32_t ledr = 0;  // all LEDs in the table's order
    // HEX0 in 6:0, HEX1 in 13:7 and so on, 0 = lit; their points in the bits from 7 * DIGITS on,
    // 1 = lit.
    std::uint64_t hex_n = ALL_SEGMENTS;
};

struct AdcPins {
    bool convst, sck, sdi;
};

// An accelerometer on pins of the FPGA; levels, where nobody pulls them low high.
struct GsensorPins {
    bool cs_n, sclk, sdi, sdo;
};

struct ChipInputs {
    std::uint32_t sw = 0;
    std::uint8_t key_n = 0xf;
    HeaderMasks gpio = all_header_pins();
    bool adcdat = false, sdat = true, adc_sdo = false, irda_rxd = true;
    bool gsensor_sdi = true, gsensor_sdo = true;  // as far as the sensor pulls
    CodecClocks codec;
    std::uint8_t ps2_clk = 3, ps2_dat = 3;  // bit n of port n

    bool operator==(const ChipInputs& o) const {
        return sw == o.sw && key_n == o.key_n && gpio == o.gpio && sdat == o.sdat &&
               gsensor_sdi == o.gsensor_sdi && gsensor_sdo == o.gsensor_sdo &&
               adc_sdo == o.adc_sdo && irda_rxd == o.irda_rxd && ps2_clk == o.ps2_clk &&
               ps2_dat == o.ps2_dat;
    }
};

// What hangs on an I2C bus of the HPS, as its master sees it: byte by byte.
class I2cDevices {
public:
    // `scl_ps`: the period of SCL.
    virtual bool begin(std::uint8_t address, bool reads, std::uint64_t scl_ps,
                       std::uint64_t time_ps) = 0;                     // acknowledged
    virtual bool write(std::uint8_t byte, std::uint64_t time_ps) = 0;  // acknowledged
    virtual std::uint8_t read(std::uint64_t time_ps) = 0;
    virtual void end(std::uint64_t time_ps) = 0;  // STOP

protected:
    ~I2cDevices() = default;
};

class PinListener {
public:
    // What the board does by itself.  Looked at again after each call below that may change `in`.
    Agenda agenda;

    // A sample per clock, in order, in batches of up to a scan line.
    virtual void video(const std::uint32_t* samples, std::size_t count) = 0;
    // Before samples at another period than video::PERIOD_PS, and when it changes by 1 %.
    virtual void video_clock(std::uint64_t /*period_ps*/) {}
    // There has been no sample up to now for more than a millisecond.
    virtual void video_idle(std::uint64_t /*time_ps*/) {}
    // Called after a clock in which one of them moved; may change `in`.
    virtual void codec(const CodecPins& pins, std::uint64_t time_ps, ChipInputs& in) = 0;
    // The period of AUD_XCK when it has changed; 0: it stands still.  May change `in`.
    virtual void xck(std::uint64_t /*period_fs*/, std::uint64_t /*time_ps*/, ChipInputs& /*in*/) {}
    // The codec's next edge of BCLK, in.codec.bclk_half_fs after the one before; changes `in`.
    virtual void bclk_edge(std::uint64_t /*time_ps*/, ChipInputs& /*in*/) {}
    virtual void headers(const HeaderPins& pins, std::uint64_t time_ps, ChipInputs& in) = 0;
    virtual void lamps(const LampPins& /*pins*/, std::uint64_t /*time_ps*/) {}
    virtual void adc(const AdcPins& pins, std::uint64_t time_ps, ChipInputs& in) = 0;
    virtual void gsensor(const GsensorPins& /*pins*/, std::uint64_t /*time_ps*/,
                         ChipInputs& /*in*/) {}
    // What is wired to an analog input of the board, 0 to 7, in millivolts against ground: for a
    // converter inside the chip.
    virtual int analog_mv(unsigned /*input*/) const { return 0; }
    // Called in each clock in which CS_N is low or CKE has moved, and in the next ones for as long
    // as `more` stays true.  `dq` is what is on DQ when the next clock begins.
    virtual void sdram(const SdramPins& pins, std::uint64_t time_ps, std::uint16_t& dq,
                       bool& more) = 0;
    // What the PS/2 ports pull low, bit n of port n.
    virtual void ps2(unsigned clk_low, unsigned dat_low, std::uint64_t time_ps, ChipInputs& in) = 0;
    // TD_DATA at a rise of TD_CLK27, the first of which is number 0.  Asked of those alone at which
    // somebody captures, in their order.
    virtual std::uint8_t td_data(std::uint64_t /*rise*/) { return 0; }

    // The HPS's I2C0; asked for once, before time begins.  May be none.
    virtual I2cDevices* hps_i2c0() { return nullptr; }
    // HPS_LED.
    virtual void hps_led(bool /*lit*/, std::uint64_t /*time_ps*/) {}
    // Those of boards with an LCD there: the levels of GPIO1, and a frame that SPI master 0 has
    // sent to slave 0.
    virtual void hps_gpio1(std::uint32_t /*levels*/) {}
    virtual void hps_spi0(std::uint32_t /*frame*/) {}

protected:
    ~PinListener() = default;
};

}  // namespace sim
