// open_pll.v - replaces a PLL in tools without one: 25 MHz is CLOCK_50 divided by two
//
// 12.288 MHz becomes 12.5 MHz, so sound is 1.7 % too fast.  The other parameters are ignored.

`default_nettype none
// verilator lint_off DECLFILENAME
// verilator lint_off UNUSED

module altera_pll #(
    parameter reference_clock_frequency = "", operation_mode = "", fractional_vco_multiplier = "",
              number_of_clocks = 1, output_clock_frequency0 = "", phase_shift0 = "",
              duty_cycle0 = 50, pll_type = "", pll_subtype = ""
) (
    input  wire refclk,
    input  wire rst,
    input  wire fbclk,
    output wire fboutclk,
    output reg  outclk,
    output wire locked
);
    localparam SLOW = output_clock_frequency0 == "12.288000 MHz";

    reg half_q = 1'b0;

    initial outclk = 1'b0;
    always @(posedge refclk) begin
        half_q <= !half_q;
        if (half_q || !SLOW) outclk <= !outclk;
    end
    assign fboutclk = 1'b0;
    assign locked   = 1'b1;
endmodule

`default_nettype wire
