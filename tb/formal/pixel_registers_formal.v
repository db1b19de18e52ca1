// pixel_registers_formal.v - the picture changes only at the frame's end, and only when asked.
//
// By 2-step induction; every write, at any time, with any strobes.

`default_nettype none

module pixel_registers_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        we_i,
    input wire [3:0]  wstrb_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire        frame_end_i
);
    wire [31:0] front;

    pixel_registers dut (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(12'd0), .wdata_i(wdata_i), .re_i(1'b0), .resampler_re_i(1'b0), .rdata_o(),
        .frame_end_i(frame_end_i), .front_o(front), .enable_o()
    );

    reg         live = 1'b0, ran_q = 1'b0;
    reg         asked_q, asked_was_q, end_q;   // BUFFER was written and no frame has ended since
    wire [31:0] dut__back_q;
    wire        dut__swap_q;
    reg  [31:0] front_q, back_q;
    wire        ask = we_i && waddr_i[3:0] == 4'h0 && wstrb_i != 4'd0;

    always @(posedge clk_i) begin
        live        <= 1'b1;
        ran_q       <= !rst_i;
        front_q     <= front;
        back_q      <= dut__back_q;
        end_q       <= frame_end_i;
        asked_was_q <= asked_q;
        asked_q     <= !rst_i && (ask || (asked_q && !frame_end_i));
    end
    always @(*) if (!live) assume (rst_i);

    always @(*) if (live) begin
        i_asked: assert (dut__swap_q == asked_q);
        if (ran_q) begin
            a_only_at_frame_end: assert (front == front_q || end_q);
            a_only_when_asked:   assert (front == front_q || asked_was_q);
            a_swaps:             assert (!(end_q && asked_was_q) || front == back_q);
        end
    end
endmodule

`default_nettype wire
