// fabric.h - the Verilated fpga.v, which is this project's own content of the FPGA.
//
// It is run clock by clock (25 MHz, 40 ns), the audio clock and the video decoder's in their own
// time between them.  What the board puts on the inputs counts from the next clock on (adcdat from
// the audio clock's next rise).  All entries of the board's agenda before a clock's edge come
// before it.  Clocks in which nothing would happen are left out of the model (rtl/SLEEP.md), but
// not of what is notified: it is the same as with every one of them.
//
// Memory::MAPPED: the memories behind the full bridge, the SDRAM chip and the on-chip memory, are
// offered without the bridge's Verilog, since a program that draws pixel by pixel would spend all
// its time there.  There is one storage, so the screen sees the same, up to a scan line sooner.
// What video-in writes lies in the same storage.  Instructions that were translated before it wrote
// over them are not translated again, as the real processor's caches would not hear of it either.
//
// Memory::BRIDGED: every access goes through the Verilog; the SDRAM is offered for instructions
// alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "sim/fpga/asynchronous_clock.h"
#include "sim/pins/fpga_model.h"
#include "sim/pins/trace.h"

namespace sim {

// The host's side of the JTAG UARTs, bit or byte n of number n.
struct JtagInputs {
    std::uint8_t take = 0;    // the host takes bytes
    std::uint8_t typed = 0;   // a byte from the host, for one clock
    std::uint8_t idle = 0;    // the host has nothing to send, for one clock
    std::uint16_t bytes = 0;  // typed

    bool operator==(const JtagInputs& o) const {
        return take == o.take && typed == o.typed && idle == o.idle && bytes == o.bytes;
    }
};

class Fabric : public FpgaModel {
public:
    enum class Memory { MAPPED, BRIDGED };

    // Comes up in reset and leaves it after 8 clocks.  `trace`: waveforms, only in a build with
    // tracing.  `audio_rate`: samples per second, 8,000 or 48,000.
    explicit Fabric(PinListener& pins, const Trace& trace = {}, unsigned audio_rate = 8'000);
    ~Fabric() override;

    // `sdram`: the chip's 64 MB; null: it is reached by its pins alone.
    void set_memory(Memory memory, std::uint8_t* sdram);

    JtagInputs jtag;

    // Called when JTAG UART `number` has sent a byte; may change `in`, which is `jtag`.
    using JtagSent = std::function<void(unsigned number, char byte, JtagInputs& in)>;
    void on_jtag_byte(JtagSent sent) { jtag_sent_ = std::move(sent); }

    void run(std::uint64_t until_ps) override;
    void run_clocks(std::uint64_t clocks);
    void flush() override;
    void end_trace() override;

    std::uint64_t clocks() const { return clocks_; }
    std::uint64_t time_ps() const override { return clocks_ * FABRIC_PERIOD_PS; }

    // 32 bits each.
    unsigned bridge_width(bool) const override { return 32; }
    void begin(const BridgeBurst& burst) override;
    bool run_to_answer(std::uint64_t until_ps) override;
    const BridgeBurst& answer() const override { return burst_; }
    std::uint64_t interrupts() const override;

    std::optional<std::uint64_t> access_memory(bool full, bool write, std::uint32_t address,
                                               std::uint8_t* data, unsigned bytes,
                                               std::uint64_t begin_ps) override;
    std::optional<DirectMemory> direct_memory(bool full, std::uint32_t address) const override;
    std::uint64_t changes() const override { return changes_; }
    std::uint64_t calm_ps() const override { return calm() * FABRIC_PERIOD_PS; }

    // The on-chip memory's 256 KB, without its ports and in no time.  has_memory(): this build can;
    // one that knows the model's ports alone (DE1SIM_PORTS_ALONE: the netlist) cannot, and then the
    // other two do nothing.
    bool has_memory() const;
    void read_onchip(std::uint32_t offset, std::uint8_t* data, unsigned bytes) const;
    void write_onchip(std::uint32_t offset, const std::uint8_t* data, unsigned bytes);

    // Samples in the audio core's FIFOs of 128, left and right, and its count of underruns; read in
    // no time.  Not in a build with the netlist.
    struct Audio {
        std::uint8_t to_play[2], recorded[2];
        std::uint32_t underruns;
    };
    std::optional<Audio> audio() const;

    std::uint16_t ledr() const;
    std::uint64_t hex_n() const;     // HEX5 in 41:35 ... HEX0 in 6:0, 0 = lit
    std::uint8_t jtag_room() const;  // bit n: JTAG UART n takes a byte from the host

    static bool can_trace();

private:
    struct Model;
    struct AxiPort;
    static constexpr unsigned VIDEO_BATCH = 1024;

    std::uint64_t clock(std::uint64_t most);  // how many have passed, 1 or more
    void run_to(std::uint64_t clock, bool to_answer);
    void keep_agenda(std::uint64_t time_ps);
    void look();
    void look_ahead();
    std::uint64_t calm() const;
    void other_edges(std::uint64_t halves);
    void audio_edge();
    void td_edge();
    void wake_td();
    void begin_trace();
    void apply_inputs();
    void notify_pins();
    void notify_codec(std::uint64_t time_ps);
    void notify_sdram();
    void burst_clock(std::uint64_t most);
    void write_clock(AxiPort& axi, std::uint64_t most);
    void read_clock(AxiPort& axi);
    void put_word(AxiPort& axi);
    void end_burst();

    PinListener& pins_;
    std::unique_ptr<Model> model_;
    AsynchronousClock audio_clock_, td_clock_;
    ChipInputs applied_;
    JtagInputs applied_jtag_;
    JtagSent jtag_sent_ = [](unsigned, char, JtagInputs&) {};
    bool look_ = true;        // `in` may differ from applied_
    std::uint8_t moved_ = 0;  // inputs since the last clock
    bool sdram_ = false;      // it wants to see the next clock
    bool td_on_ = false;      // somebody wants the decoder's clock
    bool td_falls_ = false;   // ... which has fallen since the model was looked at
    std::uint64_t clocks_ = 0;
    std::uint64_t until_ = 0;  // clocks: somebody comes before the next one
    std::uint64_t agenda_ps_ = Agenda::NEVER;
    std::uint64_t changes_ = 0;  // of clocks in which a register may have by more than a burst
    BridgeBurst burst_{};        // the last one
    enum class Phase : std::uint8_t {
        NONE,
        ADDRESS,
        DATA,
        RESPONSE
    } phase_ = Phase::NONE;  // of it
    unsigned beat_ = 0;
    std::uint64_t begun_ = 0;   // the clock
    bool calm_before_ = false;  // the burst
    Memory memory_ = Memory::BRIDGED;
    std::uint8_t* chip_ = nullptr;  // the SDRAM's storage
    std::uint32_t video_[VIDEO_BATCH];
    unsigned video_count_ = 0;
    std::uint32_t codec_was_ = 0, adc_was_ = 0;
    struct HeaderBits {
        std::uint32_t jp1, jp1_oe, jp2, jp2_oe;
    } headers_was_{0, 0, 0, 0};
    LampPins lamps_was_;
    unsigned ps2_was_ = 0;
};

}  // namespace sim
