#include "sim/fpga/fabric.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "Vfpga.h"
#include "verilated.h"
#ifndef DE1SIM_PORTS_ALONE
#include "Vfpga___024root.h"
#endif
#ifdef DE1SIM_TRACE
#include "verilated_fst_c.h"
#endif

namespace sim {

namespace {

constexpr std::uint64_t LEAP_PS = 2'000'000;  // more than is ever left out at once

}  // namespace

// Bits of moved_i.
enum Moved : std::uint8_t { LIGHTWEIGHT = 1, FULL = 2, PINS = 4 };

// The signals of one AXI3 port; both bridges have the same shapes.
struct Fabric::AxiPort {
    CData &awlen, &awsize, &awburst, &awvalid, &awready, &wstrb, &wvalid, &wready, &bresp, &bvalid,
        &bready, &arlen, &arsize, &arburst, &arvalid, &arready, &rresp, &rlast, &rvalid, &rready;
    SData &awid, &bid, &arid, &rid;
    IData &awaddr, &wdata, &araddr, &rdata;
};

#define AXI_PORT(m, b)                                                                           \
    {                                                                                            \
        m.b##_awlen_i, m.b##_awsize_i, m.b##_awburst_i, m.b##_awvalid_i, m.b##_awready_o,        \
            m.b##_wstrb_i, m.b##_wvalid_i, m.b##_wready_o, m.b##_bresp_o, m.b##_bvalid_o,        \
            m.b##_bready_i, m.b##_arlen_i, m.b##_arsize_i, m.b##_arburst_i, m.b##_arvalid_i,     \
            m.b##_arready_o, m.b##_rresp_o, m.b##_rlast_o, m.b##_rvalid_o, m.b##_rready_i,       \
            m.b##_awid_i, m.b##_bid_o, m.b##_arid_i, m.b##_rid_o, m.b##_awaddr_i, m.b##_wdata_i, \
            m.b##_araddr_i, m.b##_rdata_o                                                        \
    }

struct Fabric::Model {
    VerilatedContext context;
    Vfpga top{&context};
    AxiPort lw AXI_PORT(top, lw);
    AxiPort h2f AXI_PORT(top, h2f);
    // Or are those left out in which nothing happens?  (VGA_CLK rises in the middle of a clock.)
#if defined DE1SIM_TRACE
    bool every_clock = true;
    VerilatedFstC waveforms;
    Trace trace;
#elif defined DE1SIM_EVERY_CLOCK
    static constexpr bool every_clock = true;
#else
    static constexpr bool every_clock = false;
#endif
    void eval([[maybe_unused]] std::uint64_t time_ps);
    void clock_every(bool every);
    // What a fabric whose groups sleep says and hears.  One in which all clocks run has no such
    // pins.
#ifdef DE1SIM_EVERY_CLOCK
    bool td_awake() const { return true; }
    bool stirs() const { return true; }
    std::uint64_t rest() const { return 0; }
    void leave_out(std::uint64_t) {}
    void tell_moved(std::uint8_t) {}
#else
    bool td_awake() const { return top.td_awake_o; }
    bool stirs() const { return top.stirs_o; }
    std::uint64_t rest() const { return top.rest_o; }
    void leave_out(std::uint64_t clocks) { top.skip_i = static_cast<SData>(clocks); }
    void tell_moved(std::uint8_t moved) { top.moved_i = moved; }
#endif
    AxiPort& port(Bridge bridge) { return bridge == Bridge::LIGHTWEIGHT ? lw : h2f; }
};

Fabric::Fabric(PinListener& pins, const Trace& trace, unsigned audio_rate)
    : pins_{pins},
      model_{std::make_unique<Model>()},
      audio_clock_{audio_clock(audio_rate)},
      td_clock_{decoder_clock()} {
    Vfpga& top = model_->top;
#ifdef DE1SIM_TRACE
    model_->trace = trace;
    if (!trace.file.empty()) {
        model_->context.traceEverOn(true);
        top.trace(&model_->waveforms, 99);
        model_->waveforms.open(trace.file.c_str());
        if (!model_->waveforms.isOpen())
            throw std::runtime_error(trace.file + ": cannot be written");
    }
#else
    if (!trace.file.empty()) throw std::logic_error("this build of the fabric has no tracing");
#endif
    apply_inputs();
    model_->lw.bready = model_->lw.rready = model_->h2f.bready = model_->h2f.rready = 1;
    constexpr std::uint8_t all = LIGHTWEIGHT | FULL | PINS;
    top.audio_48k_i = audio_rate == 48'000;
    top.rst_i = top.rst_audio_i = top.rst_td_i = 1;
    for (int i = 0; i < 2; ++i) {  // on the board too these resets end first
        top.clk_audio_i = top.clk_td_i = 1;
        top.eval();
        top.clk_audio_i = top.clk_td_i = 0;
        top.eval();
    }
    top.rst_audio_i = top.rst_td_i = 0;
#ifdef DE1SIM_TRACE
    model_->clock_every(trace.from_ps == 0);
#endif
    td_on_ = model_->every_clock;
    for (int i = 0; i < 8; ++i) {
        moved_ = all;
        clock(1);
    }
    top.rst_i = 0;
    moved_ = all;
}

Fabric::~Fabric() {
    end_trace();
    model_->top.final();
    Verilated::threadContextp(&model_->context);  // that of the scopes which go now
}

void Fabric::end_trace() {
#ifdef DE1SIM_TRACE
    model_->waveforms.close();
#endif
}

bool Fabric::can_trace() {
#ifdef DE1SIM_TRACE
    return true;
#else
    return false;
#endif
}

void Fabric::apply_inputs() {
    Vfpga& top = model_->top;
    top.sw_i = in.sw;
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
    moved_ |= PINS;
    jtag.typed = jtag.idle = 0;
}

inline void Fabric::Model::eval([[maybe_unused]] std::uint64_t time_ps) {
    top.eval();
#ifdef DE1SIM_TRACE
    if (waveforms.isOpen() && trace.wants(time_ps)) waveforms.dump(time_ps);
#endif
}

inline void Fabric::Model::clock_every([[maybe_unused]] bool every) {
#ifdef DE1SIM_TRACE
    every_clock = every;
    top.rootp->fpga__DOT__clocks__DOT__root__DOT__every_clock = every;
#endif
}

// What the other clocks do before so many halves of the fabric's have passed.
inline void Fabric::other_edges(std::uint64_t halves) {
    for (;;) {
        const bool audio = audio_clock_.before(halves), td = td_on_ && td_clock_.before(halves);
        if (td && !(audio && audio_clock_.time_ps() < td_clock_.time_ps()))
            td_edge();
        else if (audio)
            audio_edge();
        else
            break;
    }
}

void Fabric::audio_edge() {
    Vfpga& top = model_->top;
    const std::uint64_t time_ps = audio_clock_.time_ps();
    const bool rises = audio_clock_.rises();
    top.clk_audio_i = rises;
    if (rises) top.aud_adcdat_i = in.adcdat;
    model_->eval(time_ps);
    if (rises) tell_codec(time_ps);
    audio_clock_.next();
    if (model_->every_clock) return;
    top.clk_audio_i = 0;  // changes nothing: the next eval() will do
    audio_clock_.next();
}

void Fabric::td_edge() {
    Vfpga& top = model_->top;
    const std::uint64_t time_ps = td_clock_.time_ps();
    const bool rises = td_clock_.rises();
    if (std::exchange(td_falls_, false)) model_->eval(time_ps);  // rises twice in a clock
    top.clk_td_i = rises;
    if (rises) top.td_data_i = pins_.td_data(td_clock_.number());
    model_->eval(time_ps);
    td_clock_.next();
    if (model_->every_clock) return;
    top.clk_td_i = 0;
    td_falls_ = true;
    td_clock_.next();
}

// The decoder's clock goes on as if it had never stopped.
void Fabric::wake_td() {
    if (std::exchange(td_on_, model_->td_awake()) || !td_on_) return;
    td_clock_.skip_to(clocks_);
}

// Waveforms are wanted from the next clock on.
void Fabric::begin_trace() {
    model_->clock_every(true);
    if (!std::exchange(td_on_, true)) td_clock_.skip_to(clocks_);
    model_->leave_out(0);
}

// Runs one clock, and leaves out those after it in which nothing happens: `most` in all, and none
// behind the next edge of another clock.  Returns how many have passed.
inline std::uint64_t Fabric::clock(std::uint64_t most) {
    Vfpga& top = model_->top;
#ifdef DE1SIM_TRACE
    if (!model_->every_clock && time_ps() + LEAP_PS >= model_->trace.from_ps && !top.clk_i)
        begin_trace();
#endif
    const bool every_clock = model_->every_clock;
    if (every_clock) {
        other_edges(2 * clocks_ + 1);
        top.clk_i = 0;
        model_->eval(time_ps() + FABRIC_PERIOD_PS / 2);
    }
    other_edges(2 * clocks_ + 2);
    if (std::exchange(look_, false) &&
        (jtag.typed || jtag.idle || !(jtag == applied_jtag_) || !(in == applied_)))
        apply_inputs();
    bool stirs = true;
    std::uint64_t passed = 1;
    if (every_clock) {
        top.clk_i = 1;
    } else {
        stirs = moved_ || model_->stirs();
        most = td_on_ ? 1 : std::min(most, audio_clock_.clocks() - clocks_);
        const std::uint64_t skip = moved_ ? 0 : std::min(model_->rest(), most - 1);
        passed += skip;
        model_->leave_out(skip);
        model_->tell_moved(moved_);
        top.clk_i = !top.clk_i;  // sim/fpga/root_clock.v
    }
    moved_ = 0;
    model_->eval(time_ps() + FABRIC_PERIOD_PS);
    clocks_ += passed;
    td_falls_ = false;
    if (!every_clock && (stirs || td_on_)) wake_td();

    const std::uint32_t sample = static_cast<std::uint32_t>(top.vga_r_o) << 16 |
                                 static_cast<std::uint32_t>(top.vga_g_o) << 8 | top.vga_b_o |
                                 static_cast<std::uint32_t>(top.vga_hs_no) << 24 |
                                 static_cast<std::uint32_t>(top.vga_vs_no) << 25 |
                                 static_cast<std::uint32_t>(top.vga_blank_no) << 26 |
                                 static_cast<std::uint32_t>(top.vga_sync_no) << 27;
    for (std::uint64_t i = 0; i < passed; ++i) {
        video_[video_count_++] = sample;
        if (video_count_ == VIDEO_BATCH) flush();
    }
    if ((!top.dram_cs_no || sdram_) && !top.rst_i) tell_sdram();
    if (stirs) tell_pins();  // else only the picture can have moved
    return passed;
}

void Fabric::tell_sdram() {
    Vfpga& top = model_->top;
    pins_.sdram(
        {top.dram_cs_no != 0, top.dram_ras_no != 0, top.dram_cas_no != 0, top.dram_we_no != 0,
         top.dram_ba_o, top.dram_dqm_o, top.dram_addr_o, top.dram_dq_o, top.dram_dq_oe_o != 0},
        time_ps() - FABRIC_PERIOD_PS / 2, top.dram_dq_i, sdram_);
}

void Fabric::tell_pins() {
    Vfpga& top = model_->top;
    look_ = true;
    tell_codec(time_ps());
    HeaderBits& was = headers_was_;
    if ((top.jp1_o ^ was.jp1) | (top.jp1_oe_o ^ was.jp1_oe) | (top.jp2_o ^ was.jp2) |
        (top.jp2_oe_o ^ was.jp2_oe)) {
        was = {top.jp1_o, top.jp1_oe_o, top.jp2_o, top.jp2_oe_o};
        pins_.headers({{pins_of_bits(was.jp1), pins_of_bits(was.jp2)},
                       {pins_of_bits(was.jp1_oe), pins_of_bits(was.jp2_oe)}},
                      time_ps(), in);
    }
    const bool lamps_moved = top.ledr_o != lamps_was_.ledr || top.hex_no != lamps_was_.hex_n;
    if (lamps_moved && !top.rst_i) {  // before, they are of a model that has not begun
        lamps_was_ = {top.ledr_o, top.hex_no};
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
        pins_.ps2(ps2 & 3, ps2 >> 2, in);
    }
    for (unsigned sent = top.jtag_sent_o, n = 0; sent >> n; ++n)
        if (sent >> n & 1) jtag_sent_(n, static_cast<char>(top.jtag_sent_data_o >> 8 * n), jtag);
}

void Fabric::tell_codec(std::uint64_t time_ps) {
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

void Fabric::run(std::uint64_t clocks) {
    look_ = true;
    while (clocks) clocks -= clock(clocks);
}

void Fabric::flush() {
    const unsigned count = video_count_;
    video_count_ = 0;
    if (count) pins_.video(video_, count);
}

// Runs up to and including the clock edge that sees `ready` high.
bool Fabric::clock_until(const std::uint8_t& ready) {
    for (unsigned i = 0; i < ANSWER_CLOCKS; ++i) {
        const bool taken = ready;
        clock(1);
        if (taken) return true;
    }
    return false;
}

namespace {

// Beats of one byte or one aligned half-word are narrow, as the processor makes them; all others
// are words, with the lanes that are not meant left out by strobes.
unsigned size_of(std::uint32_t address, unsigned bytes) {
    if (bytes == 1) return 0;
    if (bytes == 2 && address % 2 == 0) return 1;
    return 2;
}

}  // namespace

AxiResponse Fabric::write(Bridge bridge, std::uint32_t address, const std::uint8_t* data,
                          unsigned bytes) {
    look_ = true;
    AxiPort& axi = model_->port(bridge);
    const std::uint32_t first = address / 4, last = (address + bytes - 1) / 4;
    axi.awaddr = address;
    axi.awlen = static_cast<CData>(last - first);
    axi.awsize = static_cast<CData>(size_of(address, bytes));
    axi.awburst = 1;  // INCR
    axi.awvalid = 1;
    moved_ |= bridge == Bridge::LIGHTWEIGHT ? LIGHTWEIGHT : FULL;
    bool alive = clock_until(axi.awready);
    axi.awvalid = 0;
    const std::uint32_t end = address + bytes;
    for (std::uint32_t word = first; alive && word <= last; ++word) {
        const std::uint32_t from = std::max(address, word * 4), to = std::min(end, word * 4 + 4);
        std::uint32_t value = 0;
        unsigned strobes = 0;
        for (std::uint32_t a = from; a < to; ++a) {
            value |= static_cast<std::uint32_t>(data[a - address]) << (a % 4 * 8);
            strobes |= 1u << a % 4;
        }
        axi.wdata = value;
        axi.wstrb = static_cast<CData>(strobes);
        axi.wvalid = 1;
        alive = clock_until(axi.wready);
    }
    axi.wvalid = 0;
    for (unsigned i = 0; alive && !axi.bvalid; ++i) {
        if (i == ANSWER_CLOCKS) alive = false;
        clock(1);
    }
    if (!alive) return AxiResponse::NONE;
    const auto response = static_cast<AxiResponse>(axi.bresp);
    clock(1);
    return response;
}

AxiResponse Fabric::read(Bridge bridge, std::uint32_t address, std::uint8_t* data, unsigned bytes) {
    look_ = true;
    AxiPort& axi = model_->port(bridge);
    const std::uint32_t first = address / 4, last = (address + bytes - 1) / 4,
                        end = address + bytes;
    axi.araddr = address;
    axi.arlen = static_cast<CData>(last - first);
    axi.arsize = static_cast<CData>(size_of(address, bytes));
    axi.arburst = 1;  // INCR
    axi.arvalid = 1;
    moved_ |= bridge == Bridge::LIGHTWEIGHT ? LIGHTWEIGHT : FULL;
    bool alive = clock_until(axi.arready);
    axi.arvalid = 0;
    AxiResponse response = AxiResponse::OKAY;
    for (std::uint32_t word = first; alive && word <= last; ++word) {
        for (unsigned i = 0; alive && !axi.rvalid; ++i) {
            if (i == ANSWER_CLOCKS) alive = false;
            clock(1);
        }
        if (!alive) break;
        if (axi.rresp != 0) response = static_cast<AxiResponse>(axi.rresp);
        const std::uint32_t from = std::max(address, word * 4), to = std::min(end, word * 4 + 4);
        for (std::uint32_t a = from; a < to; ++a)
            data[a - address] = static_cast<std::uint8_t>(axi.rdata >> (a % 4 * 8));
        clock(1);
    }
    return alive ? response : AxiResponse::NONE;
}

#ifdef DE1SIM_PORTS_ALONE
bool Fabric::has_memory() const { return false; }
void Fabric::read_onchip(std::uint32_t, std::uint8_t*, unsigned) const {}
void Fabric::write_onchip(std::uint32_t, const std::uint8_t*, unsigned) {}
std::optional<Fabric::Audio> Fabric::audio() const { return {}; }
#else
#define LANE(n) &top.rootp->fpga__DOT__video_block__DOT__onchip__DOT__memory__DOT__lane##n[0]
#define LANES \
    { LANE(0), LANE(1), LANE(2), LANE(3) }

bool Fabric::has_memory() const { return true; }

void Fabric::read_onchip(std::uint32_t offset, std::uint8_t* data, unsigned bytes) const {
    Vfpga& top = model_->top;
    const CData* const lanes[] = LANES;
    for (unsigned i = 0; i < bytes; ++i, ++offset) data[i] = lanes[offset % 4][offset / 4];
}

void Fabric::write_onchip(std::uint32_t offset, const std::uint8_t* data, unsigned bytes) {
    Vfpga& top = model_->top;
    CData* const lanes[] = LANES;
    for (unsigned i = 0; i < bytes; ++i, ++offset) lanes[offset % 4][offset / 4] = data[i];
}

#define AUDIO(signal) top.rootp->fpga__DOT__audio_block__DOT__##signal

std::optional<Fabric::Audio> Fabric::audio() const {
    const Vfpga& top = model_->top;
    return Audio{{AUDIO(left_out_count), AUDIO(right_out_count)},
                 {AUDIO(left_in_count), AUDIO(right_in_count)},
                 AUDIO(underruns_q)};
}
#endif

std::uint16_t Fabric::ledr() const { return model_->top.ledr_o; }
std::uint64_t Fabric::hex_n() const { return model_->top.hex_no; }
std::uint32_t Fabric::irq() const { return model_->top.irq_o; }
std::uint8_t Fabric::jtag_room() const { return model_->top.jtag_room_o; }

}  // namespace sim
