"""sound_test.py - projects with sound: the codec as slave and as bus master.

Each has its top module, and the two modules below: one that writes the codec's registers over I2C,
and one that sends a square wave of 1 kHz in the left-justified format, in step with any BCLK.
"""
import json

from case import Case, run

SETUP = """
module setup #(parameter [8:0] R7 = 9'h041, parameter [8:0] R8 = 9'd0,
               parameter [7:0] ADDRESS = 8'h34) (
    input clk, inout scl, inout sda, output reg done, output reg refused);
    reg [5:0] tick; reg [6:0] q; reg [2:0] word;
    wire [15:0] data = word == 0 ? {7'd6, 9'h000} : word == 1 ? {7'd4, 9'h010} :
                       word == 2 ? {7'd5, 9'h000} : word == 3 ? {7'd7, R7} :
                       word == 4 ? {7'd8, R8} : word == 5 ? {7'd0, 9'h117} : {7'd9, 9'h001};
    wire [31:0] bits = {1'b1, ADDRESS, 1'b1, data[15:8], 1'b1, data[7:0], 1'b1, 4'b0};
    wire [4:0] slot = q[6:2];
    wire begins = slot == 0, ends = slot == 28;
    wire high = begins ? !q[1] : ends ? q[1] : bits[31 - slot];
    wire up = begins ? q[1:0] != 3 : ends ? q[1:0] != 0 : q[1] ^ q[0];
    assign sda = high || done ? 1'bz : 1'b0;
    assign scl = up || done ? 1'bz : 1'b0;
    always @(posedge clk) if (!done) begin
        tick <= tick + 1;
        if (tick == 0) begin
            q <= q == 115 ? 0 : q + 1;
            if (q == 115) begin word <= word + 1; done <= word == 6; end
            if (q[1:0] == 1 && (slot == 9 || slot == 18 || slot == 27)) refused <= refused | sda;
        end
    end
endmodule
"""

TONE = """
module tone(input clk, input bclk, input lrck, output dacdat);
    reg [15:0] n = 0; reg level = 0, was = 0; reg [1:0] b = 0, l = 0; reg [31:0] shift = 0;
    assign dacdat = shift[31];
    always @(posedge clk) begin
        n <= n == 24999 ? 0 : n + 1;
        if (n == 0) level <= ~level;
        b <= {b[0], bclk};
        l <= {l[0], lrck};
        if (b == 2'b10) begin
            was <= l[0];
            shift <= was != l[0] ? {level ? 16'h2000 : 16'he000, 16'd0} : shift << 1;
        end
    end
endmodule
"""

XCK_12_5 = "reg [1:0] d = 0; always @(posedge CLOCK_50) d <= d + 1; assign AUD_XCK = d[1];\n"
XCK_12 = """
wire [4:0] c; assign AUD_XCK = c[0];
altpll p (.inclk({1'b0, CLOCK_50}), .clk(c));
defparam p.inclk0_input_frequency = 20000, p.clk0_multiply_by = 6, p.clk0_divide_by = 25,
    p.port_clk0 = "PORT_USED", p.width_clock = 5;
"""
SLAVE = """
reg [3:0] k = 0; reg [5:0] bits = 0;
always @(posedge CLOCK_50) begin k <= k + 1; if (k == 15) bits <= bits + 1; end
assign AUD_BCLK = k[3], AUD_DACLRCK = bits[5], AUD_ADCLRCK = bits[5];
"""


class Sound(Case):
    def project(self, body, clocks="inout", registers="", scl="output"):
        self.write(top_v=f"module top(input CLOCK_50, {clocks} AUD_BCLK, {clocks} AUD_DACLRCK,\n"
                         f"{clocks} AUD_ADCLRCK, output AUD_XCK, output AUD_DACDAT,\n"
                         f"input AUD_ADCDAT, {scl} FPGA_I2C_SCLK, inout FPGA_I2C_SDAT,\n"
                         "output [9:0] LEDR);\nwire done, refused;\n"
                         f"setup #({registers}) s (CLOCK_50, FPGA_I2C_SCLK, FPGA_I2C_SDAT,\n"
                         f"done, refused);\n{body}endmodule\n",
                   setup_v=SETUP, tone_v=TONE)

    def audio(self, key):
        return json.loads((self.folder / "out" / "report.json").read_text())["audio"][key]

    SENT = "tone t (CLOCK_50, AUD_BCLK, AUD_DACLRCK, AUD_DACDAT);\nassign LEDR = refused;\n"
    HEARD = "expect-tone: {hz: 1000, within: 1%, for: 20ms, timeout: 100ms}"

    def test_master_by_a_divided_clock(self):
        self.project(self.SENT + XCK_12_5)
        self.assertNotIn("codec", self.plays(self.HEARD, 'expect-leds: "0000000000"').stderr)
        self.assertAlmostEqual(self.audio("rate_hz"), 12.5e6 / 256, delta=1)

    def test_master_in_usb_mode_into_plain_inputs(self):
        """Each of its edges arrives: 12,000 of BCLK in a millisecond."""
        self.project(XCK_12 + "reg [15:0] us = 0; reg [5:0] n = 0; reg [13:0] b = 0;\n"
                     "always @(posedge CLOCK_50) if (done) begin n <= n == 49 ? 0 : n + 1;\n"
                     "if (n == 49 && us < 1100) us <= us + 1; end\n"
                     "always @(posedge AUD_BCLK) if (us >= 100 && us < 1100) b <= b + 1;\n"
                     "assign LEDR = us == 1100 && b > 11990 && b < 12010, AUD_DACDAT = b[3];\n",
                     "input", ".R8(1)")
        self.plays("delay: 5ms", 'expect-leds: "0000000001"')
        self.assertAlmostEqual(self.audio("rate_hz"), 48_000, delta=1)

    def test_slave_of_outputs(self):
        self.project(self.SENT + SLAVE, "output", ".R7(1)")
        self.assertNotIn("codec", self.plays(self.HEARD).stderr)
        self.assertAlmostEqual(self.audio("rate_hz"), 50e6 / 1024, delta=1)

    def test_line_in_comes_back(self):
        self.project(XCK_12_5 + "assign AUD_DACDAT = AUD_ADCDAT, LEDR = 0;\n")
        self.plays("delay: 5ms", "play-tone: {hz: 440}",
                   "expect-tone: {hz: 440, within: 1%, for: 50ms, timeout: 200ms}")

    def test_both_drive(self):
        for clocks in ("output", "inout"):
            self.project(self.SENT + SLAVE + XCK_12_5, clocks)
            said = self.plays("delay: 5ms").stderr
            self.assertEqual(said.count("the FPGA drives BCLK or LRCK, too"), 1, said)

    def test_nobody_drives(self):
        self.project(self.SENT + XCK_12_5, "input", ".R7(1)")
        self.assertIn("silent: it is a slave (R7), and nothing drives BCLK",
                      self.plays("delay: 5ms").stderr)

    def test_the_video_decoder_acknowledges_and_nobody_else(self):
        for address, lit in ("8'h40", "01"), ("8'h42", "11"), ("8'h41", "11"):
            self.project("assign LEDR = {refused, done};\n", registers=f".ADDRESS({address})")
            self.plays("delay: 5ms", f'expect-leds: "00000000{lit}"')

    def test_i2c_with_an_open_drain_clock(self):
        self.project(self.SENT + XCK_12_5, scl="inout")
        self.plays(self.HEARD)


if __name__ == "__main__":
    run()
