// model.cpp - plays a design: its clocks, and who is notified when its pins move.
#include "sim/project/model.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/project/init_file.h"
#include "sim/project/runtime/bridge.h"
#include "sim/project/runtime/chip_pins.h"
#include "sim/project/runtime/clocks.h"
#include "sim/project/runtime/design.h"
#include "sim/project/runtime/endings.h"
#include "sim/project/runtime/in_folder.h"
#include "sim/project/runtime/jtag.h"
#include "sim/project/runtime/masters.h"
#include "sim/project/runtime/measured_clock.h"
#include "sim/project/runtime/peripherals.h"
#include "sim/project/runtime/plls.h"

namespace sim::project {

namespace {

constexpr std::uint64_t FS_PER_PS = 1'000;
// From DRAM_CLK in the FPGA to the data there: the SDRAM's tAC of 5.4 ns, and two pads.  So the
// clock may lead by 3 ns, as the University Program has it.
constexpr std::uint64_t DQ_DELAY_FS = 8'000'000;
constexpr unsigned VIDEO_BATCH = 800, MOST_TURNS = 100;

class DesignModel final : public FpgaModel {
public:
    DesignModel(std::unique_ptr<Design> design, const DesignFacts& facts, PinListener& pins,
                const ModelSettings& settings)
        : facts_{facts}, listener_{pins}, trace_{settings.trace}, design_{std::move(design)} {
        if (!settings.trace.file.empty()) tracing_ = design_->begin_trace(settings.trace.file);
        std::vector<std::filesystem::path> sources;
        for (unsigned n = 0; n < facts.source_folder_count; ++n)
            sources.push_back(std::filesystem::path{settings.folder} / facts.source_folders[n]);
        set_init_folders(
            {settings.folder, std::move(sources)},
            [report = settings.report](const std::string& line) { report(line.c_str()); });
        set_jtag_terminals(settings.terminals);
        set_processor_memory(settings.memory);
        evaluated = {&ending_, settings.report, 0};
        clocks_of_design = &clocks_;
        pll_locks_waiting = 0;
        top_.pll_clocks_i = clocks_.held();
        const InFolder in_folder{settings.folder};  // where the design's files are
        eval();
        clocks_high_ = top_.clocks_o;  // what is high has not risen
        settle();
    }
    ~DesignModel() override {
        end_trace();
        if (ending_.kind != Ending::Kind::DIVERGED) design_->final();
        evaluated = {};
        clocks_of_design = nullptr;
    }

    void run(std::uint64_t until_ps) override {
        const bool is_ahead = until_ps < now_ps();  // by an access
        if (!is_ahead && play(until_ps, {})) listener_.agenda.pass_to(until_ps);
    }

    unsigned bridge_width(bool full) const override {
        const unsigned size = top_.hps_size_o >> (full ? 2 : 0) & 3;
        return size ? 16u << size : 0;
    }

    std::string waits_for() const override {
        return is_bridge_free()
                   ? posted_writes.waits_for()
                   : bridge_waits_for(top_.hps_waits_o >> (bridge_burst.full ? 20 : 0));
    }

    void begin(const BridgeBurst& burst) override {
        if (!burst.posted) return give(burst);
        posted_writes.begin(burst);
        if (is_bridge_free()) give_posted();
    }

    bool takes_posted() const override { return true; }
    const BridgeBurst* posted() const override { return posted_writes.oldest(); }
    bool has_posted(unsigned id) const override { return posted_writes.has(id); }
    std::optional<BridgeBurst> refused() override { return posted_writes.refused(); }

    void reset(bool active, bool cold) override {
        top_.hps_reset_i = active ? cold ? 3 : 1 : 0;
        posted_writes.clear();
        move_processor();
    }

    void general_purpose(std::uint32_t signals) override {
        top_.hps_gp_i = signals;
        move_processor();
    }

    bool has(Peripheral which) const override { return peripherals_.has(which); }
    void connect(ProcessorWires& wires) override {
        peripherals_.connect(wires, now_ps());
        if (look_) settle();
    }
    void drive(Peripheral which, std::uint64_t levels, std::optional<std::uint64_t> ps) override {
        drives_ |= peripherals_.drive(which, levels);
        look_ |= drives_;
        if (ps) now_fs_ = std::max(now_fs_, *ps * FS_PER_PS);
        if (ps && drives_) settle();
    }

    bool run_to_answer(std::uint64_t until_ps) override {
        if (play(until_ps, 0)) listener_.agenda.pass_to(until_ps);
        return has_at_most(0);
    }

    bool run_to_posted(std::uint64_t until_ps, unsigned most) override {
        if (play(until_ps, most)) listener_.agenda.pass_to(until_ps);
        return has_at_most(most);
    }

    const BridgeBurst& answer() const override { return bridge_burst; }
    std::uint64_t interrupts() const override { return top_.hps_irq_o; }
    unsigned reset_requests() const override { return top_.hps_reset_requests_o; }
    std::uint32_t general_purpose() const override { return top_.hps_gp_o; }
    std::uint64_t time_ps() const override { return now_ps(); }

    void flush() override {
        std::fflush(stdout);  // what $display has printed comes before what de1sim prints
        const unsigned count = video_count_;
        video_count_ = 0;
        if (count) {
            notify_video_clock(count);
            listener_.video(video_, count);
        } else if (facts_.vga_used && now_fs_ - last_sample_fs_ > MeasuredClock::QUIET_FS) {
            listener_.video_idle(now_ps());
        }
    }

    Ending ending() const override { return ending_; }

    void end_trace() override {
        tracing_ = false;
        design_->end_trace();
    }

private:
    // In an evaluation of its own, so that it counts from the next clock edge on.
    void move_processor() {
        top_.hps_moved_i = !top_.hps_moved_i;
        eval();
        look();
        if (look_) settle();
    }

    std::uint64_t now_ps() const { return now_fs_ / FS_PER_PS; }
    // Returns whether it has come to `until_ps`, not to an answer before, after which at most so
    // many bursts are under way.
    bool play(std::uint64_t until_ps, std::optional<unsigned> most) {
        until_fs_ = until_ps * FS_PER_PS;
        look_ahead();
        while (!most || !has_at_most(*most)) {
            const std::uint64_t parts_fs = std::min(bclk_next_fs_, dq_next_fs_);
            if (std::min(clocks_.next_fs(), parts_fs) > stop_fs_ || ended()) {
                if (agenda_fs_ > until_fs_ || ended()) return true;
                keep_agenda();
            } else if (parts_fs >= clocks_.next_fs()) {
                edge();
            } else if (parts_fs == dq_next_fs_) {
                dq_arrives();
            } else {
                bclk_edge();
            }
        }
        return false;
    }

    bool is_bridge_free() const { return top_.hps_answer_o == top_.hps_request_i; }
    bool has_at_most(unsigned bursts) const {
        return posted_writes.count() <= bursts && (bursts || is_bridge_free());
    }

    void give(const BridgeBurst& burst) {
        bridge_burst = burst;
        top_.hps_request_i ^= burst.full ? 2 : 1;
        move_processor();
    }

    void give_posted() {
        if (const BridgeBurst* next = posted_writes.next()) give(*next);
    }

    // What happens at the same time at several clocks happens in one evaluation.
    void edge() {
        now_fs_ = clocks_.next_fs();
        const Clocks::Edges edges =
            clocks_.edges([this](unsigned number, bool rises) { return move(number, rises); });
        if (edges.seen || edges.rising_pins) {
            edges.seen ? eval() : note_levels(levels_, top_);
            look(edges.rising_pins);
        }
        if (xck_.stops(now_fs_)) notify_xck();
        if (look_) settle();
        if (posted_writes.count() && is_bridge_free()) give_posted();
    }

    // The board moves inputs, at a time of its own.
    void keep_agenda() {
        now_fs_ = agenda_fs_;
        listener_.agenda.run_to(now_ps());
        settle();
    }

    void look_ahead() {
        agenda_ps_ = listener_.agenda.next_ps();
        agenda_fs_ = agenda_ps_ < NEVER / FS_PER_PS ? agenda_ps_ * FS_PER_PS : NEVER;
        stop_fs_ = std::min(agenda_fs_, until_fs_);
    }

    // False: nothing would see it.
    bool move(unsigned number, bool rises) {
        if (number == Clocks::IS_CLOCK_50) {
            if (!facts_.clock_50_seen && pll_locks_waiting == 0 && trace_.file.empty())
                return false;
            top_.clock_50_i = !top_.clock_50_i;
        } else if (number == Clocks::IS_CLOCK_27) {
            top_.clock_27_i = !top_.clock_27_i;
            if (rises) top_.td_data_i = listener_.td_data(rises_27_++);
        } else {
            top_.pll_clocks_i ^= std::uint64_t{1} << number;
        }
        return true;
    }

    // The board answers what the chip does, and the chip may answer that without a clock.
    void settle() {
        for (unsigned turn = 0; turn == 0 || (look_ && !ended()); ++turn) {
            if (turn == MOST_TURNS)
                return end_run(Ending::Kind::DIVERGED,
                               "the chip and the board answer each other without an end");
            apply_inputs();
        }
        if (listener_.agenda.next_ps() != agenda_ps_) look_ahead();
    }

    // As move_processor().
    void apply_inputs() {
        look_ = false;
        top_.sw_i = static_cast<PortWord<SWITCHES>>(in.sw);
        top_.key_ni = in.key_n;
        pull_headers(top_, in.gpio, headers_.enable);
        apply_codec();
        top_.i2c_sdat_low_i = !in.sdat && !sdat_low_;
        top_.adc_dout_i = in.adc_sdo;
        top_.gsensor_low_i = static_cast<unsigned>(!in.gsensor_sdo << 1 | !in.gsensor_sdi);
        top_.irda_rxd_i = in.irda_rxd;
        top_.ps2_clk_low_i = ~in.ps2_clk & 3 & ~ps2_ & 3;
        top_.ps2_dat_low_i = ~in.ps2_dat & 3 & ~(ps2_ >> 2) & 3;
        top_.moved_i = !top_.moved_i;
        if (std::exchange(drives_, false)) top_.hps_moved_i = !top_.hps_moved_i;
        eval();
        look_after_inputs();
        look_at_pins();  // a wire that has not moved may be driven by the chip now
    }

    void apply_codec() {
        top_.aud_i = static_cast<unsigned>(in.codec.bclk << 2 | in.codec.daclrck << 1 |
                                           static_cast<int>(in.codec.adclrck));
        top_.aud_en_i = in.codec.driven;
        top_.aud_adcdat_i = in.adcdat;
        bclk_half_fs_ = in.codec.bclk_half_fs;
        if (bclk_half_fs_ == 0)
            bclk_next_fs_ = NEVER;
        else if (bclk_next_fs_ == NEVER)
            bclk_next_fs_ = now_fs_ + bclk_half_fs_;
    }

    bool ended() const { return ending_.kind != Ending::Kind::NONE; }

    void eval() {
        const std::uint64_t now = evaluated.time_ps = now_ps();
        try {
            moved_ = design_->eval(now, levels_);
        } catch (const Diverged& error) {
            moved_ = ~std::uint64_t{0};
            const std::string why = facts_.loops[0] ? facts_.loops : error.what();
            end_run(Ending::Kind::DIVERGED, "the design oscillates: " + why);
        }
        if (tracing_ && trace_.wants(now))
            design_->dump(dumped_ps_ = std::max(now, dumped_ps_ + 1));
    }

    // `pins`: those that clocks_ has let rise, where the design lets them through.
    void look(unsigned pins = 0) {
        look_at_clocks(pins);
        if (moved_) notify();
        peripherals_.tell(now_ps());
    }

    // The chip may drive other pins of headers at the same levels, too.
    void look_after_inputs() {
        look_at_clocks(0);
        if (moved_ | enable_moved(headers_, top_)) notify();
        peripherals_.tell(now_ps());
    }

    void look_at_clocks(unsigned pins) {
        const unsigned clocks = levels_.clocks;
        const unsigned rises = (clocks & ~clocks_high_ & ~clocks_.pins()) | (clocks & pins);
        clocks_high_ = clocks;
        if (rises) clocks_rise(rises);
    }

    void clocks_rise(unsigned which) {
        if (which & VGA_CLK && facts_.vga_used) sample_video();
        if (which & DRAM_CLK) look_at_sdram();
        if (which & AUD_XCK && facts_.aud_xck_used && xck_.rises(now_fs_)) notify_xck();
    }

    void notify() {
        moved_ = 0;
        if (levels_.pins != top_.pins_o) look_at_pins();
        const LampPins lamps{top_.ledr_o, top_.hex_no};
        if (lamps.ledr != lamps_.ledr || lamps.hex_n != lamps_.hex_n) {
            lamps_ = lamps;
            listener_.lamps(lamps_, now_ps());
        }
        levels_.ledr = lamps.ledr;
        levels_.hex_n = lamps.hex_n;
        look_at_headers();
    }

    void look_at_pins() {
        const unsigned moved = levels_.pins ^ top_.pins_o;
        levels_.pins = top_.pins_o;
        look_at_codec();
        if (moved >> ADC_LSB & ADC_MASK) {
            const unsigned adc = levels_.pins >> ADC_LSB;
            listener_.adc({(adc & 1) != 0, (adc & 2) != 0, (adc & 4) != 0}, now_ps(), in);
            look_ = true;
        }
        if (moved >> GSENSOR_LSB & GSENSOR_MASK) {
            const unsigned sensor = levels_.pins >> GSENSOR_LSB;
            listener_.gsensor(
                {(sensor & 1) != 0, (sensor & 2) != 0, (sensor & 4) != 0, (sensor & 8) != 0},
                now_ps(), in);
            look_ = true;
        }
        const unsigned ps2_low = ~(levels_.pins >> PS2_LSB) & 15u &
                                 ~(top_.ps2_clk_low_i | unsigned{top_.ps2_dat_low_i} << 2);
        if (ps2_low != ps2_) {
            ps2_ = ps2_low;
            listener_.ps2(ps2_ & 3, ps2_ >> 2, now_ps(), in);
            look_ = true;
        }
    }

    void sample_video() {
        if (video_count_ == 0) first_sample_fs_ = now_fs_;
        last_sample_fs_ = now_fs_;
        video_[video_count_++] = levels_.vga;
        if (video_count_ == VIDEO_BATCH) flush();
    }

    // From enough samples for 1 %.
    void notify_video_clock(unsigned count) {
        if (count < VIDEO_BATCH / 2) return;
        const std::uint64_t period_ps =
            (last_sample_fs_ - first_sample_fs_) / (count - 1) / FS_PER_PS;
        const std::uint64_t most = std::max(period_ps, period_ps_),
                            least = std::min(period_ps, period_ps_);
        if (most - least <= most / 100) return;
        period_ps_ = period_ps;
        listener_.video_clock(period_ps);
    }

    void look_at_headers() {
        if (!(levels_moved(headers_, top_) | enable_moved(headers_, top_))) return;
        headers_ = headers_of(top_);
        take_headers(levels_, top_);
        listener_.headers(headers_, now_ps(), in);
        look_ = true;
    }

    void look_at_codec() {
        const unsigned levels = levels_.pins >> CODEC_LSB & 0x1f, clocks = levels & 7;
        const bool sdat_low = !(levels_.pins >> CODEC_LSB & 0x20) && !top_.i2c_sdat_low_i;
        const unsigned codec = levels | unsigned{sdat_low} << 5;
        if (codec == codec_) return;
        const bool controls = ((codec ^ codec_) & 0x30) != 0, adcdat = in.adcdat;
        codec_ = codec;
        sdat_low_ = sdat_low;
        // Where both sides drive, a wire is high if one of them is.
        const bool driven = facts_.aud_clocks_driven || (top_.aud_en_i && clocks != top_.aud_i);
        listener_.codec({(codec & 4) != 0, (codec & 2) != 0, (codec & 1) != 0, (codec & 8) != 0,
                         (codec & 16) != 0, sdat_low, driven},
                        now_ps(), in);
        look_ |= controls || in.adcdat != adcdat;  // sound alone changes nothing else
    }

    void notify_xck() {
        listener_.xck(xck_.period_fs(), now_ps(), in);
        look_ = true;
    }

    // The codec's clocks come between those of the design, or just after them.
    void bclk_edge() {
        now_fs_ = bclk_next_fs_;
        bclk_next_fs_ += bclk_half_fs_;
        listener_.bclk_edge(now_ps(), in);
        settle();
    }

    // DQ is the memory's while it has a read to answer.
    void look_at_sdram() {
        const unsigned pins = levels_.dram;
        const bool selected = !(pins >> CS_LSB & 1), cke = pins >> CKE_LSB & 1;
        if (!selected && !sdram_busy_ && cke == cke_) return;
        cke_ = cke;
        const bool reads = (pins >> WE_LSB & 15) == 5, writes = (pins >> WE_LSB & 15) == 4;
        if (reads || writes) reading_ = reads;
        std::uint16_t dq = dq_;
        listener_.sdram(sdram_of(pins, levels_.dram_dq, !reading_ && (writes || sdram_busy_)),
                        now_ps(), dq, sdram_busy_);
        const bool drives = sdram_busy_ && reading_;
        if (!drives && !dq_drives_) return;
        if (dq_next_fs_ != NEVER) put_dq();  // of the clock before, less than the delay ago
        dq_ = dq;
        dq_drives_ = drives;
        dq_next_fs_ = now_fs_ + DQ_DELAY_FS;
    }

    void dq_arrives() {
        now_fs_ = dq_next_fs_;
        put_dq();
        settle();
    }

    void put_dq() {
        top_.dram_dq_i = dq_;
        top_.dram_dq_en_i = dq_drives_;
        dq_next_fs_ = NEVER;
        look_ = true;
    }

    const DesignFacts& facts_;
    PinListener& listener_;
    const Trace trace_;
    bool tracing_ = false;
    DesignPeripherals peripherals_{facts_.placed_uarts};
    const std::unique_ptr<Design> design_;
    const ChipPorts top_{design_->ports()};
    Ending ending_;
    Clocks clocks_{facts_, trace_.file.empty()};
    std::uint64_t dumped_ps_ = 0;  // what follows at the same time is a picosecond later
    std::uint64_t now_fs_ = 0;     // of the last edge or entry
    std::uint64_t agenda_ps_ = Agenda::NEVER, agenda_fs_ = NEVER;  // the next entry
    std::uint64_t until_fs_ = 0, stop_fs_ = 0;  // of this run; or the next entry, if that is before
    std::uint64_t rises_27_ = 0;
    bool look_ = true, drives_ = false;  // `in` may have changed; peripherals_ has other levels

    PinLevels levels_;
    std::uint64_t moved_ = 0;  // not 0: since the board was notified, levels have

    std::uint32_t video_[VIDEO_BATCH];
    unsigned video_count_ = 0;
    std::uint64_t first_sample_fs_ = 0, last_sample_fs_ = 0;  // of the batch
    std::uint64_t period_ps_ = 40'000;                        // that the board knows
    bool sdram_busy_ = false, reading_ = false, cke_ = true;
    std::uint16_t dq_ = 0;  // what the SDRAM drives, from dq_next_fs_ on
    bool dq_drives_ = false;
    std::uint64_t dq_next_fs_ = NEVER;
    LampPins lamps_;
    HeaderPins headers_{};
    unsigned clocks_high_ = 0;
    unsigned codec_ = 0, ps2_ = 0;  // ps2_: bit n port n's clock, bit 2 + n its data
    bool sdat_low_ = false;
    MeasuredClock xck_;
    std::uint64_t bclk_half_fs_ = 0, bclk_next_fs_ = NEVER;
};

}  // namespace

FpgaModel* play(std::unique_ptr<Design> design, const DesignFacts& facts, PinListener& pins,
                const ModelSettings& settings) {
    return new DesignModel{std::move(design), facts, pins, settings};
}

}  // namespace sim::project
