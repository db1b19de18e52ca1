// board.h - the schematic: the DE1-SoC with a monitor, a keypad and somebody at the line-out.
//
//   Processor -- Bus -+- DDR3
//                     +- Peripherals (GIC, timers, UART0, GPIO1, managers, on-chip RAM)
//                     +- Fpga lw, h2f --pins--+- Monitor   (VGA)
//                                             +- Wm8731    (audio)  <-- SoundSource
//                                             +- Adv7180   (video in)
//                                             +- Ltc2308   (AD converter)
//                                             +- Is42s16320d  (SDRAM)
//                                             +- Keypad    (JP1 D7-D0)
//                                             +- JtagHost  (JTAG UARTs)
//                                             +- Ps2Keyboard, Ps2Mouse  (PS/2 ports)
//                                             +- RemoteControl  (infrared receiver)
//                                             +- Header    (JP1, JP2)
//                                             +- KEY, SW, LEDR, HEX
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "sim/board/adv7180.h"
#include "sim/board/header.h"
#include "sim/board/is42s16320d.h"
#include "sim/board/jtag_host.h"
#include "sim/board/keypad.h"
#include "sim/board/lost_accesses.h"
#include "sim/board/ltc2308.h"
#include "sim/board/monitor.h"
#include "sim/board/ps2_keyboard.h"
#include "sim/board/ps2_mouse.h"
#include "sim/board/ps2_ports.h"
#include "sim/board/remote_control.h"
#include "sim/board/sound_source.h"
#include "sim/board/wm8731.h"
#include "sim/cpu/arm_cpu.h"
#include "sim/cpu/native_cpu.h"
#include "sim/fpga/fpga.h"
#include "sim/hps/bus.h"
#include "sim/hps/memory.h"
#include "sim/hps/peripherals.h"

namespace sim {

// What can be seen without a monitor.
struct Lamps {
    struct Header {
        std::uint32_t levels, outputs;  // of JP1 or JP2 as bits 31:0 of its registers have them
        bool operator==(const Header& o) const {
            return levels == o.levels && outputs == o.outputs;
        }
    };
    std::uint16_t ledr = 0;
    std::uint64_t hex = 0;  // segments that are lit, HEX5's in 41:35 ... HEX0's in 6:0
    bool hps_led = false;
    Header jp1{0xFFFFFFFF, 0}, jp2{0xFFFFFFFF, 0};
};

// Where what the board shows, plays and prints goes.
class Audience {
public:
    virtual void frame(const Monitor::Frame& frame) = 0;
    virtual void sample(std::int16_t left, std::int16_t right) = 0;
    virtual void sample_rate(double hz) = 0;
    virtual void console(char character) = 0;
    // Whenever one of them has moved.
    virtual void lamps(const Lamps& /*lamps*/, double /*time_s*/) {}
    // What a person should know of the run: aborts, resets, what a tolerant monitor locks on to.
    virtual void log(const std::string& /*line*/) {}

protected:
    ~Audience() = default;
};

// The memory that programs are loaded into.
const std::vector<MemoryRange>& program_memory();

class Board : public sc_core::sc_module, private PinListener {
public:
    // What runs on it, and so which processor it has: NativeCpu or ArmCpu.
    using Software = std::variant<Firmware, ArmProgram>;

    Board(const sc_core::sc_module_name& name, Audience& audience, Software software,
          std::uint64_t seed, const std::string& trace_file,
          Fpga::Memory memory = Fpga::Memory::BRIDGED, unsigned audio_rate = 8'000,
          Ps2Ports ps2_ports = {}, Monitor::Strictness vga = Monitor::Strictness::STRICT);

    // Hands on the board: masks of keypad keys (4 * row + column), HPS_KEY and KEY3-0, and SW9-0.
    void hold(std::uint16_t keypad, std::uint8_t keys, std::uint16_t switches);
    void release(std::uint16_t keypad, std::uint8_t keys, std::uint16_t switches);

    // From the next conversion on; `channel` is 0 to 7.
    void set_voltage(unsigned channel, double volts);

    // Drives pins of the headers from outside: masks of their D31-D0.
    void drive_pins(std::uint32_t jp1, std::uint32_t jp2, PinLevel level);

    // At the first JTAG UART's terminal, and at another one if there is one.
    void type(const std::string& text) {
        jtag_host.type(text);
        typed_(text);
    }
    void also_type_to(std::function<void(const std::string&)> terminal) {
        typed_ = std::move(terminal);
    }

    // As of the last clock that was run.
    const Lamps& lamps() const { return lamps_; }
    // The character buffer's 60 rows of 80, as the processor would read it; once the run is over,
    // outside simulated time.  The monitor shows letters, but only as pixels.
    std::vector<std::string> characters();

private:
    void video(const std::uint32_t* samples, std::size_t count) override;
    void codec(const CodecPins& pins, std::uint64_t time_ps, FabricInputs& in) override;
    void headers(const HeaderPins& pins, std::uint64_t time_ps, FabricInputs& in) override;
    void adc(const AdcPins& pins, std::uint64_t time_ps, FabricInputs& in) override;
    void sdram(const SdramPins& pins, std::uint64_t time_ps, std::uint16_t& dq,
               bool& more) override;
    void lamps(const LampPins& pins, std::uint64_t time_ps) override;
    void ps2(unsigned clk_low, unsigned dat_low, FabricInputs& in) override;
    void jtag_byte(unsigned number, char byte, FabricInputs& in) override;
    std::uint8_t td_data(std::uint64_t rise) override { return video_decoder.data(rise); }
    void header_wires(FabricInputs& in);
    void ps2_wires(FabricInputs& in) const;

    Audience& audience_;
    std::function<void(const std::string&)> typed_ = [](const std::string&) {};
    Lamps lamps_;
    Header jp1_, jp2_;
    unsigned ps2_clk_low_ = 0, ps2_dat_low_ = 0;    // by the FPGA
    std::array<Ps2Device*, 2> ps2_{};               // in each port; may be none
    double rate_hz_ = 0;                            // of the samples given to the audience so far
    std::function<void(bool)> h2f_gate_, lw_gate_;  // true: out of reset
    LostAccesses lost_accesses_;

public:  // the parts, in the order in which they are soldered
    Monitor monitor;
    SoundSource line_in, microphone;
    Wm8731 codec_chip;
    Adv7180 video_decoder;
    Ltc2308 adc_chip;
    Is42s16320d sdram_chip;
    Keypad keypad;
    Ps2Keyboard ps2_keyboard;
    Ps2Mouse ps2_mouse;
    RemoteControl remote_control;
    Fpga fpga;
    JtagHost jtag_host;
    Memory ddr3;
    Peripherals hps;
    Bus bus;

private:
    std::unique_ptr<Processor> processor_;

public:
    Processor& cpu;
    ArmCpu* const arm;  // the same, if that is what it is
};

}  // namespace sim
