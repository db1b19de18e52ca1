// vga_timing_formal.v - sync positions, blanking, totals of the VGA's beam
//
// By 3-step induction, so from any place of the beam.
// The numbers are VESA DMT's for 640 x 480 at 60 Hz; VS moves where HS begins.

`default_nettype none

module vga_timing_formal (
    input wire clk_i,
    input wire rst_i
);
    wire [9:0] h, v;
    wire [8:0] row_next;
    wire       line_end, hs_n, vs_n, shown;

    vga_timing dut (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(h), .v_o(v), .line_end_o(line_end),
        .row_next_o(row_next), .hs_no(hs_n), .vs_no(vs_n), .shown_o(shown)
    );

    reg       live = 1'b0, moved_q = 1'b0;
    reg [9:0] h_q, v_q;
    always @(posedge clk_i) begin
        live    <= 1'b1;
        moved_q <= !rst_i;
        h_q     <= h;
        v_q     <= v;
    end
    always @(*) if (!live) assume (rst_i);

    // VS is low from HS before line 490 begins up to HS before line 492 begins.
    wire vs_low = (v == 10'd489 && h >= 10'd656) || v == 10'd490
                  || (v == 10'd491 && h < 10'd656);
    always @(*) if (live) begin
        a_in_frame:  assert (h < 10'd800 && v < 10'd525);
        a_hs:        assert (hs_n == !(h >= 10'd656 && h < 10'd752));
        a_vs:        assert (vs_n == !vs_low);
        a_shown:     assert (shown == (h < 10'd640 && v < 10'd480));
        a_line_end:  assert (line_end == (h == 10'd799));
        a_row_next:  assert (row_next == (v == 10'd524 ? 9'd0 : (v + 10'd1) >> 1));
        if (moved_q) begin
            a_line_total:  assert (h == (h_q == 10'd799 ? 10'd0 : h_q + 10'd1));
            a_frame_total: assert (v == (h_q != 10'd799 ? v_q : v_q == 10'd524 ? 10'd0
                                         : v_q + 10'd1));
        end
    end
endmodule

`default_nettype wire
