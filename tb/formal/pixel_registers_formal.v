// pixel_registers_formal.v - the picture changes only with swap_i, and only when asked.
//
// By 3-step induction; every write and read, at any time, with any strobes.  STATUS: what was
// written last, in its writable bit.

`default_nettype none

module pixel_registers_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        we_i,
    input wire [3:0]  wstrb_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire        re_i,
    input wire [11:0] raddr_i,
    input wire        swap_i
);
    localparam [31:0] STATUS = 32'h08090f04;

    wire [31:0] front, rdata;
    wire        enable;

    pixel_registers #(.STATUS(STATUS)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(raddr_i), .wdata_i(wdata_i), .re_i(re_i), .resampler_re_i(1'b0), .rdata_o(rdata),
        .swap_i(swap_i), .front_o(front), .enable_o(enable)
    );

    reg         live = 1'b0, ran_q = 1'b0;
    reg         asked_q, asked_was_q, end_q;   // BUFFER was written and no swap_i has come since
    wire [31:0] dut__back_q;
    wire        dut__swap_q;
    reg  [31:0] front_q, back_q;
    wire        ask = we_i && waddr_i[3:0] == 4'h0 && wstrb_i != 4'd0;
    wire        back = we_i && waddr_i[3:0] == 4'h4;
    reg         enable_q, read_q;              // as written; STATUS was asked for
    reg  [31:0] status_q;                      // one clock ago

    always @(posedge clk_i) begin
        live        <= 1'b1;
        ran_q       <= !rst_i;
        front_q     <= front;
        back_q      <= dut__back_q;
        end_q       <= swap_i && !back;
        asked_was_q <= asked_q;
        asked_q     <= !rst_i && (ask || (asked_q && !swap_i));
        if (we_i && waddr_i[3:0] == 4'hc && wstrb_i[0]) enable_q <= wdata_i[2];
        if (rst_i) enable_q <= 1'b1;
        read_q      <= re_i && raddr_i[3:0] == 4'hc;
        status_q    <= {STATUS[31:3], enable_q, 1'b0, asked_q};
    end
    always @(*) if (!live) assume (rst_i);

    always @(*) if (live) begin
        i_asked: assert (dut__swap_q == asked_q);
        a_enable: assert (enable == enable_q);
        if (ran_q) begin
            a_only_with_swap: assert (front == front_q || end_q);
            a_only_when_asked:   assert (front == front_q || asked_was_q);
            a_status:            assert (!read_q || rdata == status_q);
            a_swaps:             assert (!(end_q && asked_was_q) || front == back_q);
        end
    end
endmodule

`default_nettype wire
