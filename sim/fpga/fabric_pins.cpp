// fabric_pins.cpp - what the fabric's pins hear and say
#include "sim/fpga/fabric.h"
#include "sim/fpga/fabric_model.h"

namespace sim {

namespace {

// As LampPins has it; the fabric has six digits.
std::uint64_t of_all_digits(std::uint64_t hex_n) {
    constexpr std::uint64_t SEGMENTS = (std::uint64_t{1} << 42) - 1;
    return (hex_n & SEGMENTS) | (ALL_SEGMENTS & ~SEGMENTS) | hex_n >> 42 << 7 * DIGITS;
}

}  // namespace

void Fabric::apply_inputs() {
    Vfpga& top = model_->top;
    top.sw_i = static_cast<std::uint16_t>(in.sw & 0x3ff);
    top.key_ni = in.key_n;
    top.jp1_i = bits_of_pins(in.gpio[0]);
    top.jp2_i = bits_of_pins(in.gpio[1]);
    top.i2c_sdat_i = in.sdat;
    top.adc_sdo_i = in.adc_sdo;
    top.irda_rxd_i = in.irda_rxd;
    top.ps2_clk_i = in.ps2_clk;
    top.ps2_dat_i = in.ps2_dat;
    top.jtag_take_i = jtag.take;
    top.jtag_typed_i = jtag.typed;
    top.jtag_typed_data_i = jtag.bytes;
    top.jtag_idle_i = jtag.idle;
    applied_ = in;
    applied_jtag_ = jtag;
    look_ = true;
    ++changes_;
    moved_ |= PINS;
    jtag.typed = jtag.idle = 0;
}

void Fabric::notify_sdram() {
    Vfpga& top = model_->top;
    pins_.sdram(
        {top.dram_cs_no != 0, top.dram_ras_no != 0, top.dram_cas_no != 0, top.dram_we_no != 0,
         top.dram_ba_o, top.dram_dqm_o, top.dram_addr_o, top.dram_dq_o, top.dram_dq_oe_o != 0},
        time_ps() - FABRIC_PERIOD_PS / 2, top.dram_dq_i, sdram_);
}

void Fabric::notify_pins() {
    Vfpga& top = model_->top;
    look_ = true;
    notify_codec(time_ps());
    HeaderBits& was = headers_was_;
    if ((top.jp1_o ^ was.jp1) | (top.jp1_oe_o ^ was.jp1_oe) | (top.jp2_o ^ was.jp2) |
        (top.jp2_oe_o ^ was.jp2_oe)) {
        was = {top.jp1_o, top.jp1_oe_o, top.jp2_o, top.jp2_oe_o};
        pins_.headers({{pins_of_bits(was.jp1), pins_of_bits(was.jp2)},
                       {pins_of_bits(was.jp1_oe), pins_of_bits(was.jp2_oe)}},
                      time_ps(), in);
    }
    const LampPins lamps{top.ledr_o, of_all_digits(top.hex_no)};
    const bool lamps_moved = lamps.ledr != lamps_was_.ledr || lamps.hex_n != lamps_was_.hex_n;
    if (lamps_moved && !top.rst_i) {  // before, they are of a model that has not begun
        lamps_was_ = lamps;
        pins_.lamps(lamps_was_, time_ps());
    }
    const std::uint32_t adc =
        static_cast<std::uint32_t>(top.adc_convst_o | top.adc_sck_o << 1 | top.adc_sdi_o << 2);
    if (adc != adc_was_) {
        adc_was_ = adc;
        pins_.adc({top.adc_convst_o != 0, top.adc_sck_o != 0, top.adc_sdi_o != 0}, time_ps(), in);
    }
    const unsigned ps2 = static_cast<unsigned>(top.ps2_clk_low_o | top.ps2_dat_low_o << 2);
    if (ps2 != ps2_was_) {
        ps2_was_ = ps2;
        pins_.ps2(ps2 & 3, ps2 >> 2, time_ps(), in);
    }
    for (unsigned sent = top.jtag_sent_o, n = 0; sent >> n; ++n)
        if (sent >> n & 1) jtag_sent_(n, static_cast<char>(top.jtag_sent_data_o >> 8 * n), jtag);
    if (pins_.agenda.next_ps() != agenda_ps_) look_ahead();
}

void Fabric::notify_codec(std::uint64_t time_ps) {
    const Vfpga& top = model_->top;
    const std::uint32_t codec = static_cast<std::uint32_t>(
        top.aud_bclk_o | top.aud_daclrck_o << 1 | top.aud_adclrck_o << 2 | top.aud_dacdat_o << 3 |
        top.i2c_sclk_o << 4 | top.i2c_sdat_oe_o << 5);
    if (codec == codec_was_) return;
    codec_was_ = codec;
    pins_.codec({top.aud_bclk_o != 0, top.aud_daclrck_o != 0, top.aud_adclrck_o != 0,
                 top.aud_dacdat_o != 0, top.i2c_sclk_o != 0, top.i2c_sdat_oe_o != 0},
                time_ps, in);
}

std::uint16_t Fabric::ledr() const { return model_->top.ledr_o; }
std::uint64_t Fabric::hex_n() const { return model_->top.hex_no; }
std::uint64_t Fabric::interrupts() const { return model_->top.irq_o; }
std::uint8_t Fabric::jtag_room() const { return model_->top.jtag_room_o; }

}  // namespace sim
