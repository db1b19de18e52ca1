"""serial_components_test.py DE1SIM FOLDER [CASE...] - I2C and SPI in a system"""
from case import run
from systems import HW_TCL, LW, OWN_CLOCK, SystemCase, clocked

# In the programs: what fails first has its number on the LEDs.
CHECK = """#define LEDS R32(0xFF200000)
#define CHECK(n, c) if (!(c)) { LEDS = n; for (;;) {} }
"""
I2C = CHECK + """#define I2C(n) R32(0xFF200040 + 4 * (n))
enum { CMD, RX, CTRL, ISER, ISR, STATUS, CMDS, BYTES, LOW, HIGH, HOLD };
void rate(unsigned low, unsigned high, unsigned hold) {
    I2C(CTRL) = 0; I2C(LOW) = low; I2C(HIGH) = high; I2C(HOLD) = hold;
}
void begins(void) { I2C(CTRL) = 1; }
void put(unsigned command) { while (I2C(CMDS) == DEPTH) {} I2C(CMD) = command; }
unsigned get(void) { while (!I2C(BYTES)) {} return I2C(RX); }
void rest(void) { while (I2C(STATUS)) {} }
"""
# Of a component `sender`, whose streams are commands and bytes.
OWN_STREAMS = """foreach {name end data} {cmd start 16 rx end 8} {
    add_interface $name avalon_streaming $end
    set_interface_property $name associatedClock clock
    set forth [expr {$end eq "start" ? "Output" : "Input"}]
    set back [expr {$end eq "start" ? "Input" : "Output"}]
    add_interface_port $name ${name}_data data $forth $data
    add_interface_port $name ${name}_valid valid $forth 1
    add_interface_port $name ${name}_ready ready $back 1
}
add_interface s avalon end
""" + OWN_CLOCK + "add_interface_port s readdata readdata Output 32\n"
# At 0x50: sixteen bytes behind a pointer, of which 8 is the fewest clocks that SCL was low, 9 high,
# 10 those of SDA after SCL's fall, and 11 counts START and, times 16, STOP.  After byte 4 has been
# written it holds SCL for 4 times its value after each acknowledge.
DEVICE = """
module device(input clk, input scl, input sda, output reg scl_low, output reg sda_low);
    reg [7:0] bytes [0:15]; reg [7:0] shift = 0, low = 255, high = 255, hold = 255, starts = 0;
    reg [9:0] wait_ = 0; reg [15:0] time_ = 0, since = 0; reg [3:0] at = 0, bit_ = 0;
    reg [1:0] phase = 0;  // of a transfer: address, pointer, bytes to and from here
    reg was_scl = 1, was_sda = 1, on = 0, nack = 0;
    initial begin scl_low = 0; sda_low = 0; bytes[4] = 0; end
    wire [7:0] out = at == 8 ? low : at == 9 ? high : at == 10 ? hold : at == 11 ? starts
                   : bytes[at];
    always @(posedge clk) begin
        was_scl <= scl; was_sda <= sda;
        time_ <= scl != was_scl ? 1 : time_ + 1;
        since <= was_scl && !scl ? 1 : since + 1;
        if (on && !was_scl && scl && !scl_low && bytes[4] == 0 && time_ < low) low <= time_;
        if (on && was_scl && !scl && bytes[4] == 0 && time_ < high) high <= time_;
        if (on && !scl && !was_scl && sda != was_sda && !sda_low && since < hold && since > 1)
            hold <= since;
        if (wait_ != 0) wait_ <= wait_ - 1; else scl_low <= 0;
        if (scl && was_scl && was_sda && !sda) begin
            on <= 1; bit_ <= 0; phase <= 0; starts[3:0] <= starts[3:0] + 1;
        end else if (scl && was_scl && !was_sda && sda) begin
            on <= 0; starts[7:4] <= starts[7:4] + 1;
        end else if (on && !was_scl && scl && bit_ != 8) begin
            shift <= {shift[6:0], sda}; bit_ <= bit_ + 1;
        end else if (on && !was_scl && scl) begin
            nack <= sda; bit_ <= 9;
        end else if (on && was_scl && !scl) begin
            sda_low <= 0;
            if (bit_ == 8) case (phase)
                0: if (shift[7:1] == 7'h50) sda_low <= 1; else on <= 0;
                1: begin sda_low <= 1; at <= shift[3:0]; end
                2: begin sda_low <= 1; bytes[at] <= shift; at <= at + 1; end
                3: at <= at + 1;
            endcase
            if (bit_ == 9) begin
                bit_ <= 0;
                phase <= phase == 0 ? (shift[0] ? 3 : 1) : phase == 1 ? 2 : phase;
                if (bytes[4] != 0) begin scl_low <= 1; wait_ <= {bytes[4], 2'd0}; end
                if (phase == 3 && nack) on <= 0;
                else if (phase == 3 || phase == 0 && shift[0]) sda_low <= !out[7];
            end else if (phase == 3 && bit_ != 8) sda_low <= !out[7 - bit_];
        end
    end
endmodule
// While `on`, it pulls SDA low from each START to the next STOP, as one who sends zeros.
module rival(input clk, input on, input scl, input sda, output reg sda_low);
    reg was_sda = 1; reg [12:0] left = 0;
    initial sda_low = 0;
    always @(posedge clk) begin
        was_sda <= sda;
        left <= !on ? 0 : scl && was_sda && !sda && left == 0 ? 6000 : left == 0 ? 0 : left - 1;
        sda_low <= left > 1;
    end
endmodule
module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);
wire m_sda, m_scl, d_sda, d_scl, r_sda;
wire sda = !(m_sda || d_sda || r_sda), scl = !(m_scl || d_scl);
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .i2c_sda_in(sda),
           .i2c_scl_in(scl), .i2c_sda_oe(m_sda), .i2c_scl_oe(m_scl));
device dev(.clk(CLOCK_50), .scl(scl), .sda(sda), .scl_low(d_scl), .sda_low(d_sda));
rival other(.clk(CLOCK_50), .on(LEDR[9]), .scl(scl), .sda(sda), .sda_low(r_sda));
endmodule
"""
BOARD = """
module top(input CLOCK_50, output [9:0] LEDR, output AUD_XCK, inout FPGA_I2C_SDAT,
           output FPGA_I2C_SCLK, inout AUD_BCLK, output AUD_DACDAT, inout AUD_DACLRCK,
           input AUD_ADCDAT, inout AUD_ADCLRCK);
wire sda_low, scl_low;
assign FPGA_I2C_SDAT = sda_low ? 1'b0 : 1'bz, FPGA_I2C_SCLK = !scl_low;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .i2c_sda_oe(sda_low),
           .i2c_sda_in(FPGA_I2C_SDAT), .i2c_scl_oe(scl_low), .i2c_scl_in(!scl_low),
           .xck_clk(AUD_XCK), .codec_BCLK(AUD_BCLK), .codec_DACDAT(AUD_DACDAT),
           .codec_DACLRCK(AUD_DACLRCK), .codec_ADCDAT(AUD_ADCDAT), .codec_ADCLRCK(AUD_ADCLRCK));
endmodule
"""
SENDER_TCL = HW_TCL.format(name="sender") + OWN_STREAMS
SENDER = """
module sender(input clk, input reset, output [15:0] cmd_data, output cmd_valid, input cmd_ready,
              input [7:0] rx_data, input rx_valid, output rx_ready, output [31:0] readdata);
    reg [2:0] at; reg [15:0] got;
    assign cmd_data = at == 0 ? 16'h2A0 : at == 1 ? 8 : at == 2 ? 16'h2A1 : at == 3 ? 0 : 16'h100;
    assign cmd_valid = at < 5, rx_ready = 1, readdata = got;
    always @(posedge clk) if (reset) {at, got} <= 0; else begin
        if (cmd_valid && cmd_ready) at <= at + 1;
        if (rx_valid) got <= {got[7:0], rx_data};
    end
endmodule
"""
STREAMS = [*clocked("sender", "clock"), ("avalon", LW, "sender.s", 0x80),
           ("avalon_streaming", "sender.cmd", "i2c.transfer_command_sink"),
           ("avalon_streaming", "i2c.rx_data_source", "sender.rx")]


class I2c(SystemCase):
    def i2c(self, body, depth=4, streams=False):
        self.with_leds([("i2c", "altera_avalon_i2c", {"FIFO_DEPTH": str(depth),
                                                      "USE_AV_ST": str(int(streams))}),
                        *([("sender", "sender", {})] if streams else [])],
                       [*clocked("i2c", "clock", "reset_sink"), ("avalon", LW, "i2c.csr", 0x40),
                        ("interrupt", "hps_0.f2h_irq0", "i2c.interrupt_sender", 3),
                        *(STREAMS if streams else [])],
                       [("i2c", "i2c.i2c_serial")])
        self.write(top_v=DEVICE)
        head, main = body if isinstance(body, tuple) else ("", body)
        self.program(main, f"#define DEPTH {depth}\n" + I2C + head)
        self.shows(0x3FF)

    def test_bytes_go_to_a_device_and_come_back(self):
        self.i2c("""rate(60, 40, 20); begins();
put(0x2A0); put(0x00); put(0x5A); put(0xC3); put(0x101); rest();
CHECK(1, (I2C(ISR) & 0x1C) == 0);
put(0x2A0); put(0x00); put(0x2A1); put(0); put(0); put(0x100);
unsigned a = get(), b = get(), c = get(); rest();
CHECK(2, a == 0x5A && b == 0xC3 && c == 0x01);
put(0x2A0); put(8); put(0x2A1); put(0); put(0); put(0); put(0x100);
unsigned low = get(), high = get(), hold = get(), starts = get(); rest();
CHECK(3, low >= 60 && low < 64);
CHECK(4, high >= 40 && high < 46);
CHECK(5, hold >= 20 && hold < 23);
CHECK(6, starts == 0x25);
CHECK(7, (I2C(ISR) & 0x1E) == 0 && I2C(BYTES) == 0 && I2C(CMDS) == 0);
LEDS = 0x3FF;""")

    def test_a_slow_device_holds_the_clock(self):
        self.i2c("""rate(30, 30, 10); begins();
put(0x2A0); put(4); put(200); put(0x12); put(0x134); rest();
put(0x2A0); put(4); put(0x2A1); put(0); put(0); put(0x100);
CHECK(1, get() == 200 && get() == 0x12 && get() == 0x34); rest();
CHECK(2, (I2C(ISR) & 0x1C) == 0);
LEDS = 0x3FF;""")

    def test_nobody_acknowledges(self):
        self.i2c("""rate(30, 30, 10); begins();
CHECK(1, I2C(STATUS) == 1 && !(R32(0xFFFED208) & 0x800));
I2C(ISER) = 4; put(0x260); put(1); put(2); rest();
CHECK(2, (I2C(ISR) & 0x1C) == 4);
CHECK(3, R32(0xFFFED208) & 0x800);
put(0x2A0); CHECK(4, I2C(CMDS) == 0 && I2C(STATUS) == 0);
I2C(ISR) = 0x1B; CHECK(5, (I2C(ISR) & 0x1C) == 4);
I2C(ISR) = 4; CHECK(6, (I2C(ISR) & 0x1C) == 0 && !(R32(0xFFFED208) & 0x800));
put(0x2A0); put(11); put(0x2A1); put(0x100);
CHECK(7, get() == 0x13); rest();
I2C(CTRL) = 0; CHECK(8, I2C(STATUS) == 0 && (I2C(ISR) & 1) == 0);
LEDS = 0x3FF;""")

    def test_thresholds_and_an_overrun(self):
        self.i2c(("unsigned at(unsigned n) { I2C(CTRL) = n << 4 | n << 2 | 1; "
                  "return I2C(ISR) & 3; }",
                  """rate(60, 60, 20); begins();
CHECK(1, at(0) == 1 && at(3) == 1);
I2C(CTRL) = 0; CHECK(2, (I2C(ISR) & 1) == 0); begins();
put(0x2A0); put(0); put(0x2A1);
for (unsigned n = 0; n < 3; ++n) put(0);
for (unsigned n = 0; n < 3; ++n) { while (I2C(BYTES) <= n) {}
    CHECK(3, I2C(BYTES) == n + 1 && at(0) & 2 && !(at(1) & 2) == !n); }
CHECK(4, at(2) == 1 && at(3) == 1);
for (unsigned n = 3; n < 8; ++n) put(0);
while (I2C(BYTES) != 8) {}
CHECK(5, at(3) == 3 && !(I2C(ISR) & 0x10));
I2C(ISER) = 0x10;
put(0x100); rest();
CHECK(6, (I2C(ISR) & 0x1C) == 0x10 && (R32(0xFFFED208) & 0x800) && I2C(BYTES) == 8);
I2C(ISR) = 0x10; CHECK(7, (I2C(ISR) & 0x1C) == 0);
I2C(CTRL) = 1; rate(65535, 60, 20); begins();
for (unsigned n = 0; n < 8; ++n) put(0x2A0);
CHECK(8, I2C(CMDS) >= 7 && at(0) == 2 && at(1) == 2 && at(2) == 2);
LEDS = 0x3FF;"""), 8)

    def test_another_master_wins(self):
        self.i2c("""rate(50, 50, 20); begins();
LEDS = 0x200; I2C(ISER) = 8; put(0x2A0); put(0); put(0x101); rest();
CHECK(1, (I2C(ISR) & 0x1C) == 8 && (R32(0xFFFED208) & 0x800));
CHECK(2, I2C(CMDS) == 0);
LEDS = 0; I2C(ISR) = 8;
put(0x2A0); put(0); put(0x177); rest();
CHECK(3, (I2C(ISR) & 0x1C) == 0);
put(0x2A0); put(0); put(0x2A1); put(0x100); CHECK(4, get() == 0x77);
LEDS = 0x3FF;""")

    def test_registers_after_a_reset(self):
        self.i2c("""CHECK(1, I2C(CTRL) == 0 && I2C(ISER) == 0 && I2C(ISR) == 0 && I2C(STATUS) == 0);
CHECK(2, I2C(LOW) == 1 && I2C(HIGH) == 1 && I2C(HOLD) == 1 && I2C(11) == 0);
I2C(CTRL) = ~0u; I2C(ISER) = ~0u; I2C(LOW) = 0x12345; I2C(HIGH) = 0x12346; I2C(HOLD) = 0x12347;
CHECK(3, I2C(CTRL) == 0x3F && I2C(ISER) == 0x1F && I2C(LOW) == 0x2345 && I2C(HIGH) == 0x2346);
CHECK(4, I2C(HOLD) == 0x2347);
LEDS = 0x3FF;""", 256)

    def test_a_depth_that_there_is_not(self):
        self.refuses("i2c does not take its parameters: FIFO_DEPTH is 5, expected 4, 8, 16",
                     [("i2c", "altera_avalon_i2c", {"FIFO_DEPTH": "5"})])

    def test_commands_and_bytes_as_streams(self):
        """The sender reads for how long the device has seen SCL low and high."""
        self.write(sender_hw_tcl=SENDER_TCL, sender_v=SENDER)
        self.i2c("""rate(60, 40, 20); begins(); I2C(CMD) = 0x2A0; I2C(CMD) = 0x2A0;
unsigned both = 0; while (both < 0x100) both = R32(0xFF200080);
CHECK(1, both >> 8 >= 60 && both >> 8 < 64 && (both & 0xFF) >= 40 && (both & 0xFF) < 46);
CHECK(2, I2C(CMDS) == 0 && I2C(BYTES) == 0 && I2C(RX) == 0);
LEDS = 0x3FF;""", streams=True)

    def test_the_codec_and_the_video_decoder_of_the_board(self):
        """The codec takes its words, nobody is at 0x1B, and the decoder's IDENT is read."""
        self.with_leds([("i2c", "altera_avalon_i2c", {"FIFO_DEPTH": "16"}),
                        ("pll", "altera_up_avalon_audio_pll", {}),
                        ("audio", "altera_up_avalon_audio", {"dw": "16"})],
                       [*clocked("i2c", "clock", "reset_sink"), ("avalon", LW, "i2c.csr", 0x40),
                        *clocked("pll", "ref_clk", "ref_reset"), *clocked("audio"),
                        ("avalon", LW, "audio.avalon_audio_slave", 0x80)],
                       [("i2c", "i2c.i2c_serial"), ("xck", "pll.audio_clk"),
                        ("codec", "audio.external_interface")])
        self.write(top_v=BOARD)
        self.program("""rate(300, 200, 20); begins();
static const uint16_t words[] = {0xC00, 0x810, 0xA00, 0xE41, 0x1000, 0x117, 0x579, 0x1201};
for (unsigned n = 0; n < 8; ++n) {
    put(0x234); put(words[n] >> 8); put(0x100 | (words[n] & 0xFF)); rest();
    CHECK(1, (I2C(ISR) & 0x1C) == 0); }
put(0x236); rest(); CHECK(2, I2C(ISR) & 4); I2C(ISR) = 4;
put(0x240); put(0x11); put(0x241); put(0x100); CHECK(3, get() == 0x1E); rest();
LEDS = 0x3FF;
for (uint32_t n = 0;; n++) { while ((R32(0xFF200084) >> 16 & 0xFF) == 0) {}
R32(0xFF200088) = R32(0xFF20008C) = n & 32 ? 0x2000 : 0xE000; }""", "#define DEPTH 16\n" + I2C)
        self.played('expect-leds: {equals: "1111111111", timeout: 100ms}',
                    "expect-tone: {hz: 750, for: 60ms, timeout: 400ms}")


if __name__ == "__main__":
    run()
