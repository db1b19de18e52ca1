// vga_timing_twin_formal.v - sim/fpga/vga_timing.v has the beam where rtl/vga/vga_timing.v has it
//
// By induction, from any place of the beam; resets are unconstrained.

`default_nettype none

module vga_timing_twin_formal (
    input wire clk_i,
    input wire rst_i
);
    wire [33:0] plain_pins, twin_pins;
    wire        plain_blank, twin_blank;

    vga_timing plain (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(plain_pins[9:0]), .v_o(plain_pins[19:10]),
        .v_next_o(plain_pins[29:20]), .line_end_o(plain_pins[30]), .visible_o(plain_pins[31]),
        .hs_no(plain_pins[32]), .vs_no(plain_pins[33]), .blank_no(plain_blank)
    );
    vga_timing_twin twin (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(twin_pins[9:0]), .v_o(twin_pins[19:10]),
        .v_next_o(twin_pins[29:20]), .line_end_o(twin_pins[30]), .visible_o(twin_pins[31]),
        .hs_no(twin_pins[32]), .vs_no(twin_pins[33]), .blank_no(twin_blank)
    );

    wire [29:0] twin__now;
    wire        live;
    numbered_clocks clocks (.clk_i(clk_i), .now_i(twin__now), .live_o(live));
    always @(*) if (!live) assume (rst_i);

    always @(*) if (live) begin
        a_pins:  assert (twin_pins == plain_pins);
        a_blank: assert (twin_blank == plain_blank);
    end
endmodule

`default_nettype wire
