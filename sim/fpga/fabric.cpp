#include "sim/fpga/fabric.h"

#include <algorithm>
#include <cstring>
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
    if (clocks_ >= until_) keep_agenda(time_ps() + FABRIC_PERIOD_PS - 1);
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
    changes_ += pins_may_move && phase_ == Phase::NONE;
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
void Fabric::look() {
    look_ = true;
    look_ahead();
}

void Fabric::look_ahead() {
    agenda_ps_ = pins_.agenda.next_ps();
    until_ = agenda_ps_ / FABRIC_PERIOD_PS;
}

void Fabric::keep_agenda(std::uint64_t time_ps) {
    if (pins_.agenda.next_ps() <= time_ps) {
        pins_.agenda.run_to(time_ps);
        look();
    }
    pins_.agenda.pass_to(time_ps);
}

void Fabric::run_to(std::uint64_t clock_number, bool to_answer) {
    look();
    while (clocks_ < clock_number && !(to_answer && phase_ == Phase::NONE)) {
        const std::uint64_t most = clock_number - clocks_;
        phase_ == Phase::NONE ? static_cast<void>(clock(most)) : burst_clock(most);
    }
}

void Fabric::run_clocks(std::uint64_t clocks) { run_to(clocks_ + clocks, false); }

void Fabric::run(std::uint64_t until_ps) {
    run_to(until_ps / FABRIC_PERIOD_PS, false);
    keep_agenda(until_ps);
}

bool Fabric::run_to_answer(std::uint64_t until_ps) {
    run_to(until_ps / FABRIC_PERIOD_PS, true);
    if (phase_ == Phase::NONE) return true;
    keep_agenda(until_ps);
    return false;
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

// ---- A burst: each step is a clock, whose edge sees the signals that are there before ----

// Whatever changes beside the burst may not be seen, so it counts as a change unless all is calm.
void Fabric::begin(const BridgeBurst& burst) {
    look();
    burst_ = burst;
    burst_.error = BridgeBurst::OKAY;
    calm_before_ = calm() >= LONGEST_ACCESS;
    begun_ = clocks_;
    moved_ |= burst.full ? FULL : LIGHTWEIGHT;
    phase_ = Phase::ADDRESS;
    beat_ = 0;
    AxiPort& axi = model_->port(burst.full);
    if (burst.write) {
        axi.awaddr = burst.address;
        axi.awlen = static_cast<CData>(burst.beats - 1);
        axi.awsize = static_cast<CData>(burst.size);
        axi.awburst = static_cast<CData>(burst.kind);
        axi.awvalid = 1;
    } else {
        axi.araddr = burst.address;
        axi.arlen = static_cast<CData>(burst.beats - 1);
        axi.arsize = static_cast<CData>(burst.size);
        axi.arburst = static_cast<CData>(burst.kind);
        axi.arvalid = 1;
    }
}

void Fabric::end_burst() {
    phase_ = Phase::NONE;
    changes_ += !calm_before_ || clocks_ - begun_ > LONGEST_ACCESS || calm() == 0;
}

// Or `most` clocks, if nothing moves but the burst's answer.
void Fabric::burst_clock(std::uint64_t most) {
    AxiPort& axi = model_->port(burst_.full);
    burst_.write ? write_clock(axi, most) : read_clock(axi);
}

void Fabric::put_word(AxiPort& axi) {
    const BridgeBurst::Beat& beat = burst_.beat[beat_];
    std::memcpy(&axi.wdata, beat.lanes.data(), sizeof axi.wdata);
    axi.wstrb = static_cast<CData>(beat.strobes);
    axi.wvalid = 1;
}

void Fabric::write_clock(AxiPort& axi, std::uint64_t most) {
    if (phase_ == Phase::ADDRESS) {
        const bool taken = axi.awready;
        clock(1);
        if (!taken) return;
        axi.awvalid = 0;
        phase_ = Phase::DATA;
        put_word(axi);
    } else if (phase_ == Phase::DATA) {
        const bool taken = axi.wready;
        clock(1);
        if (!taken) return;
        if (++beat_ < burst_.beats) return put_word(axi);
        axi.wvalid = 0;
        phase_ = Phase::RESPONSE;
    } else if (!axi.bvalid) {
        clock(most);
    } else {
        burst_.error = axi.bresp;
        axi.bready = 1;
        clock(1);
        axi.bready = 0;
        end_burst();
    }
}

void Fabric::read_clock(AxiPort& axi) {
    if (phase_ == Phase::ADDRESS) {
        const bool taken = axi.arready;
        clock(1);
        if (!taken) return;
        axi.arvalid = 0;
        phase_ = Phase::DATA;
    } else if (!axi.rvalid) {
        clock(1);
    } else {
        if (axi.rresp != BridgeBurst::OKAY) burst_.error = axi.rresp;
        std::memcpy(burst_.beat[beat_].lanes.data(), &axi.rdata, sizeof axi.rdata);
        clock(1);
        if (++beat_ == burst_.beats) end_burst();
    }
}

}  // namespace sim
