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
    reg  [29:0] now_q;
    reg         live = 1'b0;
    always @(posedge clk_i) begin
        live  <= 1'b1;
        now_q <= twin__now;
    end
    always @(*)
        if (!live) assume (rst_i);
        else assume (twin__now == now_q + 30'd1);

    always @(*) if (live) begin
        a_pins:  assert (twin_pins == plain_pins);
        a_blank: assert (twin_blank == plain_blank);
    end
endmodule

// The number of the clock, which the harness bounds.
module clock_number (output wire [29:0] now_o);
    (* anyseq *) reg [29:0] number;
    assign now_o = number;
endmodule

`default_nettype wire
