// audio_clock.v - the codec's clock and the audio block's, by a PLL of their own
//
//   refclk_i, 50 MHz --> altera_pll --> xck_o, 12.288 MHz --> / 12 or / 2 --> clk_o, 128 * RATE
//   PLL locked, rst_ni high --> reset_sync --> rst_o, synchronous to clk_o
//
// This clock is asynchronous to the fabric's: 12.288 MHz to 25 MHz is 1,536 to 3,125.

`default_nettype none

module audio_clock #(
    parameter RATE = 8000   // samples per second: 8000 or 48000
) (
    input  wire refclk_i,
    input  wire rst_ni,     // asynchronous, active low
    output wire xck_o,
    output wire clk_o,
    output wire rst_o
);
    localparam [2:0] HALF_LAST = RATE == 48000 ? 3'd0 : 3'd5;   // periods of XCK, less one

    wire xck, locked;

    assign xck_o = xck;

    altera_pll #(
        .reference_clock_frequency ("50.0 MHz"),
        .operation_mode            ("direct"),
        .fractional_vco_multiplier ("true"),
        .number_of_clocks          (1),
        .output_clock_frequency0   ("12.288000 MHz"),
        .phase_shift0              ("0 ps"),
        .duty_cycle0               (50),
        .pll_type                  ("General"),
        .pll_subtype               ("General")
    ) pll (
        .refclk   (refclk_i),
        .rst      (1'b0),
        .fbclk    (1'b0),
        // verilator lint_off PINCONNECTEMPTY
        .fboutclk (),
        // verilator lint_on PINCONNECTEMPTY
        .outclk   (xck),
        .locked   (locked)
    );

    // Its phase does not matter, so it has no reset.
    reg       clk_q   = 1'b0;
    reg [2:0] count_q = 3'd0;

    assign clk_o = clk_q;

    always @(posedge xck) begin
        count_q <= count_q == HALF_LAST ? 3'd0 : count_q + 3'd1;
        if (count_q == HALF_LAST) clk_q <= !clk_q;
    end

    reset_sync reset_sync (.clk_i(clk_q), .rst_ni(locked && rst_ni), .rst_o(rst_o));
endmodule

`default_nettype wire
