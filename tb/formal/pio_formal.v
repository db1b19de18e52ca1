// pio_formal.v - the interrupt is high exactly while an edge that was not cleared is unmasked.
//
// By induction (4 clocks), at 4 bits with outputs; addresses, strobes, data and pins are free.

`default_nettype none

module pio_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        we_i,
    input wire [3:0]  wstrb_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire [3:0]  pins_i
);
    wire irq;

    pio #(.WIDTH(4)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(12'd0), .wdata_i(wdata_i), .re_i(1'b0), .rdata_o(), .irq_o(irq),
        .pins_i(pins_i), .pins_o(), .oe_o()
    );

    // ---- The reference: bit by bit, from the manual's words ----
    reg       live = 1'b0;
    reg [3:0] pin1_q, pin2_q, pin3_q, mask_q, pending_q;
    wire      write = we_i && wstrb_i[0];
    integer   i;

    always @(posedge clk_i) begin
        live   <= 1'b1;
        pin1_q <= pins_i;
        pin2_q <= pin1_q;
        pin3_q <= rst_i ? 4'd0 : pin2_q;
        for (i = 0; i < 4; i = i + 1) begin
            if (write && waddr_i[3:0] == 4'h8) mask_q[i] <= wdata_i[i];
            if (write && waddr_i[3:0] == 4'hc && wdata_i[i]) pending_q[i] <= 1'b0;
            else if (pin3_q[i] && !pin2_q[i]) pending_q[i] <= 1'b1;
        end
        if (rst_i) begin
            mask_q    <= 4'd0;
            pending_q <= 4'd0;
        end
    end
    always @(*) if (!live) assume (rst_i);

    reg [1:0] age_q = 2'd0;                  // the synchroniser has no reset
    always @(posedge clk_i) if (age_q != 2'd3) age_q <= age_q + 2'd1;

    // ---- What must hold, and the invariants ----
    wire [3:0] dut__edge_q, dut__mask_q, dut__data_was_q, dut__data;
    reg        settled_q = 1'b0;             // a reset after the synchroniser has filled
    always @(posedge clk_i) if (age_q == 2'd3 && rst_i) settled_q <= 1'b1;

    always @(*) if (settled_q) begin
        i_age: assert (age_q == 2'd3);
        a_irq: assert (irq == ((pending_q & mask_q) != 4'd0));
        i_mask: assert (dut__mask_q == mask_q);
        i_edge: assert (dut__edge_q == pending_q);
        i_data: assert (dut__data == pin2_q && dut__data_was_q == pin3_q);
    end
endmodule

`default_nettype wire
