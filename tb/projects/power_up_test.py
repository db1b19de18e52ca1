"""power_up_test.py DE1SIM FOLDER [CASE...] - what registers are when the chip powers up."""
from case import Case, run


class PowerUp(Case):
    def test_registers_power_up_at_zero_and_initial_counts(self):
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR); reg [4:0] a, b;\n"
                         "initial b = 5'd21; assign LEDR = {a, b}; endmodule\n")
        self.leds(21)

    def test_registers_power_up_as_their_asynchronous_reset_leaves_them(self):
        """Also where it never comes, and whatever `initial` says; without one, at 0."""
        self.write(top_v="""\
module top(input CLOCK_50, output [9:0] LEDR);
wire off = 1'b1;
reg a = 0, b, c, d = 1, e, f;
reg [1:0] m [0:3];
integer i;
(* keep *) reg s;
parameter [2:0] START = 3'b0110;  // too long
always @(posedge CLOCK_50 or negedge off) if (!off) a <= 1'b1; else a <= a;
always @(posedge CLOCK_50, negedge off)
  begin : two
    if (off == 1'b0) begin {b, c} <= START; end else b <= b;
    if (!off) begin d <= 0; for (i = 0; i < 4; i = i + 1) m[i] <= 2'd2; end
    if (s) e <= 1;
  end
always @(posedge CLOCK_50) if (s) f <= 1;
wire [1:0] chain;
genvar n;
generate for (n = 0; n < 1; n = n + 1) begin : g
  reg [1:0] r = 0;
  always @(posedge CLOCK_50 or negedge off)
    if (!off) r <= 2'b11; else r <= r;
  assign chain = r;
end endgenerate
assign LEDR = {a, b, c, d, e, f, m[3], chain};
endmodule
""")
        self.leds(0b1100001011)

    def test_a_reset_synchroniser_gives_a_pulse_without_a_reset(self):
        self.write(top_v="""\
module top(input CLOCK_50, output [9:0] LEDR);
wire reset;
reg [3:0] n;
sync sync(.reset_in(1'b0), .clk(CLOCK_50), .reset_out(reset));
always @(posedge CLOCK_50) if (reset) n <= 9;
assign LEDR = {reset, n};
endmodule
module sync(input reset_in, clk, output reset_out);
reg [1:0] chain; reg out;
always @(posedge clk or posedge reset_in)
  if (reset_in) begin chain <= {2{1'b1}}; out <= 1'b1; end
  else begin chain <= {1'b0, chain[1]}; out <= chain[0]; end
assign reset_out = out;
endmodule
""")
        self.leds(9)

    def test_a_variable_of_a_clocked_block_keeps_what_it_has(self):
        """Its value in the declaration is that at power-up."""
        self.write(top_sv="""
module top(input CLOCK_50, output logic [9:0] LEDR);
    always @(posedge CLOCK_50) begin
        reg [9:0] n = 10'd3, ended = 0;
        if (n != 20) begin
            logic [3:0] steps = 1;
            n = n + 1'b1;
            steps <= steps + 1'b1;
            ended <= {steps, 6'd0};
        end
        LEDR <= n | ended;
    end
endmodule
""")
        self.leds(20 | (1 + 16 & 15) << 6, wait="60ms")  # no lamp flickers any more


if __name__ == "__main__":
    run()
