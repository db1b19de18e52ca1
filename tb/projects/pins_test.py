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
    return f"press: {{switch: {n}, for: %s, bounce: 0ns}}", 1 << 72 + n


def button(n):
    return f"press-button: {{button: b{n}, for: %s}}", 1 << n


class Pins(Case):
    def heard(self, *steps, parts="", arguments=()):
        """Time in ns and mask of each change."""
        self.write(top_v=LISTENER)
        done = self.plays(*steps, parts=parts, arguments=arguments)
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

    def test_a_switch_bounces_until_it_stays(self):
        heard = self.heard("delay: 1us", "hold: {switch: 3}", "delay: 5ms", "release: {switch: 3}",
                           "delay: 5ms")
        self.assertEqual({mask for _, mask in heard}, {1 << 75})
        on, off = ([time for time, _ in heard if begin < time <= begin + 500_100]
                   for begin in (1_000, 5_001_000))
        self.assertEqual(len(on) + len(off), len(heard))
        for moves in on, off:
            self.assertGreaterEqual(len(moves), 3)
            self.assertEqual(len(moves) % 2, 1)

    def test_a_switch_that_was_on_before_power_does_not_bounce(self):
        self.assertEqual(self.heard("hold: {switch: 3}", "delay: 5ms"), [])

    def test_pulses_are_heard_in_waveforms_as_without(self):
        steps, expected = self.pulses(5)
        heard = self.heard(*steps, parts=self.BUTTONS, arguments=["--trace", "w.fst"])
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


class Ps2(Case):
    # Sends a byte, awaits one; samples the wires every `period` clocks.
    HOST = """\
module host(input clk, inout ps2c, ps2d, input go, input [7:0] command, input [9:0] period,
            output reg done = 0, output reg [7:0] answer);
    reg c_low = 0, d_low = 0, c = 1, c_was = 1, sends = 0;
    reg [9:0] wait_q = 0;
    reg [22:0] timer = 0;
    reg [3:0] edges = 0;
    reg [10:0] frame;
    wire tick = wait_q == 0, falls = tick && c_was && !c;
    wire right = !frame[1] && ^frame[10:2] && ps2d;  // start, parity, stop
    assign ps2c = c_low ? 1'b0 : 1'bz;
    assign ps2d = d_low ? 1'b0 : 1'bz;
    always @(posedge clk) begin
        wait_q <= tick ? period : wait_q - 1;
        if (tick) begin c <= ps2c; c_was <= c; end
        done <= 0;
        timer <= timer + 1;
        if (go) begin
            {c_low, sends, edges, timer} <= {1'b1, 1'b1, 4'd0, 23'd0};
            frame <= {1'b1, ~^command, command, 1'b0};
        end else if (c_low) begin
            if (timer == 3100) {c_low, d_low} <= 2'b01;  // 62 us
        end else if (falls) begin
            edges <= edges == 10 ? 0 : edges + 1;
            if (sends) begin
                d_low <= edges < 9 && !frame[edges + 1];
                if (edges == 10) sends <= 0;
            end else begin
                frame <= {ps2d, frame[10:1]};
                if (edges == 10) begin done <= 1; answer <= right ? frame[9:2] : 8'h0; end
            end
        end else if (timer == 1000000) begin  // 20 ms
            done <= 1; answer <= 8'h0; d_low <= 0;
        end
    end
endmodule
"""
    TOP = """\
module top(input CLOCK_50, inout PS2_CLK, PS2_DAT, PS2_CLK2, PS2_DAT2);
    reg [25:0] begins = 0;
    reg [31:0] chance = 1, pause = 2;
    reg [15:0] sent = 0, answered = 0;
    reg port = 0, waits = 0;
    wire [1:0] done;
    wire [7:0] answer [1:0];
    wire go = !waits && pause == 1;
    wire mouse = port ^ %d;
    wire [9:0] period = chance[19:16] == 0 ? 0 : chance[15:0] %% 300;  // up to 6 us
    host a(CLOCK_50, PS2_CLK, PS2_DAT, go && !port, mouse ? 8'hE6 : 8'hEE, period, done[0],
           answer[0]);
    host b(CLOCK_50, PS2_CLK2, PS2_DAT2, go && port, mouse ? 8'hE6 : 8'hEE, period, done[1],
           answer[1]);
    always @(posedge CLOCK_50)
        if (begins != 27500000) begins <= begins + 1;  // 550 ms: the devices' tests
        else if (waits) begin
            if (done[port]) begin
                answered <= answered + (answer[port] == (mouse ? 8'hFA : 8'hEE));
                waits <= 0;
                port <= ~port;
                pause <= 2500 + chance %% (1 << chance[31:28]);
                chance <= {chance[30:0], chance[31] ^ chance[21] ^ chance[1] ^ chance[0]} * 5 + 1;
                if (sent == %d) begin
                    $display("answered %%0d of %%0d", answered
                             + (answer[port] == (mouse ? 8'hFA : 8'hEE)), sent);
                    $finish;
                end
            end
        end else begin
            pause <= pause - 1;
            if (go) begin waits <= 1; sent <= sent + 1; end
        end
endmodule
"""

    def answered(self, devices, mouse_first, commands):
        self.write(host_v=self.HOST, top_v=self.TOP % (mouse_first, commands),
                   s_yaml=f"name: s\nversion: 1\nps2: [{devices}]\nsteps:\n  - delay: 3600s\n")
        done = self.de1sim("run", "s.yaml", "--project", ".", "--top", "top", "--frames", "none")
        return done.stdout.splitlines()[:1]

    def test_every_command_is_answered(self):
        self.assertEqual(self.answered("keyboard, mouse", False, 20), ["answered 20 of 20"])
        self.assertEqual(self.answered("mouse, keyboard", True, 20), ["answered 20 of 20"])


if __name__ == "__main__":
    run()
