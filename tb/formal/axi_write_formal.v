// axi_write_formal.v - one answer to each write request, its ID, its beats, its code. By induction.
//
// The master is unconstrained: it may do anything at any time, even withdraw a VALID.

`default_nettype none

module axi_write_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [1:0]  awid_i,
    input wire [7:0]  awaddr_i,
    input wire [3:0]  awlen_i,
    input wire [2:0]  awsize_i,
    input wire [1:0]  awburst_i,
    input wire        awvalid_i,
    input wire [31:0] wdata_i,
    input wire [3:0]  wstrb_i,
    input wire        wvalid_i,
    input wire        bready_i,
    input wire        hold_i
);
    wire        awready, wready, bvalid, we;
    wire [1:0]  bid, bresp;
    wire [7:0]  waddr;
    wire [31:0] wdata;
    wire [3:0]  wstrb;

    axi_write #(.ADDR_W(8), .ID_W(2)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .awid_i(awid_i), .awaddr_i(awaddr_i), .awlen_i(awlen_i),
        .awsize_i(awsize_i), .awburst_i(awburst_i), .awvalid_i(awvalid_i), .awready_o(awready),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .wvalid_i(wvalid_i), .wready_o(wready),
        .bid_o(bid), .bresp_o(bresp), .bvalid_o(bvalid), .bready_i(bready_i),
        .we_o(we), .waddr_o(waddr), .wdata_o(wdata), .wstrb_o(wstrb),
        .hold_i(hold_i)
    );

    // ---- The reference: the burst that is open ----
    reg        live = 1'b0, ran_q = 1'b0;
    reg        open_q, refused_q, write_q, held_q;
    reg  [1:0] id_q, bid_q, bresp_q;
    reg  [4:0] to_come_q;                       // beats
    reg  [2:0] wait_q;                          // clocks since the last beat, without those on hold
    reg        hold_q, bvalid_q;
    reg [31:0] wdata_q;
    reg  [3:0] wstrb_q;
    wire       beat = wvalid_i && wready;

    always @(posedge clk_i) begin
        live        <= 1'b1;
        ran_q       <= !rst_i;
        held_q      <= !rst_i && bvalid && !bready_i;
        bid_q       <= bid;
        bresp_q     <= bresp;
        wdata_q     <= wdata_i;
        wstrb_q     <= wstrb_i;
        write_q     <= beat && open_q && !refused_q;
        if (awvalid_i && awready) begin
            open_q    <= 1'b1;
            id_q      <= awid_i;
            refused_q <= awburst_i != 2'b01 || awsize_i > 3'd2;
            to_come_q <= {1'b0, awlen_i} + 5'd1;
            wait_q    <= 3'd0;
        end
        if (beat) to_come_q <= to_come_q - 5'd1;
        hold_q      <= hold_i;
        bvalid_q    <= bvalid;
        if (open_q && to_come_q == 5'd0 && wait_q != 3'd7 && !(wait_q == 3'd1 && hold_i))
            wait_q <= wait_q + 3'd1;
        if (bvalid && bready_i) open_q <= 1'b0;
        if (rst_i) begin
            open_q  <= 1'b0;
            write_q <= 1'b0;
        end
    end
    always @(*) if (!live) assume (rst_i);

    always @(*) if (live) begin
        a_one_at_a_time:   assert (!(awready && open_q));
        a_idle_accepts:    assert (open_q || awready);
        a_right_beats:     assert (wready == (open_q && to_come_q != 5'd0));
        a_no_response_without_request: assert (!bvalid || (open_q && to_come_q == 5'd0));
        a_id:              assert (!bvalid || bid == id_q);
        a_code:            assert (!bvalid || bresp == (refused_q ? 2'b10 : 2'b00));
        a_response_comes:  assert (!open_q || to_come_q != 5'd0 || wait_q < 3'd2 || bvalid);
        a_holds:           assert (!ran_q || !hold_q || !bvalid || bvalid_q);
        a_stable:          assert (!held_q || (bvalid && bid == bid_q && bresp == bresp_q));
        a_writes_each_beat_once: assert (we == write_q);
        a_passes_data:     assert (!we || (wdata == wdata_q && wstrb == wstrb_q));
        a_word_aligned:    assert (!we || waddr[1:0] == 2'd0);
    end

    // ---- Invariants ----
    wire       dut__refuse_q;
    wire [3:0] dut__left_q;
    wire [1:0] dut__drain_q;
    always @(*) if (live) begin
        i_beats: assert (!open_q || to_come_q == 5'd0 || {1'b0, dut__left_q} + 5'd1 == to_come_q);
        i_few:   assert (!open_q || to_come_q <= 5'd16);
        i_kind:  assert (!open_q || (dut__refuse_q == refused_q && bid == id_q));
        i_code:  assert (!open_q || bresp == (refused_q ? 2'b10 : 2'b00));
        i_closed: assert (open_q || (!write_q && !bvalid && dut__drain_q == 2'd0));
        i_drain: assert (!open_q || (to_come_q != 5'd0 ? dut__drain_q == 2'd0 && !bvalid
                 : dut__drain_q == (wait_q == 3'd0 ? 2'b01 : wait_q == 3'd1 ? 2'b10 : 2'b00)
                   && bvalid == (wait_q >= 3'd2)));
        i_late:  assert (!open_q || to_come_q == 5'd0 || wait_q == 3'd0);
        i_order: assert (!open_q || to_come_q != 5'd0 || !write_q || wait_q == 3'd0);
    end
endmodule

`default_nettype wire
