"""pins_test.py DE1SIM FOLDER [CASE...] - what crosses the pins has its time: pulses and bits."""
import itertools
import random

from case import DE1SIM, Case, run

CLOCK = 20  # ns

# Says whenever its inputs are others than at the clock before, and when: "120 3 ...".
LISTENER = """\
`timescale 1ns / 1ps
module top(input CLOCK_50, input [3:0] KEY, input [9:0] SW, inout [35:0] GPIO_0, GPIO_1,
           input IRDA_RXD);
    wire [86:0] now = {IRDA_RXD, KEY, SW, GPIO_0, GPIO_1};
    reg  [86:0] was = {87{1'b1}};
    always @(posedge CLOCK_50) begin
        was <= now;
        if (now != was) $display("%0d %h", $rtoi($realtime), now ^ was);
    end
endmodule
"""
IRDA = 1 << 86


def key(n):
    return f"press: {{key: {n}, for: %s}}", 1 << 82 + n


def switch(n):
    return f"press: {{switch: {n}, for: %s}}", 1 << 72 + n


def button(n):
    return f"press-button: {{button: b{n}, for: %s}}", 1 << n


class Pins(Case):
    def heard(self, *steps, parts="", words=()):
        """Time in ns and mask of each change."""
        self.write(top_v=LISTENER)
        parts = parts and "parts:\n" + parts
        self.write(s_yaml=f"name: s\nversion: 1\n{parts}steps:\n" +
                   "".join(f"  - {step}\n" for step in steps))
        done = self.de1sim("run", "s.yaml", "--project", ".", *words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        lines = [line.split() for line in done.stdout.splitlines() if line[:1].isdigit()]
        return [(int(time), int(mask, 16)) for time, mask in lines
                if int(time) > 10 * CLOCK]  # before, registers and wires come up

    BUTTONS = "".join(f"  - button: {{name: b{n}, pin: \"GPIO_1[{n}]\"}}\n" for n in range(4))

    def pulses(self, seed):
        """Steps that press each control for a clock, anywhere in a batch, and what is heard."""
        chance = random.Random(seed)
        controls = [*map(key, range(4)), *map(switch, range(10)), *map(button, range(4))] * 2
        chance.shuffle(controls)
        steps, changes, now = [], [], 0
        for press, mask in controls:
            pause = chance.choice([chance.randrange(CLOCK, 200), chance.randrange(40_000)])
            steps += [f"delay: {pause}ns", press % f"{CLOCK}ns"]
            now += pause
            edge = now // CLOCK * CLOCK + CLOCK
            changes += [(edge, mask), (edge + CLOCK, mask)]
            now += CLOCK
        heard = [(time, sum(mask for _, mask in both))  # a control moves when another comes back
                 for time, both in itertools.groupby(changes, lambda change: change[0])]
        return ["delay: 1us", *steps, "delay: 1us"], [(time + 1000, mask) for time, mask in heard]

    def test_pulses_of_one_clock_on_every_control_in_order(self):
        for seed in range(5):
            steps, expected = self.pulses(seed)
            self.assertEqual(self.heard(*steps, parts=self.BUTTONS), expected)

    def test_pulses_are_heard_in_waveforms_as_without(self):
        steps, expected = self.pulses(5)
        heard = self.heard(*steps, parts=self.BUTTONS, words=["--trace", "w.fst"])
        self.assertEqual(heard, expected)

    def test_pulses_of_one_clock_on_every_pin_of_the_headers(self):
        steps, expected, now = ["delay: 1us"], [], 1000
        for header, pin in itertools.product((0, 1), range(36)):
            pause = 23 + 91 * pin
            steps += [f"delay: {pause}ns", f"set-pins: {{gpio_{header}: {pin}, level: low}}",
                      f"delay: {CLOCK}ns", f"set-pins: {{gpio_{header}: {pin}, level: released}}"]
            now += pause
            edge = now // CLOCK * CLOCK + CLOCK
            mask = 1 << pin + (36 if header == 0 else 0)
            expected += [(edge, mask), (edge + CLOCK, mask)]
            now += CLOCK
        self.assertEqual(self.heard(*steps, "delay: 1us"), expected)

    def test_the_remotes_light_has_its_times(self):
        """NEC's frame from 2.0003 ms on: 9 ms of light, 4.5 of dark, 562.5 us of light per bit."""
        edges = self.heard("delay: 2000300ns", "press-remote: \"5\"", "delay: 100ms")
        self.assertEqual({mask for _, mask in edges}, {IRDA})
        self.assertEqual(len(edges), 2 * 34)
        times = [time - 2_000_300 for time, _ in edges]
        self.assertEqual(times[:3], [CLOCK, 9_000_000 + CLOCK, 13_500_000 + CLOCK])
        bits = [round((times[n + 2] - times[n]) / 562_500) for n in range(2, 66, 2)]
        self.assertEqual(set(bits), {2, 4})
        self.assertEqual(times[-1], 13_500_000 + 562_500 * (sum(bits) + 1) + CLOCK)


class Uart(Case):
    RECEIVER = """\
module top(input CLOCK_50, inout [35:0] GPIO_0);
    reg [5:0] count = 0;
    reg [3:0] bits = 0;
    reg [7:0] byte = 0;
    reg [1:0] rx = 2'b11;
    always @(posedge CLOCK_50) begin
        rx <= {rx[0], GPIO_0[7]};
        count <= count - 1;
        if (bits == 0) begin
            if (!rx[1]) begin bits <= 10; count <= 24; end
        end else if (count == 0) begin
            count <= 49;
            bits <= bits - 1;
            if (bits != 10 && bits != 1) byte <= {rx[1], byte[7:1]};
            if (bits == 1) $write("%s", rx[1] ? byte : "!");
        end
    end
endmodule
"""

    def test_a_megabaud_is_received(self):
        text = "The quick brown fox jumps over the lazy dog; 0123456789 ~UUU@@@\n"
        steps, level = ["delay: 1234567ns"], 1
        for byte in text.encode():
            for bit in [0, *(byte >> n & 1 for n in range(8)), 1]:
                if bit != level:
                    steps.append(f"set-pins: {{gpio_0: 7, level: {'high' if bit else 'low'}}}")
                level = bit
                steps.append("delay: 1us")
        self.write(top_v=self.RECEIVER)
        done = self.plays(*steps, "delay: 5us")
        self.assertTrue(done.stdout.startswith(text), done.stdout)


if __name__ == "__main__":
    run()
