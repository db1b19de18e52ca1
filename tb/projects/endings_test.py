"""endings_test.py DE1SIM FOLDER [CASE...] - how a design begins, ends a run, or breaks it."""
import json
import re

from case import Case, run

HEAD = "module top(input CLOCK_50, input [3:0] KEY, input [9:0] SW, output [9:0] LEDR);\n"
SCENARIO = """name: x
version: 1
steps:
  - delay: 1ms
  - hold: {switch: 0}
  - delay: 1ms
  - expect-leds: "0000000001"
"""


class Endings(Case):
    def played(self, body, code, *words):
        self.write(top_v=HEAD + body + "endmodule\n", s_yaml=SCENARIO)
        done = self.de1sim("run", "s.yaml", "--project", ".", *words)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertNotIn("Abort", done.stdout + done.stderr)
        return done

    def report(self):
        return json.loads((self.folder / "out" / "report.json").read_text())

    def test_an_oscillation_names_its_signals_and_the_time(self):
        done = self.played("wire a, b; assign a = b ^ SW[0]; assign b = a;\n"
                           "wire [1:0] still = {still[0], SW[1]}; assign LEDR = {still, a};\n", 2)
        said = [line for line in done.stderr.splitlines() if "oscillates" in line]
        self.assertEqual(len(said), 1, done.stderr)
        self.assertRegex(said[0], r"the design oscillates: .*[ab] \(top.v:2\).*, at 0\.00100")
        self.assertIn("oscillates", self.report()["faults"][0])

    def test_an_oscillation_from_the_beginning(self):
        done = self.played("wire a; assign a = ~a; assign LEDR = a;\n", 2)
        self.assertIn("a (top.v:2) depends on itself without a register, at 0.000000000 s",
                      done.stderr)

    def test_an_oscillation_that_an_output_is_part_of(self):
        done = self.played("ring r(LEDR[0]); endmodule\nmodule ring(output reg q);\n"
                           "initial q = 0;\nalways begin #10; q = ~q; end\n", 2)
        self.assertIn("the design oscillates: q (top.v:5) depends on itself", done.stderr)
        self.assertNotIn("de1sim_chip", done.stderr)

    def test_a_clock_that_its_own_register_makes(self):
        done = self.played("reg q; always @(posedge c) q <= ~q; wire c = q ^ SW[0] ^ t;\n"
                           "reg t; always @(negedge c) t <= ~t; assign LEDR = c;\n", 2)
        self.assertIn("the design oscillates: ", done.stderr)

    def test_stop(self):
        done = self.played("always @(posedge SW[0]) $stop; assign LEDR = 5;\n", 1)
        self.assertIn("top.v:2: the design has stopped the run ($stop, $error or $fatal), at 0.001",
                      done.stderr)
        self.assertIn("LEDR 0000000101", done.stdout)
        self.assertEqual(self.report()["end"], "stopped by the design")

    def test_error_and_fatal(self):
        for call in '$error("bad %0d", SW)', '$fatal(1, "bad %0d", SW)', "$fatal":
            done = self.played(f"always @(posedge SW[0]) {call};\nassign LEDR = 5;\n", 1)
            self.assertIn("top.v:2: the design has stopped the run", done.stderr)
            self.assertEqual(done.stdout.count("bad 1"), call.count("bad"))

    def test_time_is_in_the_units_of_the_timescale(self):
        """As ModelSim has it, 1 ns where there is none; %t is in what Verilator counts, 1 ps."""
        show = 'always @(posedge SW[0]) $display("at %0d, %0t", $time, $time);\nassign LEDR = 1;\n'
        for scale, expected in (("", 1000040), ("`timescale 1us/1ns\n", 1000),
                                ("`timescale 1ps/1ps\n", 1000040000)):
            self.write(top_v=scale + HEAD + show + "endmodule\n", s_yaml=SCENARIO)
            done = self.de1sim("run", "s.yaml", "--project", ".")
            at, picoseconds = (int(n) for n in re.search(r"at (\d+), (\d+)", done.stdout).groups())
            self.assertLess(abs(picoseconds - 1_000_040_000), 1_000_000, scale)
            self.assertLess(abs(at - expected), 1 + expected / 1000, scale)

    def test_finish_ends_the_run_and_display_comes_before(self):
        """What was expected for later is not met."""
        done = self.played('initial $display("first");\n'
                           'always @(posedge SW[0]) begin $display("SW %b", SW); $finish; end\n'
                           "assign LEDR = 5;\n", 1)
        self.assertIn("top.v:3: $finish, at 0.001", done.stderr)
        self.assertLess(done.stdout.index("first"), done.stdout.index("SW 0000000001"))
        self.assertLess(done.stdout.index("SW 0000000001"), done.stdout.index("LEDR"))

    def test_finish_after_all_that_was_expected(self):
        self.write(top_v=HEAD + "initial $finish; assign LEDR = 5; endmodule\n",
                   s_yaml="name: x\nversion: 1\nsteps: [delay: 100s]\n")
        done = self.de1sim("run", "s.yaml", "--project", ".")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(self.report()["simulated_s"], 1)

    def test_waveforms_have_each_time_once(self):
        done = self.played("assign LEDR = ~{9'h1ff, ~SW[0]};\n", 0, "--trace", "x.fst")
        self.assertNotIn("previous dump", done.stdout + done.stderr)


class Beginning(Case):
    def test_what_is_1_has_not_risen(self):
        self.write(top_v=HEAD + "wire x = ~SW[0]; reg [1:0] n, k; reg [2:0] m;\n"
                   "always @(posedge x) n <= n + 1;\n"
                   "wire y = &KEY; always @(posedge y) k <= k + 1;\n"
                   "always @(negedge KEY[0]) m <= m + 1;\n"
                   "reg r = 1; wire q = ~r; reg s = 0; always @(negedge q) s <= 1;\n"
                   "assign LEDR = {s, m, k, n}; endmodule\n")
        self.leds(0)
        self.leds(0, 1)

    def test_a_bit_of_a_header_that_is_1_has_not_risen(self):
        self.write(top_v="module top(inout [35:0] GPIO_0, inout PS2_DAT, output [9:0] LEDR);\n"
                   "reg [3:0] n, k; always @(posedge GPIO_0[4]) n <= n + 1;\n"
                   "always @(posedge PS2_DAT) k <= k + 1;\n"
                   "reg a, b; always @(posedge GPIO_0[3]) a <= 1;\n"
                   "always @(negedge GPIO_0[2]) b <= 1;\n"
                   "assign LEDR = {a, b, k, n}; endmodule\n")
        pulse = [f"set-pins: {{gpio_0: 4, level: {level}}}" for level in ("low", "high")]
        self.plays("delay: 1ms", 'expect-leds: "0000000000"', *pulse * 3, "delay: 1ms",
                   'expect-leds: "0000000011"')


if __name__ == "__main__":
    run()
