// model.cpp - plays a design: its clocks, and who is told when its pins move.
#include "sim/project/model.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/project/init_file.h"
#include "sim/project/runtime/chip.h"
#include "sim/project/runtime/clocks.h"
#include "sim/project/runtime/endings.h"

namespace sim::project {

namespace {

constexpr std::uint64_t FS_PER_PS = 1'000;
constexpr std::uint64_t QUIET_FS = 1'000'000'000'000;  // 1 ms
constexpr unsigned VIDEO_BATCH = 800, MOST_TURNS = 100;
constexpr unsigned XCK_RISES = 128;  // from one movement of aud_xck_o to the next

// The working directory, for as long as it lives, also where the design's files are broken.
class InFolder {
public:
    explicit InFolder(const char* folder) : here_{std::filesystem::current_path()} {
        std::filesystem::current_path(folder);
    }
    ~InFolder() {
        std::error_code error;
        std::filesystem::current_path(here_, error);
    }

private:
    const std::filesystem::path here_;
};

class ChipModel final : public Model {
public:
    ChipModel(std::unique_ptr<Chip> chip, const DesignFacts& facts, PinListener& pins,
              const ModelSettings& settings)
        : facts_{facts}, pins_{pins}, trace_{settings.trace}, chip_{std::move(chip)} {
        if (!settings.trace.file.empty()) chip_->begin_trace(settings.trace.file);
        std::vector<std::filesystem::path> sources;
        for (unsigned n = 0; n < facts.source_folder_count; ++n)
            sources.push_back(std::filesystem::path{settings.folder} / facts.source_folders[n]);
        set_init_folders({settings.folder, std::move(sources)},
                         [say = settings.say](const std::string& line) { say(line.c_str()); });
        evaluated = {&ending_, settings.say, 0};
        const InFolder in_folder{settings.folder};  // where the design's files are
        eval();
        settle();
    }
    ~ChipModel() override {
        end_trace();
        if (ending_.kind != Ending::Kind::DIVERGED) chip_->final();
        evaluated = {};
    }

    void run(std::uint64_t until_ps) override {
        until_fs_ = until_ps * FS_PER_PS;
        look_ahead();
        for (;;) {
            const std::uint64_t rise = clocks_.next_rise_fs(), fall = clocks_.next_fall_fs();
            if (std::min({rise, fall, bclk_next_fs_}) > stop_fs_ || ended()) {
                if (agenda_fs_ > until_fs_ || ended()) break;
                keep_agenda();
            } else if (fall < rise && fall <= bclk_next_fs_) {
                edges(fall);
            } else {
                if (facts_.edges_apart) answer();
                if (bclk_next_fs_ < rise)
                    bclk_edge();
                else
                    edges(now_fs_ = rise);
            }
            if (!clocks_.high()) answer();
        }
        if (facts_.edges_apart) look();
        pins_.agenda.pass_to(until_ps);
    }

    void flush() override {
        std::fflush(stdout);  // what $display has printed comes before what de1sim prints
        const unsigned count = video_count_;
        video_count_ = 0;
        if (count) {
            tell_video_clock(count);
            pins_.video(video_, count);
        } else if (facts_.vga_used && now_fs_ - last_sample_fs_ > QUIET_FS) {
            pins_.video_idle(now_ps());
        }
    }

    const Ending& ending() const override { return ending_; }

    void end_trace() override { chip_->end_trace(); }

private:
    std::uint64_t now_ps() const { return now_fs_ / FS_PER_PS; }

    void edges(std::uint64_t now_fs) {
        edge_fs_ = now_fs;
        clocks_.edges(now_fs, [this](unsigned number, bool rises) { move(number, rises); });
        eval();
    }

    // The board moves inputs, at a time of its own.  In waveforms, where a clock is high, that
    // counts once it is low, or before another one rises: as in an ordinary run.
    void keep_agenda() {
        const bool high = clocks_.high();
        if (high) {
            look();
            if (entered_) settle();
        }
        now_fs_ = agenda_fs_;
        if (!high) edge_fs_ = now_fs_;
        pins_.agenda.run_to(now_ps());
        look_ = entered_ = true;
        look_ahead();
        if (!high) settle();
    }

    void look_ahead() {
        agenda_ps_ = pins_.agenda.next_ps();
        agenda_fs_ = agenda_ps_ < NEVER / FS_PER_PS ? agenda_ps_ * FS_PER_PS : NEVER;
        stop_fs_ = std::min(agenda_fs_, until_fs_);
    }

    void move(unsigned number, bool rises) {
        if (number == Clocks::IS_CLOCK_50) {
            top_.clock_50_i = !top_.clock_50_i;
        } else if (number == Clocks::IS_CLOCK_27) {
            top_.clock_27_i = !top_.clock_27_i;
            if (rises) top_.td_data_i = pins_.td_data(rises_27_++);
        } else {
            top_.pll_clocks_i ^= std::uint64_t{1} << number;
        }
    }

    // The board gets to know what happened at an edge once the clock is low again, or before
    // another one rises: in waveforms no earlier than in an ordinary run, and told the same time.
    void answer() {
        look();
        if (look_) settle();
    }

    // The board answers what the chip does, and the chip may answer that without a clock.
    void settle() {
        for (unsigned turn = 0; turn == 0 || (look_ && !ended()); ++turn) {
            if (turn == MOST_TURNS)
                return end_run(Ending::Kind::DIVERGED,
                               "the chip and the board answer each other without an end");
            apply_inputs();
        }
    }

    // In an evaluation of its own, so that it counts from the next clock edge on.
    void apply_inputs() {
        look_ = entered_ = false;
        top_.sw_i = in.sw;
        top_.key_ni = in.key_n;
        top_.gpio_0_low_i = ~in.gpio[0] & ~headers_.enable[0] & ALL_HEADER_PINS;
        top_.gpio_1_low_i = ~in.gpio[1] & ~headers_.enable[1] & ALL_HEADER_PINS;
        apply_codec();
        top_.i2c_sdat_low_i = !in.sdat && !sdat_low_;
        top_.adc_dout_i = in.adc_sdo;
        top_.irda_rxd_i = in.irda_rxd;
        top_.ps2_clk_low_i = ~in.ps2_clk & 3 & ~ps2_ & 3;
        top_.ps2_dat_low_i = ~in.ps2_dat & 3 & ~(ps2_ >> 2) & 3;
        top_.moved_i = !top_.moved_i;
        eval();
        look();
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
            chip_->eval(now);
        } catch (const Diverged& error) {
            const std::string why = facts_.loops[0] ? facts_.loops : error.what();
            end_run(Ending::Kind::DIVERGED, "the design oscillates: " + why);
        }
        if (!facts_.edges_apart || !chip_->is_tracing()) return;
        const std::uint64_t edge_ps = edge_fs_ / FS_PER_PS;
        if (trace_.wants(edge_ps)) chip_->dump(dumped_ps_ = std::max(edge_ps, dumped_ps_ + 1));
    }

    void look() {
        if (facts_.vga_used && top_.vga_sample_o != vga_sample_) {
            vga_sample_ = top_.vga_sample_o;
            if (video_count_ == 0) first_sample_fs_ = now_fs_;
            last_sample_fs_ = now_fs_;
            video_[video_count_++] = top_.vga_o;
            if (video_count_ == VIDEO_BATCH) flush();
        }
        if (top_.dram_sample_o != dram_sample_) look_at_sdram();
        const LampPins lamps{top_.ledr_o, top_.hex_no};
        if (lamps.ledr != lamps_.ledr || lamps.hex_n != lamps_.hex_n) {
            lamps_ = lamps;
            pins_.lamps(lamps_, now_ps());
        }
        look_at_headers();
        look_at_codec();
        if (top_.adc_o != adc_) {
            adc_ = top_.adc_o;
            pins_.adc({(adc_ & 1) != 0, (adc_ & 2) != 0, (adc_ & 4) != 0}, now_ps(), in);
            look_ = true;
        }
        const unsigned ps2 = (~top_.ps2_clk_o & 3u & ~unsigned{top_.ps2_clk_low_i}) |
                             (~top_.ps2_dat_o & 3u & ~unsigned{top_.ps2_dat_low_i}) << 2;
        if (ps2 != ps2_) {
            ps2_ = ps2;
            pins_.ps2(ps2 & 3, ps2 >> 2, now_ps(), in);
            look_ = true;
        }
        if (look_ && pins_.agenda.next_ps() != agenda_ps_) look_ahead();
    }

    // From enough samples for 1 %.
    void tell_video_clock(unsigned count) {
        if (count < VIDEO_BATCH / 2) return;
        const std::uint64_t period_ps =
            (last_sample_fs_ - first_sample_fs_) / (count - 1) / FS_PER_PS;
        const std::uint64_t most = std::max(period_ps, period_ps_),
                            least = std::min(period_ps, period_ps_);
        if (most - least <= most / 100) return;
        period_ps_ = period_ps;
        pins_.video_clock(period_ps);
    }

    void look_at_headers() {
        const HeaderPins& was = headers_;
        if (top_.gpio_0_o == was.levels[0] && top_.gpio_1_o == was.levels[1] &&
            top_.gpio_0_oe_o == was.enable[0] && top_.gpio_1_oe_o == was.enable[1])
            return;
        headers_ = {{top_.gpio_0_o, top_.gpio_1_o}, {top_.gpio_0_oe_o, top_.gpio_1_oe_o}};
        pins_.headers(headers_, now_ps(), in);
        look_ = true;
    }

    void look_at_codec() {
        if (facts_.aud_xck_used) look_at_xck();
        const bool sdat_low = !top_.i2c_sdat_o && !top_.i2c_sdat_low_i;
        const unsigned codec =
            top_.aud_o | top_.aud_dacdat_o << 3 | top_.i2c_sclk_o << 4 | unsigned{sdat_low} << 5;
        if (codec == codec_) return;
        const bool controls = ((codec ^ codec_) & 0x30) != 0, adcdat = in.adcdat;
        codec_ = codec;
        sdat_low_ = sdat_low;
        // Where both sides drive, a wire is high if one of them is.
        const bool driven = facts_.aud_clocks_driven || (top_.aud_en_i && top_.aud_o != top_.aud_i);
        pins_.codec({(codec & 4) != 0, (codec & 2) != 0, (codec & 1) != 0, (codec & 8) != 0,
                     (codec & 16) != 0, sdat_low, driven},
                    now_ps(), in);
        look_ |= controls || in.adcdat != adcdat;  // sound alone changes nothing else
    }

    void look_at_xck() {
        if (top_.aud_xck_o != xck_) {
            xck_ = top_.aud_xck_o;
            const std::uint64_t before_fs = std::exchange(xck_moved_fs_, now_fs_);
            if (before_fs) tell_xck((now_fs_ - before_fs) / XCK_RISES);
        } else if (xck_fs_ && now_fs_ - xck_moved_fs_ > QUIET_FS) {
            tell_xck(0);
        }
    }

    void tell_xck(std::uint64_t period_fs) {
        if (period_fs == 0) xck_moved_fs_ = 0;
        if (period_fs == xck_fs_) return;
        xck_fs_ = period_fs;
        pins_.xck(period_fs, now_ps(), in);
        look_ = true;
    }

    // The codec's clocks come between those of the design, or just after them.
    void bclk_edge() {
        edge_fs_ = now_fs_ = bclk_next_fs_;
        bclk_next_fs_ += bclk_half_fs_;
        pins_.bclk_edge(now_ps(), in);
        settle();
    }

    // DQ is the memory's while it has a read to answer.
    void look_at_sdram() {
        dram_sample_ = top_.dram_sample_o;
        const unsigned pins = top_.dram_o;
        const bool selected = !(pins >> 20 & 1);
        if (!selected && !sdram_busy_) return;
        const bool reads = (pins >> 17 & 15) == 5, writes = (pins >> 17 & 15) == 4;
        if (reads || writes) reading_ = reads;
        pins_.sdram({!selected, (pins >> 19 & 1) != 0, (pins >> 18 & 1) != 0, (pins >> 17 & 1) != 0,
                     static_cast<std::uint8_t>(pins >> 15 & 3), static_cast<std::uint8_t>(pins & 3),
                     static_cast<std::uint16_t>(pins >> 2 & 0x1fff), top_.dram_dq_o, writes},
                    now_ps(), top_.dram_dq_i, sdram_busy_);
        top_.dram_dq_en_i = sdram_busy_ && reading_;
        look_ = true;
    }

    const DesignFacts& facts_;
    PinListener& pins_;
    const Trace trace_;
    const std::unique_ptr<Chip> chip_;
    const ChipPorts top_{chip_->ports()};
    Ending ending_;
    Clocks clocks_{facts_};
    std::uint64_t dumped_ps_ = 0;  // what follows at the same time is a picosecond later
    std::uint64_t now_fs_ = 0;     // of the last rise or entry, for the board
    std::uint64_t edge_fs_ = 0;    // of the last edge
    std::uint64_t agenda_ps_ = Agenda::NEVER, agenda_fs_ = NEVER;  // the next entry
    std::uint64_t until_fs_ = 0, stop_fs_ = 0;  // of this run; or the next entry, if that is before
    std::uint64_t rises_27_ = 0;
    bool look_ = true;      // `in` may have changed
    bool entered_ = false;  // ... by an entry

    std::uint32_t video_[VIDEO_BATCH];
    unsigned video_count_ = 0;
    std::uint64_t first_sample_fs_ = 0, last_sample_fs_ = 0;  // of the batch
    std::uint64_t period_ps_ = 40'000;                        // that the board knows
    bool vga_sample_ = false, dram_sample_ = false, sdram_busy_ = false, reading_ = false;
    LampPins lamps_{0, (std::uint64_t{1} << 42) - 1};
    HeaderPins headers_{};
    unsigned codec_ = 0, adc_ = 0, ps2_ = 0;  // ps2_: bit n port n's clock, bit 2 + n its data
    bool sdat_low_ = false, xck_ = false;
    std::uint64_t xck_fs_ = 0, xck_moved_fs_ = 0;  // the period that the board knows
    std::uint64_t bclk_half_fs_ = 0, bclk_next_fs_ = NEVER;
};

}  // namespace

Model* play(std::unique_ptr<Chip> chip, const DesignFacts& facts, PinListener& pins,
            const ModelSettings& settings) {
    return new ChipModel{std::move(chip), facts, pins, settings};
}

}  // namespace sim::project
