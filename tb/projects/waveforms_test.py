"""waveforms_test.py DE1SIM FOLDER [CASE...] - what --trace writes of a project, read by GTKWave's
fst2vcd.
"""
import re
import subprocess

from case import Case, run

DESIGN = """\
`timescale 1ns / 1ns
module top(input CLOCK_50, input [3:0] KEY, output [9:0] LEDR, output VGA_CLK, VGA_HS, VGA_VS,
           output VGA_BLANK_N, VGA_SYNC_N, output [7:0] VGA_R, VGA_G, VGA_B, output AUD_XCK);
wire slow, narrow;
altera_pll #(.number_of_clocks(2), .output_clock_frequency0("40.0 MHz"),
             .output_clock_frequency1("10.0 MHz"), .duty_cycle1(20), .phase_shift1("5000 ps")) pll (
    .refclk(CLOCK_50), .rst(1'b0), .outclk({narrow, slow}));
reg rising = 0, falling = 0, slowly = 0;
reg [19:0] n = 0;
always @(posedge CLOCK_50) begin rising <= ~rising; n <= n + 1; end
always @(negedge CLOCK_50) falling <= ~falling;
always @(negedge slow) slowly <= ~slowly;
assign LEDR = {n[12:5], KEY[1:0]};
assign AUD_XCK = narrow;  // which nothing else sees
assign VGA_CLK = ~n[0], VGA_BLANK_N = 1, VGA_SYNC_N = 0;
assign VGA_R = n[8:1], VGA_G = n[16:9], VGA_B = 0, VGA_HS = n[10], VGA_VS = n[19];
endmodule
"""
STEPS = """\
name: s
version: 1
steps:
  - delay: 100us
  - hold: {key: 1}
  - delay: 100us
"""


class Waveforms(Case):
    def changes(self):
        """Signal of the design -> [(ps, value)], after the first values, at 1 and 2 ps."""
        vcd = subprocess.run(["fst2vcd", "-f", str(self.folder / "x.fst")], capture_output=True,
                             text=True, check=True).stdout
        self.assertEqual(re.search(r"\$timescale\s+(\S+)", vcd)[1], "1ps")
        names, found, now, scope = {}, {}, 0, []
        for line in vcd.splitlines():
            words = line.split()
            if line.startswith("$scope"):
                scope.append(words[2])
            elif line.startswith("$upscope"):
                scope.pop()
            elif line.startswith("$var") and scope[-1] == "de1sim_design":
                names.setdefault(words[3], []).append(words[4])
            elif line.startswith("#"):
                now = int(line[1:])
            elif re.match(r"[01]\S", line):
                for name in names.get(line[1:], []):
                    found.setdefault(name, []).append((now, int(line[0])))
        return {name: [c for c in all if c[0] > 2] for name, all in found.items()}

    def is_clock(self, changes, first_ps, period_ps, high_ps):
        rises = [ps for ps, level in changes if level]
        falls = [ps for ps, level in changes if not level]
        self.assertGreater(len(falls), 1000)
        self.assertEqual(rises, [first_ps + n * period_ps for n in range(len(rises))])
        self.assertEqual(falls, [ps + high_ps for ps in rises[:len(falls)]])

    def setUp(self):
        super().setUp()
        self.write(top_v=DESIGN, s_yaml=STEPS)

    def play(self, *options):
        done = self.de1sim("run", "s.yaml", "--project", ".", "--frames", "none", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = self.report()
        report.pop("wall")
        return report

    def test_edges_have_their_true_times_and_results_are_the_same(self):
        traced = self.play("--trace", "x.fst")
        signals = self.changes()
        self.is_clock(signals["CLOCK_50"], 20_000, 20_000, 10_000)
        self.is_clock(signals["slow"], 20_000, 25_000, 12_500)
        self.is_clock(signals["narrow"], 25_000, 100_000, 20_000)
        self.is_clock(signals["rising"], 20_000, 40_000, 20_000)
        self.is_clock(signals["falling"], 30_000, 40_000, 20_000)
        self.is_clock(signals["slowly"], 32_500, 50_000, 25_000)
        self.assertEqual(traced, self.play())


run()
