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

    def test_a_byte_before_another_start_is_not_acknowledged(self):
        """Else the device sends another, which begins with 0, and there is no START."""
        self.i2c("""rate(60, 40, 20); begins();
put(0x2A0); put(0); put(0x11); put(0x22); put(0x133);
put(0x2A0); put(0);
put(0x2A1); put(0); put(0x2A1); put(0);
CHECK(1, get() == 0x11 && get() == 0x22);
put(0x2A1); CHECK(2, I2C(BYTES) == 0); put(0x100); CHECK(3, get() == 0x33); rest();
CHECK(4, (I2C(ISR) & 0x1C) == 0);
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


# A device for each master: `out` is what it sends next, `in` what came last, with the number of
# words while it was selected, of selections, and the clocks of the shortest half period and of the
# time from SS_n to SCLK.
SPI_DEVICE = """
module spi_device #(parameter BITS = 8, MODE = 0, LSB = 0) (
    input clk, input ss, input sclk, input mosi, output miso, input [31:0] out,
    output reg [31:0] in, output [31:0] seen);
    reg [BITS-1:0] shift = 0, got = 0; reg [5:0] n = 0;
    reg [7:0] words = 0, times = 0, half = 255, lead = 0, clocks = 0;
    reg was_ss = 1, was = 0, any = 0, wrong = 0;
    wire level = sclk ^ (MODE >= 2);                       // 0 at rest
    wire sample = level ^ (MODE % 2 == 1), changes = level != was;
    wire [BITS-1:0] next = LSB ? {mosi, got} >> 1 : {got, mosi};
    assign miso = LSB ? shift[0] : shift[BITS-1], seen = {words, times, half, lead | {8{wrong}}};
    always @(posedge clk) begin
        was_ss <= ss; was <= level;
        clocks <= was_ss != ss || changes ? 1 : clocks + 1;
        if (ss && was_ss && (level || changes)) wrong <= 1;
        if (was_ss && !ss) begin
            shift <= out; n <= 0; times <= times + 1; words <= 0; any <= 0;
        end
        if (!ss && !was_ss && changes) begin
            any <= 1;
            if (!any) lead <= clocks; else if (clocks < half) half <= clocks;
            if (sample) begin
                got <= next; n <= n + 1;
                if (n == BITS - 1) begin in <= next; words <= words + 1; n <= 0; end
            end else if (n != 0) shift <= LSB ? shift >> 1 : shift << 1;
            else if (words != 0) shift <= out;
        end
    end
endmodule
"""
SPI = CHECK + """#define SPI(n, r) R32(0xFF200100 + 0x40 * (n) + 4 * (r))
#define IN(n) R32(0xFF200800 + 0x40 * (n))
#define SEEN(n) R32(0xFF200810 + 0x40 * (n))
#define OUT(n) R32(0xFF200820 + 0x40 * (n))
enum { RX, TX, STATUS, CONTROL, SELECT = 5, END };
enum { ROE = 8, TOE = 16, TMT = 32, TRDY = 64, RRDY = 128, E = 256, EOP = 512, SSO = 1024 };
unsigned word(unsigned n, unsigned out) {
    while (!(SPI(n, STATUS) & TRDY)) {} SPI(n, TX) = out;
    while (!(SPI(n, STATUS) & RRDY)) {} return SPI(n, RX);
}
"""


class Spi(SystemCase):
    """Masters at 0x100, 0x140, ..., each with a device; devices' words at 0x800, 0x840, ..."""

    def masters(self, body, *all_parameters, leds=0x3FF):
        modules, wires, exports, ports, devices = [], [], [], "", ""
        for n, parameters in enumerate(all_parameters):
            bits, mode = int(parameters.get("dataWidth", 8)), int(parameters.pop("mode", 0))
            parameters |= {"clockPolarity": str(mode // 2), "clockPhase": str(mode % 2),
                           "inputClockRate": "50000000"}
            modules += [(f"m{n}", "altera_avalon_spi", parameters)]
            wires += [*clocked(f"m{n}"), ("avalon", LW, f"m{n}.spi_control_port", 0x100 + 64 * n),
                      ("interrupt", "hps_0.f2h_irq0", f"m{n}.irq", n)]
            exports += [(f"m{n}", f"m{n}.external")]
            for at, name in enumerate(("in", "seen", "out")):
                modules += [(f"{name}{n}", "altera_avalon_pio",
                             {"width": "32", "direction": "Output" if at == 2 else "Input"})]
                wires += [*clocked(f"{name}{n}"),
                          ("avalon", LW, f"{name}{n}.s1", 0x800 + 64 * n + 16 * at)]
                exports += [(f"{name}{n}", f"{name}{n}.external_connection")]
                ports += f", .{name}{n}_export({name}{n})"
            ports += "".join(f", .m{n}_{port}({wire}{n})" for port, wire in
                             (("MISO", "miso"), ("MOSI", "mosi"), ("SCLK", "k"), ("SS_n", "ss")))
            lsb = int(parameters.get("lsbOrderedFirst") == "true")
            slaves = int(parameters.get("numberOfSlaves", 1))
            devices += f"""
wire miso{n}, mosi{n}, k{n}; wire [{slaves - 1}:0] ss{n}; wire [31:0] in{n}, seen{n}, out{n};
spi_device #({bits}, {mode}, {lsb}) d{n} (CLOCK_50, ss{n}[{slaves - 1}], k{n}, mosi{n}, miso{n},
                                          out{n}, in{n}, seen{n});
"""
        self.with_leds(modules, wires, exports)
        self.write(top_v=SPI_DEVICE + "module top(input CLOCK_50, output [9:0] LEDR);" + devices +
                   "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR)" +
                   ports + ");\nendmodule\n")
        self.program(body + "\nLEDS = 0x3FF;", SPI)
        self.shows(leds)

    def test_the_four_modes_and_words_of_1_to_32_bits(self):
        self.masters("""static const unsigned mask[] = {0xFF, 0xFFF, 0xFFFFFFFF, 0xFFFF, 1};
for (unsigned n = 0; n < 5; ++n)
    for (unsigned k = 1; k < 4; ++k) {
        unsigned out = 0xA5C3E187 * k & mask[n], back = 0x35769A2F * k & mask[n];
        OUT(n) = back;
        CHECK(8 * n + k, word(n, out) == back && IN(n) == out); }
for (unsigned n = 0; n < 5; ++n) CHECK(64 + n, SEEN(n) >> 16 == 0x103 && (SEEN(n) & 0xFF) == 6);
CHECK(80, (SEEN(0) >> 8 & 0xFF) == 6);""",
                     *({"dataWidth": str(bits), "mode": mode, "targetClockRate": "4500000",
                        "lsbOrderedFirst": "true" if mode in (1, 2) else "false"}
                       for bits, mode in ((8, 0), (12, 1), (32, 2), (16, 3), (1, 0))))

    def test_slaves_are_selected_for_a_word_or_by_sso(self):
        self.masters("""OUT(0) = 0x5A; CHECK(1, SPI(0, SELECT) == 1);
word(0, 0x11); CHECK(2, SEEN(0) >> 16 == 0);
SPI(0, SELECT) = 6; CHECK(3, SPI(0, SELECT) == 1);
CHECK(4, word(0, 0x22) == 0x5A && IN(0) == 0x22 && SPI(0, SELECT) == 6);
word(0, 0x33); CHECK(5, SEEN(0) >> 16 == 0x102);
SPI(0, CONTROL) = SSO; CHECK(6, SPI(0, CONTROL) == SSO);
for (unsigned n = 0; n < 3; ++n) {
    OUT(0) = 0x40 + n; CHECK(7, word(0, n) == (n ? 0x3F + n : 0x5A)); }
CHECK(8, SEEN(0) >> 16 == 0x303);
SPI(0, CONTROL) = 0; SPI(0, SELECT) = 1; CHECK(9, SPI(0, SELECT) == 6);
SPI(0, CONTROL) = SSO; CHECK(10, SPI(0, SELECT) == 1); SPI(0, CONTROL) = 0; word(0, 0x44);
CHECK(11, SEEN(0) >> 16 == 0x303 && IN(0) == 2);""",
                     {"numberOfSlaves": "3", "targetClockRate": "5000000"})

    def test_status_and_interrupts(self):
        self.masters("""#define IRQ (R32(0xFFFED208) & 0x100)
OUT(0) = 0x5A; CHECK(1, SPI(0, STATUS) == (TMT | TRDY) && !IRQ);
SPI(0, TX) = 1; CHECK(2, (SPI(0, STATUS) & (TMT | TRDY)) == TRDY);
SPI(0, TX) = 2; CHECK(3, (SPI(0, STATUS) & (TMT | TRDY | TOE)) == 0);
SPI(0, CONTROL) = TOE; SPI(0, TX) = 3;
CHECK(4, (SPI(0, STATUS) & (TOE | E)) == (TOE | E) && IRQ);
SPI(0, STATUS) = 0; CHECK(5, (SPI(0, STATUS) & (TOE | E)) == 0 && !IRQ);
SPI(0, CONTROL) = RRDY; CHECK(6, !IRQ);
while (!(SPI(0, STATUS) & RRDY)) {} CHECK(7, IRQ);
while (!(SPI(0, STATUS) & TMT)) {}
CHECK(8, (SPI(0, STATUS) & (ROE | E)) == (ROE | E) && IN(0) == 2);
SPI(0, CONTROL) = ROE; CHECK(9, IRQ); SPI(0, CONTROL) = E; CHECK(10, IRQ);
CHECK(11, SPI(0, RX) == 0x5A && (SPI(0, STATUS) & (RRDY | ROE)) == ROE);
SPI(0, STATUS) = 0; CHECK(12, SPI(0, STATUS) == (TMT | TRDY) && !IRQ);
SPI(0, CONTROL) = TRDY; CHECK(13, IRQ); SPI(0, CONTROL) = EOP; CHECK(14, !IRQ);
SPI(0, END) = 0x77; CHECK(15, SPI(0, END) == 0x77);
word(0, 0x76); CHECK(16, !(SPI(0, STATUS) & EOP));
SPI(0, TX) = 0x77; CHECK(17, SPI(0, STATUS) & EOP && IRQ);
SPI(0, STATUS) = 0; OUT(0) = 0x77; while (!(SPI(0, STATUS) & TMT)) {}
SPI(0, STATUS) = 0; SPI(0, TX) = 0; while (!(SPI(0, STATUS) & TMT)) {}
CHECK(18, !(SPI(0, STATUS) & EOP) && SPI(0, RX) == 0x77 && SPI(0, STATUS) & EOP);
SPI(0, CONTROL) = ~0u; CHECK(19, SPI(0, CONTROL) == 0x7D8);""",
                     {"targetClockRate": "1000000"})

    def test_the_rate_and_the_delay_before_the_first_edge(self):
        """The next even part of 50 MHz below 3 MHz is an 18th; 1 us is six half periods."""
        self.masters("""word(0, 1); CHECK(1, (SEEN(0) & 0xFFFF) == (9 << 8 | 54));
word(1, 1); CHECK(2, (SEEN(1) & 0xFFFF) == (1 << 8 | 1));""",
                     {"targetClockRate": "3000000", "targetSlaveSelectToSClkDelay": "1000.0",
                      "insertDelayBetweenSlaveSelectAndSClk": "true"},
                     {"targetClockRate": "100000000"})

    def test_slaves_answer_masters(self):
        """Four pairs, the masters at 0x100, the slaves at 0x300."""
        modules, wires, exports, ports, text = [], [], [], "", ""
        for mode in range(4):
            for name, kind, at in (("m", "true", 0x100), ("s", "false", 0x300)):
                modules += [(f"{name}{mode}", "altera_avalon_spi",
                             {"masterSPI": kind, "dataWidth": str((8, 32, 11, 16)[mode]),
                              "clockPolarity": str(mode // 2), "clockPhase": str(mode % 2),
                              "lsbOrderedFirst": "true" if mode == 1 else "false",
                              "insertSync": "true" if mode == 2 else "false",
                              "targetClockRate": "2500000"})]
                wires += [*clocked(f"{name}{mode}"),
                          ("avalon", LW, f"{name}{mode}.spi_control_port", at + 64 * mode)]
                exports += [(f"{name}{mode}", f"{name}{mode}.external")]
                ports += "".join(f", .{name}{mode}_{p}({p}{mode})"
                                 for p in ("MISO", "MOSI", "SCLK", "SS_n"))
            text += f"wire MISO{mode}, MOSI{mode}, SCLK{mode}, SS_n{mode};\n"
        self.with_leds(modules, wires, exports)
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\n" + text +
                   "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR)" +
                   ports + ");\nendmodule\n")
        self.program("""static const unsigned mask[] = {0xFF, 0xFFFFFFFF, 0x7FF, 0xFFFF};
for (unsigned n = 0; n < 4; ++n) {
    unsigned s = n + 8, last = 0;
    for (unsigned k = 1; k < 5; ++k) {
        unsigned out = 0xA5C3E187 * k & mask[n], back = 0x35769A2F * k & mask[n];
        CHECK(32 * n + k, (SPI(s, STATUS) & (TMT | TRDY | RRDY)) == (TMT | TRDY));
        if (k != 3) SPI(s, TX) = back;
        SPI(n, TX) = out;
        while (!(SPI(s, STATUS) & RRDY)) CHECK(32 * n + 8, !(SPI(n, STATUS) & TMT));
        while (!(SPI(n, STATUS) & RRDY)) {}
        CHECK(32 * n + 8 + k, SPI(n, RX) == (k == 3 ? last : back));
        CHECK(32 * n + 16 + k, SPI(s, RX) == out);
        last = out; }
    SPI(n, CONTROL) = SSO; SPI(s, TX) = 1;
    for (unsigned k = 0; k < 100; ++k) CHECK(32 * n + 21, !(SPI(s, STATUS) & TMT));
    SPI(s, TX) = 0; CHECK(32 * n + 22, !(SPI(s, STATUS) & TOE));
    SPI(s, TX) = 0; CHECK(32 * n + 23, SPI(s, STATUS) & TOE);
    CHECK(32 * n + 24, word(n, 7) == 1 && word(n, 8) == 0 && SPI(s, STATUS) & ROE);
    CHECK(32 * n + 25, SPI(s, RX) == 8); SPI(n, CONTROL) = 0; }
LEDS = 0x3FF;""", SPI)
        self.shows(0x3FF)

    def test_wrong_parameters(self):
        for parameter, value, message in (
                ("dataWidth", "33", "dataWidth is 33, expected 1 to 32"),
                ("numberOfSlaves", "0", "numberOfSlaves is 0, expected 1 to 32"),
                ("targetClockRate", "0", "targetClockRate is 0, expected more than 0")):
            self.refuses("spi does not take its parameters: " + message,
                         [("spi", "altera_avalon_spi", {parameter: value})])


if __name__ == "__main__":
    run()
