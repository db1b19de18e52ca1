"""clocks_test.py DE1SIM FOLDER [CASE...] - parts of the board whose clock the design makes."""
import hashlib

from case import Case, run

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


if __name__ == "__main__":
    run()
