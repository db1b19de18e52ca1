// axi_read_formal.v - one answer to each beat of a read: ID, data, code, last. By induction.
//
// The master is free; the register bus answers each read that it granted once, at any later clock.

`default_nettype none

module axi_read_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [1:0]  arid_i,
    input wire [7:0]  araddr_i,
    input wire [3:0]  arlen_i,
    input wire [2:0]  arsize_i,
    input wire [1:0]  arburst_i,
    input wire        arvalid_i,
    input wire        rready_i,
    input wire        rgrant_i,
    input wire        rdone_i,
    input wire [31:0] rdata_i
);
    wire        arready, rvalid, rlast, re, rlow;
    wire [1:0]  rid, rresp;
    wire [7:0]  raddr;
    wire [31:0] rdata;

    axi_read #(.ADDR_W(8), .ID_W(2)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .arid_i(arid_i), .araddr_i(araddr_i), .arlen_i(arlen_i),
        .arsize_i(arsize_i), .arburst_i(arburst_i), .arvalid_i(arvalid_i), .arready_o(arready),
        .rid_o(rid), .rdata_o(rdata), .rresp_o(rresp), .rlast_o(rlast), .rvalid_o(rvalid),
        .rready_i(rready_i), .re_o(re), .raddr_o(raddr), .rlow_o(rlow), .rgrant_i(rgrant_i),
        .rdone_i(rdone_i), .rdata_i(rdata_i)
    );

    // ---- The reference: the burst that is open ----
    reg        live = 1'b0;
    reg        open_q, refused_q, granted_q, held_q, last_q;
    reg  [1:0] id_q, rid_q, rresp_q;
    reg  [4:0] to_come_q;                       // beats
    reg [31:0] answer_q, rdata_q;

    always @(posedge clk_i) begin
        live    <= 1'b1;
        held_q  <= !rst_i && rvalid && !rready_i;
        rid_q   <= rid;
        rresp_q <= rresp;
        rdata_q <= rdata;
        last_q  <= rlast;
        if (re && rgrant_i) granted_q <= 1'b1;
        if (rdone_i) begin
            granted_q <= 1'b0;
            answer_q  <= rdata_i;
        end
        if (rvalid && rready_i) begin
            to_come_q <= to_come_q - 5'd1;
            if (to_come_q == 5'd1) open_q <= 1'b0;
        end
        if (arvalid_i && arready) begin
            open_q    <= 1'b1;
            id_q      <= arid_i;
            refused_q <= arburst_i != 2'b01 || arsize_i > 3'd2;
            to_come_q <= {1'b0, arlen_i} + 5'd1;
        end
        if (rst_i) begin
            open_q    <= 1'b0;
            granted_q <= 1'b0;
        end
    end
    always @(*) if (!live) assume (rst_i);
    always @(*) assume (!rdone_i || granted_q);

    always @(*) if (live) begin
        a_one_at_a_time: assert (!(arready && open_q));
        a_idle_accepts:  assert (open_q || arready);
        a_no_response_without_request: assert (!rvalid || open_q);
        a_id:            assert (!rvalid || rid == id_q);
        a_last:          assert (!rvalid || rlast == (to_come_q == 5'd1));
        a_code:          assert (!rvalid || rresp == (refused_q ? 2'b10 : 2'b00));
        a_data:          assert (!rvalid || rdata == (refused_q ? 32'd0 : answer_q));
        a_stable:        assert (!held_q || (rvalid && rid == rid_q && rresp == rresp_q
                                             && rdata == rdata_q && rlast == last_q));
        a_one_read_a_beat: assert (!re || (open_q && !refused_q && !granted_q && !rvalid));
        a_never_stuck:   assert (!open_q || re || granted_q || rvalid);
        a_word_aligned:  assert (raddr[1:0] == 2'd0);
    end

    // ---- Invariants ----
    wire       dut__refuse_q;
    wire [3:0] dut__left_q;
    always @(*) if (live) begin
        i_beats: assert (!open_q || {1'b0, dut__left_q} + 5'd1 == to_come_q);
        i_kind:  assert (!open_q || (dut__refuse_q == refused_q && rid == id_q));
        i_one:   assert (!granted_q || (open_q && !refused_q && !rvalid));
    end
endmodule

`default_nettype wire
