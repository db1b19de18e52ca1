// vga_timing_formal.v - sync positions, blanking, totals of the VGA's beam
//
// By 6-step induction, so from any position of the beam.  The numbers are VESA DMT's for 640 x 480
// at 60 Hz; VS moves where HS begins.  The pins follow the beam four clocks later.

`default_nettype none

module vga_timing_formal (
    input wire clk_i,
    input wire rst_i
);
    wire [9:0] h, v, v_next;
    wire       line_end, visible, hs_n, vs_n, blank_n;

    vga_timing dut (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(h), .v_o(v), .line_end_o(line_end),
        .v_next_o(v_next), .visible_o(visible), .hs_no(hs_n), .vs_no(vs_n),
        .blank_no(blank_n)
    );

    // VS is low from HS before line 490 begins up to HS before line 492 begins.
    wire hs_low = h >= 10'd656 && h < 10'd752;
    wire vs_low = (v == 10'd489 && h >= 10'd656) || v == 10'd490
                  || (v == 10'd491 && h < 10'd656);
    wire shown  = h < 10'd640 && v < 10'd480;

    reg       live = 1'b0, moved_q = 1'b0;
    reg [9:0] h_q, v_q;
    reg [3:0] hs_low_q, vs_low_q, shown_q;   // of 1 to 4 clocks before
    always @(posedge clk_i) begin
        live     <= 1'b1;
        moved_q  <= !rst_i;
        h_q      <= h;
        v_q      <= v;
        hs_low_q <= rst_i ? 4'd0 : {hs_low_q[2:0], hs_low};
        vs_low_q <= rst_i ? 4'd0 : {vs_low_q[2:0], vs_low};
        shown_q  <= rst_i ? 4'd0 : {shown_q[2:0], shown};
    end
    always @(*) if (!live) assume (rst_i);

    always @(*) if (live) begin
        a_in_frame:  assert (h < 10'd800 && v < 10'd525);
        a_hs:        assert (hs_n == !hs_low_q[3]);
        a_vs:        assert (vs_n == !vs_low_q[3]);
        a_blank:     assert (blank_n == shown_q[3]);
        a_visible:   assert (visible == shown_q[2]);
        a_line_end:  assert (line_end == (h == 10'd799));
        a_v_next:    assert (v_next == (v == 10'd524 ? 10'd0 : v + 10'd1));
        if (moved_q) begin
            a_line_total:  assert (h == (h_q == 10'd799 ? 10'd0 : h_q + 10'd1));
            a_frame_total: assert (v == (h_q != 10'd799 ? v_q : v_q == 10'd524 ? 10'd0
                                         : v_q + 10'd1));
        end else begin
            a_begins_with_the_blanking: assert (h == 10'd0 && v == 10'd480);
        end
    end
endmodule

`default_nettype wire
