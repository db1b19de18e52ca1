"""headers_test.py DE1SIM FOLDER [CASE...] - the headers, and parts on their pins."""
from case import Case, run


class Headers(Case):
    def test_all_36_pins_of_both(self):
        """Each pin of GPIO_1 is the opposite of GPIO_0's."""
        self.write(top_v="module top(input [35:0] GPIO_0, output [35:0] GPIO_1);\n"
                         "assign GPIO_1 = ~GPIO_0; endmodule\n")
        self.plays("set-pins: {gpio_0: [0, 2, 16, 18, 35], level: low}",
                   "set-pins: {jp1: 3, level: low}", "delay: 1ms",  # pin 5
                   "expect-pins: {gpio_1: [0, 2, 5, 16, 18, 35], level: high}",
                   f"expect-pins: {{gpio_1: {[1, 3, 4, *range(6, 16), 17, *range(19, 35)]}, "
                   "level: low}")
        self.assertEqual(self.report()["shown"]["gpio_1"]["levels"], "0x800050025")

    def test_inputs_and_outputs_on_one_header(self):
        """By pin locations: GPIO_0[1:0] are inputs, [3:2] outputs under another port's name."""
        pins = {"keys[0]": "AC18", "keys[1]": "Y17", "lamps[0]": "AD17", "lamps[1]": "Y18"}
        self.write(p_qsf="set_global_assignment -name TOP_LEVEL_ENTITY top\n" + "".join(
                       f"set_location_assignment PIN_{pin} -to {port}\n"
                       for port, pin in pins.items()),
                   top_v="module top(input [1:0] keys, output [1:0] lamps);\n"
                         "assign lamps = ~keys; endmodule\n")
        self.plays("set-pins: {gpio_0: 0, level: low}", "delay: 1us",
                   "expect-pins: {gpio_0: [1, 2], level: high}",
                   "expect-pins: {gpio_0: [0, 3], level: low}",
                   "set-pins: {gpio_0: [0, 1], level: low}", "delay: 1us",
                   "expect-pins: {gpio_0: [2, 3], level: high}")

    def test_the_arduino_header_of_the_boards_that_have_it(self):
        """A button and an LED on it, steps, and the report; the DE1-SoC has none."""
        steps = ("expect-pins: {arduino_io: [3, 15], level: low}",
                 "expect-led: {led: answer, equals: dark}", "hold-button: ask",
                 "expect-led: {led: answer, equals: lit, timeout: 1ms}",
                 "release-button: ask", "set-pins: {arduino_io: 2, level: low}", "delay: 1us",
                 "expect-pins: {arduino_io: 15, level: high}")
        parts = ('  - button: {name: ask, pin: "ARDUINO_IO[0]"}\n'
                 '  - led: {name: answer, pin: "ARDUINO_IO[3]"}\n')
        self.write(top_v="module top(inout [15:0] ARDUINO_IO);\n"
                         "assign ARDUINO_IO[3] = ~ARDUINO_IO[0];\n"
                         "assign ARDUINO_IO[15] = ~ARDUINO_IO[2]; endmodule\n")
        for board in ("DE10-Nano", "DE10-Lite"):
            self.plays(*steps, parts=parts, arguments=("--board", board))
            shown = self.report()["shown"]["arduino_io"]
            self.assertEqual((shown["levels"], shown["outputs"]), ("0xFFF3", "0x0008"), board)
        done = self.de1sim("run", "s.yaml")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "s.yaml:4:5: expected pins of the DE1-SoC, got ARDUINO_IO[0], which "
                             "it has not\n"))


class Parts(Case):
    def test_on_the_same_header(self):
        """A button and a switch on an inout header, an LED that is dimmed, and a matrix."""
        self.write(top_v="module top(input CLOCK_50, inout [35:0] GPIO_0, output [15:0] GPIO_1);\n"
                         "reg [19:0] n = 0; always @(posedge CLOCK_50) n <= n + 1;\n"
                         "assign GPIO_0[5] = n[2:0] == 0;\n"
                         "assign GPIO_1[7:0] = 8'h80 >> n[17:15];\n"
                         "assign GPIO_1[15:8] = ~(8'h80 >> n[17:15] | {8{!GPIO_0[3]}} & 8'h01\n"
                         "  | {8{GPIO_0[2]}} & 8'h80);\nendmodule\n")
        rows = ["." * n + "#" + "." * (7 - n) for n in range(8)]
        left = ["#" + row[1:] for row in rows]
        both = [row[:-1] + "#" for row in left]

        def expect(picture):
            text = "\\n".join(picture)
            return f'expect-matrix: {{matrix: face, equals: "{text}", timeout: 1s}}'
        self.plays(expect(rows), "expect-led: {led: heart, equals: lit}",
                   "set-switch: {switch: mode, level: high}", expect(left), "hold-button: fire",
                   expect(both), "release-button: fire", expect(left),
                   parts="  - button: {name: fire, pin: \"GPIO_0[3]\"}\n"
                         "  - switch: {name: mode, pin: \"GPIO_0[2]\"}\n"
                         "  - led: {name: heart, pin: \"GPIO_0[5]\"}\n"
                         "  - led-matrix: {name: face, rows: \"GPIO_1[7:0]\", "
                         "columns: \"GPIO_1[15:8]\"}\n")
        self.assertEqual(self.report()["parts"]["face"]["rows"], left)

    def test_a_terminal_at_a_megabaud(self):
        """The design answers each letter with that of the other case."""
        self.write(top_v="""\
module top(input CLOCK_50, inout [35:0] GPIO_0);
reg [2:0] last = 7;
reg [8:0] t = 0;
reg [7:0] in;
reg [9:0] out = 10'h3ff;
reg [5:0] n = 0;
assign GPIO_0[1] = out[0];
always @(posedge CLOCK_50) begin
  last <= {last[1:0], GPIO_0[3]};
  if (t) t <= t - 1;
  else if (!last[2]) t <= 475;  // to the middle of the stop bit, of 50 clocks
  if (t && t % 50 == 0 && t <= 400) in <= {last[2], in[7:1]};
  if (t == 1) begin out <= {1'b1, in ^ 8'h20, 1'b0}; n <= 50; end
  else if (n == 1) begin out <= {1'b1, out[9:1]}; n <= 50; end
  else if (n) n <= n - 1;
end
endmodule
""")
        self.plays("delay: 1ms", "type-serial: {text: Hello, to: t}",
                   "wait-serial: {text: hELLO, on: t, timeout: 1ms}",
                   parts="  - terminal: {name: t, rx: \"GPIO_0[1]\", tx: \"GPIO_0[3]\", "
                         "baud: 1000000}\n")
        self.assertEqual(self.report()["parts"]["t"], {"received": "hELLO", "lost": 0})

    def test_the_keypad_elsewhere(self):
        """On GPIO_1[7:0]: the last column is low, and B is in its second row."""
        self.write(top_v="module top(inout [7:0] GPIO_1, output [9:0] LEDR);\n"
                         "assign GPIO_1[7:4] = 4'b1110; assign LEDR = GPIO_1; endmodule\n")
        self.plays("delay: 1ms", 'expect-leds: "0011101111"',
                   "hold: {keypad: B}", "delay: 45ms", 'expect-leds: "0011101011"',
                   "release: {keypad: B}", "delay: 45ms", 'expect-leds: "0011101111"',
                   "hold: {keypad: \"5\"}", "delay: 45ms", 'expect-leds: "0011101111"',
                   parts="  - keypad: GPIO_1[7:0]\n")

    def test_two_drivers_are_reported_once(self):
        self.write(top_v="module top(output [35:0] GPIO_0); assign GPIO_0 = 36'h8; endmodule\n")
        done = self.plays("delay: 1ms", "set-switch: {switch: a, level: high}", "delay: 1ms",
                          "set-switch: {switch: a, level: low}", "delay: 1ms",
                          parts="  - switch: {name: a, pin: \"GPIO_0[3]\"}\n")
        self.assertEqual(done.stderr.count("GPIO_0[3] is driven high and low at once"), 1)


if __name__ == "__main__":
    run()
