#include "sim/fpga/fabric.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/fpga/fabric_model.h"

namespace sim {

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
    model_->lw.rready = model_->h2f.rready = 1;
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
    if (rises) notify_codec(time_ps);
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
// after the next edge of another clock.  Returns how many have passed.
inline std::uint64_t Fabric::clock(std::uint64_t most) {
    Vfpga& top = model_->top;
#ifdef DE1SIM_TRACE
    constexpr std::uint64_t LEAP_PS = 2'000'000;  // more than is ever left out at once
    if (!model_->every_clock && time_ps() + LEAP_PS >= model_->trace.from_ps && !top.clk_i)
        begin_trace();
#endif
    if (clocks_ >= until_) stop();
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
    bool pins_may_move = true;
    std::uint64_t passed = 1;
    if (every_clock) {
        top.clk_i = 1;
    } else {
        pins_may_move = moved_ || model_->pins_may_move();
        most = td_on_ ? 1 : std::min({most, audio_clock_.clocks() - clocks_, until_ - clocks_});
        const std::uint64_t skip = moved_ ? 0 : std::min(model_->rest(), most - 1);
        passed += skip;
        model_->leave_out(skip);
        model_->notify_moved(moved_);
        top.clk_i = !top.clk_i;  // sim/fpga/root_clock.v
    }
    changes_ += pins_may_move && !accessed_;
    moved_ = 0;
    model_->eval(time_ps() + FABRIC_PERIOD_PS);
    clocks_ += passed;
    td_falls_ = false;
    if (!every_clock && (pins_may_move || td_on_)) wake_td();

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
    if ((!top.dram_cs_no || sdram_) && !top.rst_i) notify_sdram();
    if (pins_may_move) notify_pins();  // else only the picture can have moved
    return passed;
}

// Somebody else may have been at the inputs, or at the agenda.
void Fabric::begin() {
    look_ = true;
    look_ahead();
}

void Fabric::look_ahead() {
    agenda_ps_ = pins_.agenda.next_ps();
    until_ = std::min(agenda_ps_, meet_ps_) / FABRIC_PERIOD_PS;
}

// What comes before the next clock's edge.
void Fabric::stop() {
    const std::uint64_t edge_ps = time_ps() + FABRIC_PERIOD_PS;
    while (meet_ps_ < edge_ps) meet_ps_ = (*met_)();
    keep_agenda(edge_ps - 1);
}

void Fabric::keep_agenda(std::uint64_t time_ps) {
    pins_.agenda.run_to(time_ps);
    begin();
}

void Fabric::run(std::uint64_t clocks) {
    begin();
    while (clocks) clocks -= clock(clocks);
}

// The registers change in clocks of their groups alone, and these wake by themselves when their
// time has come, at the frame's end, by a pair of samples from the audio clock, or when the
// characters have been cleared.  The frame ends with a line, and a pair is seen one edge of that
// clock before it comes.
std::uint64_t Fabric::calm() const {
    constexpr std::uint64_t LINE = 800;
    if (td_on_ || moved_ || model_->pins_may_move()) return 0;
    if (model_->cells_awake() || model_->last_line()) return 0;
    if (!(in == applied_) || !(jtag == applied_jtag_)) return 0;
    AsynchronousClock audio = audio_clock_;
    if (!model_->pair_comes()) audio.next(), audio.next();
    return std::min({model_->ports_rest(), audio.clocks() - clocks_, LINE});
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

// Whatever changes beside the access may not be seen, so it counts as a change unless all is calm.
template <class Access>
AxiResponse Fabric::access(Bridge bridge, const Access& made) {
    begin();
    const bool calm_before = calm() >= LONGEST_ACCESS;
    const std::uint64_t from = clocks_;
    moved_ |= bridge == Bridge::LIGHTWEIGHT ? LIGHTWEIGHT : FULL;
    accessed_ = true;
    const AxiResponse response = made();
    accessed_ = false;
    changes_ += !calm_before || clocks_ - from > LONGEST_ACCESS || calm() == 0;
    return response;
}

AxiResponse Fabric::write(Bridge bridge, std::uint32_t address, const std::uint8_t* data,
                          unsigned bytes) {
    return access(bridge, [&] { return write_by(bridge, address, data, bytes); });
}

AxiResponse Fabric::read(Bridge bridge, std::uint32_t address, std::uint8_t* data, unsigned bytes) {
    return access(bridge, [&] { return read_by(bridge, address, data, bytes); });
}

AxiResponse Fabric::write_by(Bridge bridge, std::uint32_t address, const std::uint8_t* data,
                             unsigned bytes) {
    AxiPort& axi = model_->port(bridge);
    const std::uint32_t first = address / 4, last = (address + bytes - 1) / 4;
    axi.awaddr = address;
    axi.awlen = static_cast<CData>(last - first);
    axi.awsize = static_cast<CData>(size_of(address, bytes));
    axi.awburst = 1;  // INCR
    axi.awvalid = 1;
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
    return alive ? await_write(bridge, PROMPT_CLOCKS) : AxiResponse::NONE;
}

AxiResponse Fabric::await_write(Bridge bridge, std::uint64_t clocks) {
    AxiPort& axi = model_->port(bridge);
    begin();
    while (!axi.bvalid) {
        if (clocks == 0) return AxiResponse::PENDING;
        clocks -= clock(clocks);
    }
    const auto response = static_cast<AxiResponse>(axi.bresp);
    axi.bready = 1;
    clock(1);
    axi.bready = 0;
    return response;
}

AxiResponse Fabric::read_by(Bridge bridge, std::uint32_t address, std::uint8_t* data,
                            unsigned bytes) {
    AxiPort& axi = model_->port(bridge);
    const std::uint32_t first = address / 4, last = (address + bytes - 1) / 4,
                        end = address + bytes;
    axi.araddr = address;
    axi.arlen = static_cast<CData>(last - first);
    axi.arsize = static_cast<CData>(size_of(address, bytes));
    axi.arburst = 1;  // INCR
    axi.arvalid = 1;
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

}  // namespace sim
