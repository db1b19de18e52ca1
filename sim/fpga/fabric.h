// fabric.h - the Verilated fpga.v as plain C++: its clock, its pins, its two AXI bridges.
//
// No SystemC here.  A Fabric is run clock by clock (25 MHz, 40 ns), the audio clock and the video
// decoder's in their own time between them; what leaves by the pins goes to a PinListener, what the
// board puts on the inputs lies in `in` and counts from the next clock on (adcdat from the audio
// clock's next rise).  In each run, and in an access over a bridge, the board's agenda is kept: all
// entries before a clock's edge come before it.
// Clocks in which nothing would happen are left out of the model (rtl/SLEEP.md), but not of
// what is notified: it is the same as with every one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/fpga/asynchronous_clock.h"
#include "sim/pins/pins.h"
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

enum class Bridge { LIGHTWEIGHT, FULL };
enum class AxiResponse : std::uint8_t {
    OKAY = 0,
    EXOKAY = 1,
    SLVERR = 2,
    DECERR = 3,
    NONE = 4,
    PENDING = 5  // of a write: the block is not done with it
};

class Fabric {
public:
    // Comes up in reset and leaves it after 8 clocks.  `trace`: waveforms, only in a build with
    // tracing.  `audio_rate`: samples per second, 8,000 or 48,000.
    explicit Fabric(PinListener& pins, const Trace& trace = {}, unsigned audio_rate = 8'000);
    ~Fabric();

    void end_trace();  // writes out the rest of the waveforms; what follows is not in them

    ChipInputs in;
    JtagInputs jtag;

    // Called when JTAG UART `number` has sent a byte; may change `in`, which is `jtag`.
    using JtagSent = std::function<void(unsigned number, char byte, JtagInputs& in)>;
    void on_jtag_byte(JtagSent sent) { jtag_sent_ = std::move(sent); }

    void run(std::uint64_t clocks);
    // Carries out the board's entries up to and with a time that is before the next clock's edge.
    void keep_agenda(std::uint64_t time_ps);

    // `met` is called before the first clock edge after `at_ps`; it returns the time after which
    // to call it next.  It may wait while others look at the pins.
    using Met = std::function<std::uint64_t()>;
    void meet(std::uint64_t at_ps, const Met* met) {
        meet_ps_ = at_ps;
        met_ = met;
    }

    std::uint64_t clocks() const { return clocks_; }
    std::uint64_t time_ps() const { return clocks_ * FABRIC_PERIOD_PS; }

    // In so many clocks from now on no register changes, if nobody accesses one and no input moves.
    // May be too low: 0 where this build cannot know.
    std::uint64_t calm() const;
    // Counts the clocks in which one may have changed by more than the accesses of a bridge.
    std::uint64_t changes() const { return changes_; }

    // Sends the video samples that have gathered to the listener.
    void flush();

    // In clocks, of one register that nothing holds up.
    static constexpr std::uint64_t LONGEST_ACCESS = 12;
    // One AXI burst of `bytes` from `address` (offset in the bridge); at most 16 words are touched.
    // Runs the clock until the response is taken; NONE if there is none in 10,000 clocks.  A write
    // whose data were taken but which is not answered at once is PENDING; its response is then
    // waited for in so many clocks more.  There is no other write before it has come.
    AxiResponse read(Bridge bridge, std::uint32_t address, std::uint8_t* data, unsigned bytes);
    AxiResponse write(Bridge bridge, std::uint32_t address, const std::uint8_t* data,
                      unsigned bytes);
    AxiResponse await_write(Bridge bridge, std::uint64_t clocks);

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
    std::uint64_t irq() const;       // bit n is interrupt ID 72 + n
    std::uint8_t jtag_room() const;  // bit n: JTAG UART n takes a byte from the host

    static bool can_trace();

private:
    struct Model;
    struct AxiPort;
    static constexpr unsigned VIDEO_BATCH = 1024, ANSWER_CLOCKS = 10'000;
    static constexpr unsigned PROMPT_CLOCKS = 16;  // in which a write is answered, usually

    std::uint64_t clock(std::uint64_t most);  // how many have passed, 1 or more
    void begin();
    void look_ahead();
    void stop();
    void other_edges(std::uint64_t halves);
    void audio_edge();
    void td_edge();
    void wake_td();
    void begin_trace();
    void apply_inputs();
    void notify_pins();
    void notify_codec(std::uint64_t time_ps);
    void notify_sdram();
    bool clock_until(const std::uint8_t& ready);
    AxiResponse read_by(Bridge bridge, std::uint32_t address, std::uint8_t* data, unsigned bytes);
    AxiResponse write_by(Bridge bridge, std::uint32_t address, const std::uint8_t* data,
                         unsigned bytes);
    template <class Access>
    AxiResponse access(Bridge bridge, const Access& made);

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
    std::uint64_t agenda_ps_ = Agenda::NEVER, meet_ps_ = Agenda::NEVER;
    const Met* met_ = nullptr;
    std::uint64_t changes_ = 0;
    bool accessed_ = false;  // a bridge's access is under way
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
