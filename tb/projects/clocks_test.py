"""clocks_test.py DE1SIM FOLDER [CASE...] - clocks that the design makes, and parts of the board
that have one of these."""
import hashlib

from case import Case, run
from systems import LW, SystemCase, clocked

# All that the DAC sees is right in the half of a pixel in which `half` is 0, and wrong from the
# edge on with which `half` rises.
FORMS = """\
module top(input CLOCK_50, input [9:0] SW, output VGA_CLK, output VGA_HS, VGA_VS, VGA_BLANK_N,
           output VGA_SYNC_N, output [7:0] VGA_R, VGA_G, VGA_B);
reg half = 0, good = 0, late = 0, r = 0, s = 0;
reg [9:0] x = 799, y = 524, col = 0, row = 0;
wire pll_clk;
altera_pll #(.number_of_clocks(1), .output_clock_frequency0("25.0 MHz")) pll (
    .refclk(CLOCK_50), .rst(1'b0), .outclk(pll_clk));
always @(posedge CLOCK_50) begin
    half <= ~half;
    good <= half;
    if (half) begin
        x <= x == 799 ? 0 : x + 1;
        if (x == 799) y <= y == 524 ? 0 : y + 1;
    end
end
always @(negedge CLOCK_50) late <= ~half;
always @(posedge half) r <= ~r;
always @(negedge half) s <= r;
assign VGA_CLK = SW[0] ? pll_clk                // a PLL's, with the edge
               : SW[1] ? ~CLOCK_50 & ~half      // gated
               : SW[2] ? late                   // of the falling edge
               : SW[3] ? r ^ s                  // a ripple after
               : SW[4] ? half | (~CLOCK_50 & late)
               : half;                          // a register, with the edge
wire shown = x < 640 && y < 480;
assign VGA_HS = !(x >= 656 && x < 752), VGA_VS = !(y >= 490 && y < 492), VGA_SYNC_N = 0;
assign VGA_BLANK_N = good ? shown : ~shown;
assign {VGA_R, VGA_G, VGA_B} = good ? {x[7:0], y[7:0], 8'h55} : 24'hFF00FF;
endmodule
"""


# What a design may see of CLOCK_50; of the first ones nothing but the rise.  Each counts in `n`.
ONLY_RISES = ["always @(posedge CLOCK_50) n <= n + 1;",
              "wire c = CLOCK_50; part p(c, n);",
              "reg h = 0; always @(posedge CLOCK_50) h <= ~h;\n"
              "always @(posedge h) n[15:1] <= n[15:1] + 1;",
              "always @(posedge CLOCK_50 or posedge SW[9]) if (SW[9]) n <= 0; else n <= n + 1;"]
MORE = ["always @(negedge CLOCK_50) n <= n + 1;",
        "wire c = ~CLOCK_50; always @(posedge c) n <= n + 1;",
        "wire c = CLOCK_50 & ~SW[9]; always @(posedge c) n <= n + 1;",
        "reg r = 0, f = 1; always @(posedge CLOCK_50) begin n <= n + (r ^ f); r <= ~r; end\n"
        "always @(negedge CLOCK_50) f <= ~r;",
        "always @(posedge CLOCK_50) n <= n + 1; assign GPIO_0[0] = CLOCK_50;",
        "reg h = 0; always @(posedge CLOCK_50) begin if (CLOCK_50) n <= n + 1; h <= ~h; end\n"
        "wire [1:0] cs = {h, CLOCK_50}; part p(cs[1], );"]
COUNTER = """module part(input c, output reg [15:0] n); initial n = 0;
always @(posedge c) n <= n + 1; endmodule
module top(input CLOCK_50, input [9:0] SW, inout [35:0] GPIO_0, output [9:0] LEDR);
{} n{}; {}
reg [15:0] t = 0, at = 0;
always @(posedge CLOCK_50) if (t != 40030) begin t <= t + 1; at <= n; end
assign LEDR = at[15:6];
endmodule
"""


class Edges(Case):
    def test_of_clock_50_are_seen_as_the_design_uses_them(self):
        for uses in ONLY_RISES + MORE:
            with self.subTest(uses):
                kind = ("wire [15:0]", "") if ", n)" in uses else ("reg [15:0]", " = 0")
                self.write(top_v=COUNTER.format(*kind, uses))
                self.leds(40030 >> 6, wait="50ms")  # lamps that blink are lit for a while
                facts = (self.folder / ".de1sim/de1sim_facts.h").read_text()
                self.assertIn("CLOCK_50_ONLY_RISES = " + str(uses in ONLY_RISES).lower(), facts)


class Dac(Case):
    def test_takes_what_was_there_before_its_clock_rose(self):
        """The clock changes its form in the vertical blanking, and nothing is seen of that."""
        self.write(top_v=FORMS)
        frame_us = 16800
        steps = [f"delay: {3 * frame_us + 16000}us"]
        for switch in range(5):
            steps += [f"hold: {{switch: {switch}, bounce: 0ms}}", f"delay: {frame_us}us",
                      f"release: {{switch: {switch}, bounce: 0ms}}"]
        self.plays(*steps)
        rgb = bytes(c for y in range(480) for x in range(640) for c in (x & 255, y & 255, 0x55))
        pictures = self.report()["frames"]["pictures"]
        self.assertEqual(list(pictures.values()), [hashlib.sha256(rgb).hexdigest()])
        self.assertGreater(self.report()["frames"]["shown"], 5)

    def test_sees_nothing_without_a_clock(self):
        self.write(top_v=FORMS.replace("output VGA_CLK, output", "output")
                   .replace("assign VGA_CLK", "wire VGA_CLK"))
        done = self.plays("delay: 60ms")
        self.assertEqual(self.report()["frames"]["shown"], 0)
        self.assertIn("VGA_CLK does not rise", done.stderr)


class PinClock(Case):
    """A PLL's clock that goes to a pin, straight."""

    DESIGN = """\
module wiz(input refclk, output a, b);
altera_pll #(.number_of_clocks(2), .output_clock_frequency0("50.0 MHz"),
             .output_clock_frequency1("12.5 MHz")) pll (
    .refclk(refclk), .rst(1'b0), .outclk({b, a}));
endmodule
module counter(input clk, output reg [9:0] n = 0);
always @(posedge clk) if (!(&n)) n <= n + 1;
endmodule
module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR, output AUD_XCK);
wire a, b;
reg was = 0;
wiz w(.refclk(CLOCK_50), .a(a), .b(b));
assign AUD_XCK = b;
USE
endmodule
"""
    USES = {"by_a_block": "reg [9:0] n = 0; always @(posedge b) if (!(&n)) n <= n + 1;\n"
                          "assign LEDR = n;",
            "by_its_fall": "reg [9:0] n = 0; always @(negedge b) if (!(&n)) n <= n + 1;\n"
                           "assign LEDR = n;",
            "below": "counter c(.clk(b), .n(LEDR));",
            "behind_the_pin": "counter c(.clk(AUD_XCK), .n(LEDR));",
            "in_a_vector": "wire [1:0] both = {a, b}; counter c(.clk(both[0]), .n(LEDR));",
            "gated": "counter c(.clk(b && !SW[0]), .n(LEDR));",
            "as_data": "always @(posedge CLOCK_50) was <= b;\n"
                       "counter c(.clk(was), .n(LEDR));",
            "in_a_generate": "generate if (1) begin : g wire c; assign c = b; end endgenerate\n"
                             "counter c(.clk(g.c), .n(LEDR));"}

    def test_is_seen_by_the_design_too_where_that_uses_it(self):
        for name, use in self.USES.items():
            with self.subTest(name):
                self.write(top_v=self.DESIGN.replace("USE", use))
                self.leds(0x3FF)

    def test_stands_while_its_pll_is_in_reset(self):
        held = FORMS[:FORMS.index("assign VGA_CLK")] + "assign VGA_CLK = pll_clk;\n" + \
            FORMS[FORMS.index("wire shown"):]
        self.write(top_v=held.replace("1'b0), .outclk", "SW[5]), .outclk"))
        self.assertNotIn("VGA_CLK", self.plays("delay: 100ms").stderr)
        self.assertGreater(self.report()["frames"]["shown"], 0)
        done = self.plays("hold: {switch: 5}", "delay: 60ms")
        self.assertEqual(self.report()["frames"]["shown"], 0)
        self.assertIn("VGA_CLK does not rise", done.stderr)


class Lock(Case):
    """A PLL's, which counts 16 clocks of its reference: 60 to 64 of 200 MHz."""

    DESIGN = """\
module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);
wire clk, unused, locked;
reg [7:0] n = 0, waited = 0;
reg was = 0, other = 0;
altera_pll #(.number_of_clocks(2), .output_clock_frequency0("200.0 MHz"),
             .output_clock_frequency1("33.0 MHz")) pll (
    .refclk(CLOCK_50), .rst(SW[0]), .outclk({unused, clk}), .locked(locked));
always @(posedge clk) begin
    was <= locked;
    n <= locked ? 0 : n + 1;
    if (locked != was) waited <= n;
end
assign LEDR = {locked, other, 7'd0, waited >= 60 && waited <= 65};
endmodule
"""
    USE = "always @(posedge CLOCK_50) other <= SW[1];\nassign"

    def test_comes_in_time_where_nothing_else_sees_the_reference(self):
        for design in self.DESIGN, self.DESIGN.replace("assign", self.USE):
            with self.subTest(design):
                self.write(top_v=design)
                self.plays("delay: 1ms", 'expect-leds: "1000000001"',
                           "hold: {switch: 0, bounce: 0ms}", "delay: 1ms",
                           'expect-leds: "0000000001"',
                           "release: {switch: 0, bounce: 0ms}", "delay: 1ms",
                           'expect-leds: "1000000001"')
                facts = (self.folder / ".de1sim/de1sim_facts.h").read_text()
                self.assertIn("CLOCK_50_SEEN = " + str("[1]" in design).lower(), facts)
                self.assertRegex(facts, "30303030.*, false, false}, {0,")  # the other output


class Sdram(Case):
    DESIGN = """\
module top(input CLOCK_50, input [9:0] SW, output reg [9:0] LEDR, output DRAM_CLK, %s
           output reg DRAM_CS_N, DRAM_RAS_N, DRAM_CAS_N, DRAM_WE_N, output [1:0] DRAM_BA,
           output reg [12:0] DRAM_ADDR, output DRAM_UDQM, DRAM_LDQM, inout [15:0] DRAM_DQ);
reg clk = 0, drive = 0;
reg [13:0] n = 0;
assign DRAM_CLK = clk, DRAM_BA = 0, DRAM_UDQM = 0, DRAM_LDQM = 0;
assign DRAM_DQ = drive ? 16'h12A5 : 16'hzzzz;
task command(input [3:0] c, input [12:0] a);
    begin {DRAM_CS_N, DRAM_RAS_N, DRAM_CAS_N, DRAM_WE_N} <= c; DRAM_ADDR <= a; end
endtask
always @(posedge CLOCK_50) begin  // commands are there when clk falls, and gone when it rises
    clk <= ~clk;
    command(15, 13'h1fff);
    drive <= 0;
    if (clk) begin
        if (n != 14'h3fff) n <= n + 1;
        case (n)
            3000: command(2, 13'h400);
            3010: command(1, 0);
            3020: command(1, 0);
            3030: command(0, 13'h220);
            3040: command(3, 5);
            3050: begin command(4, 7); drive <= 1; end
            3060: command(5, 7);
        endcase
    end
    if (n == 3063 && !clk) LEDR <= DRAM_DQ[9:0];
end
%s
endmodule
"""

    def test_takes_what_was_there_before_its_clock_rose(self):
        """Also where the project leaves CKE open: an unused pin has a pull-up."""
        self.write(top_v=self.DESIGN % ("", ""))
        self.leds(0x2A5)

    def test_takes_no_command_while_cke_is_low(self):
        self.write(top_v=self.DESIGN % ("output DRAM_CKE,", "assign DRAM_CKE = SW[0];"))
        self.leds(0x2A5, switches=1)
        self.leds(0)
        said = self.report()["sdram_violations"]["first"]
        self.assertIn("READ at 122.46 us: not taken, since CKE is low", said)

# Rises of c0 and c1 within 1000 clocks of CLOCK_50, and for how many of these c1 was high.
MEASURE = """
reg [15:0] n0 = 0, n1 = 0, t = 0, last0 = 0, last1 = 0, f0 = 0, f1 = 0, high = 0, h1 = 0;
always @(posedge c0) n0 <= n0 + 1;
always @(posedge c1) n1 <= n1 + 1;
always @(posedge CLOCK_50) begin
    t <= t == 999 ? 0 : t + 1;
    high <= t == 999 ? c1 : high + c1;
    if (t == 999) begin {last0, last1} <= {n0, n1}; f0 <= n0 - last0; f1 <= n1 - last1;
        h1 <= high; end
end
"""


class Reconfiguration(SystemCase):
    def pll(self, body, *clocks, **parameters):
        """The measures are at 0x100, whether it is locked at 0x110, its registers at 0x200."""
        self.with_leds(
            [("pll", "altera_pll", {
                "gui_reference_clock_frequency": "50.0", "gui_en_reconf": "true",
                "gui_number_of_clocks": str(len(clocks)), **parameters,
                **{f"gui_output_clock_frequency{n}": str(mhz) for n, mhz in enumerate(clocks)}}),
             ("set", "altera_pll_reconfig", {}),
             *((name, "altera_avalon_pio", {"width": "32", "direction": "Input"})
               for name in ("rates", "more"))],
            [*clocked("pll", "refclk", "reset"), *clocked("set", "mgmt_clk", "mgmt_reset"),
             *clocked("rates"), *clocked("more"), ("avalon", LW, "rates.s1", 0x100),
             ("avalon", LW, "more.s1", 0x110), ("avalon", LW, "set.mgmt_avalon_slave", 0x200),
             ("conduit", "set.reconfig_to_pll", "pll.reconfig_to_pll"),
             ("conduit", "pll.reconfig_from_pll", "set.reconfig_from_pll")],
            [("c0", "pll.outclk0"), ("c1", "pll.outclk1"), ("locked", "pll.locked"),
             ("rates", "rates.external_connection"), ("more", "more.external_connection")])
        self.write(top_v=f"""module top(input CLOCK_50, output [9:0] LEDR);
wire c0, c1, locked;
{MEASURE}
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .c0_clk(c0), .c1_clk(c1),
           .locked_export(locked), .rates_export({{f0, f1}}), .more_export({{h1, 15'd0, locked}}));
endmodule
""")
        self.program(body + "\nLEDS = 0x3FF;", """#define LEDS R32(0xFF200000)
#define CHECK(n, c) if (!(c)) { LEDS = n; for (;;) {} }
#define SET(n) R32(0xFF200200 + 4 * (n))
#define LOCKED (R32(0xFF200110) & 1)
enum { MODE, STATUS, START, N, M, C, PHASE, K, C0 = 10, C1 };
int near(unsigned a, unsigned b) { return a + 1 >= b && b + 1 >= a; }
// Over two whole spans of measuring.
int rates(unsigned a, unsigned b) {
    for (volatile unsigned n = 0; n < 20000; ++n) {}
    return near(R32(0xFF200100) >> 16, a) && near(R32(0xFF200100) & 0xFFFF, b);
}
""")
        self.shows(0x3FF)

    def test_counters_that_a_program_writes_change_the_clocks(self):
        self.pll("""CHECK(1, SET(M) == 0x303 && SET(N) == 0x10000 && SET(C0) == 0x20201);
CHECK(2, SET(C1) == 0x606 && rates(2000, 500) && LOCKED);
SET(C) = 1 << 18 | 0x303; CHECK(3, rates(2000, 500) && SET(C1) == 0x303);
SET(START) = 0; CHECK(4, SET(STATUS) == 1 && rates(2000, 1000) && LOCKED);
SET(M) = 0x404; SET(START) = 0; CHECK(5, rates(2667, 1333));
SET(N) = 0x101; SET(M) = 0x808; SET(C) = 1 << 18 | 0x10000; SET(START) = 0;
CHECK(6, rates(2667, 8000) && SET(N) == 0x101);
SET(MODE) = 1; SET(C) = 0x202; SET(START) = 0;
CHECK(7, SET(STATUS) == 0); SET(C) = 0x303; SET(M) = 0x808;
while (!SET(STATUS)) {} CHECK(8, SET(C0) == 0x202 && rates(2000, 8000) && LOCKED);
SET(C) = 1 << 18 | 50 << 8 | 150; SET(START) = 0; while (!SET(STATUS)) {}
CHECK(9, rates(2000, 40)); unsigned high = R32(0xFF200110) >> 16;  // a quarter, to a clock each
CHECK(9, high >= 240 && high <= 280);
SET(M) = 0x202; SET(START) = 0; while (!SET(STATUS)) {}
CHECK(10, rates(2000, 40) && !LOCKED);
SET(M) = 0x808; SET(K) = 0x80000000; SET(START) = 0; while (!SET(STATUS)) {}
CHECK(11, rates(2000, 40) && LOCKED && SET(MODE) == 1);
SET(MODE) = 0; CHECK(12, SET(MODE) == 0);""", 100, 25)

    def test_a_fraction(self):
        self.pll("""CHECK(1, SET(M) == 0x303 && SET(K) == 0x66666666 && SET(C0) == 0x404);
CHECK(2, rates(800, 400)); SET(K) = 0x80000000; SET(START) = 0;
CHECK(3, rates(812, 406) && LOCKED);""", 40, 20, gui_pll_mode="Fractional-N PLL")

    def test_what_check_says(self):
        self.test_a_fraction()
        self.assertIn("PLL: 40.000000 MHz, phase 0.000 ns, until it is reconfigured\n",
                      self.de1sim("check", "top.qsf").stdout)

    def test_a_mif_is_refused(self):
        self.refuses("set does not take its parameters: ENABLE_MIF is set, but settings of a MIF",
                     [("set", "altera_pll_reconfig", {"ENABLE_MIF": "true"})])

    def test_a_pll_as_the_wizard_writes_it(self):
        """Another of the same clock, which cannot be set, keeps that."""
        self.write(top_v="""module top(input CLOCK_50, output [9:0] LEDR);
wire c0, c1; wire [63:0] to, from; reg [2:0] at = 0; wire waits;
altera_pll #(.reference_clock_frequency("50.0 MHz"), .number_of_clocks(1),
    .output_clock_frequency0("100.0 MHz"), .pll_type("Cyclone V"), .pll_subtype("Reconfigurable"),
    .m_cnt_hi_div(4), .m_cnt_lo_div(4), .n_cnt_hi_div(256), .n_cnt_lo_div(256),
    .n_cnt_bypass_en("true"), .c_cnt_hi_div0(2), .c_cnt_lo_div0(2), .c_cnt_bypass_en0("false"))
    pll (.refclk(CLOCK_50), .rst(1'b0), .outclk(c0), .reconfig_to_pll(to),
         .reconfig_from_pll(from));
altera_pll #(.output_clock_frequency0("100.0 MHz")) same (
    .refclk(CLOCK_50), .rst(1'b0), .outclk(c1));
altera_pll_reconfig_top #(.device_family("Cyclone V"), .ENABLE_MIF(0)) set (
    .mgmt_clk(CLOCK_50), .mgmt_reset(1'b0), .mgmt_write(at >= 2 && at < 4), .mgmt_read(1'b0),
    .mgmt_address(at == 2 ? 6'd5 : 6'd2), .mgmt_writedata(32'h505), .mgmt_waitrequest(waits),
    .reconfig_to_pll(to), .reconfig_from_pll(from));
always @(posedge CLOCK_50) if (!waits && at != 7) at <= at + 1;
""" + MEASURE + "assign LEDR = {f0 == 800 || f0 == 801 || f0 == 799, f1 == 2000};\nendmodule\n")
        self.leds(3)


if __name__ == "__main__":
    run()
