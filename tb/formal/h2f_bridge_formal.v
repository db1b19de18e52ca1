// h2f_bridge_formal.v - a request to the SDRAM stays as it is until taken, as sdram.v requires
//
// The masters of both channels and the SDRAM are unconstrained: a read and a write may be under way
// at once.  By 2-step induction.

`default_nettype none

module h2f_bridge_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [29:0] awaddr_i,
    input wire [3:0]  awlen_i,
    input wire [2:0]  awsize_i,
    input wire [1:0]  awburst_i,
    input wire        awvalid_i,
    input wire [31:0] wdata_i,
    input wire [3:0]  wstrb_i,
    input wire        wvalid_i,
    input wire        bready_i,
    input wire [29:0] araddr_i,
    input wire [3:0]  arlen_i,
    input wire [2:0]  arsize_i,
    input wire [1:0]  arburst_i,
    input wire        arvalid_i,
    input wire        rready_i,
    input wire        rgrant_i,
    input wire [31:0] rdata_i,
    input wire [31:0] cells_i,
    input wire        cells_wait_i,
    input wire        sdram_take_i,
    input wire        sdram_valid_i,
    input wire [31:0] sdram_i
);
    wire        req, we;
    wire [23:0] index;
    wire [31:0] wdata;
    wire [3:0]  wstrb;

    h2f_bridge #(.ID_W(1)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .awid_i(1'b0), .awaddr_i(awaddr_i), .awlen_i(awlen_i),
        .awsize_i(awsize_i), .awburst_i(awburst_i), .awvalid_i(awvalid_i), .wdata_i(wdata_i),
        .wstrb_i(wstrb_i), .wvalid_i(wvalid_i), .bready_i(bready_i), .arid_i(1'b0),
        .araddr_i(araddr_i), .arlen_i(arlen_i), .arsize_i(arsize_i), .arburst_i(arburst_i),
        .arvalid_i(arvalid_i), .rready_i(rready_i), .rgrant_i(rgrant_i), .rdata_i(rdata_i),
        .cells_i(cells_i), .cells_wait_i(cells_wait_i),
        .sdram_req_o(req), .sdram_we_o(we), .sdram_index_o(index), .sdram_wdata_o(wdata),
        .sdram_wstrb_o(wstrb), .sdram_take_i(sdram_take_i), .sdram_valid_i(sdram_valid_i),
        .sdram_i(sdram_i)
    );

    // ---- The bus: an answer comes after its grant, and only then ----
    wire dut__re, dut__rwait, dut__rdram, dut__granted_q, dut__re_o;
    reg  live = 1'b0, asked_q;
    always @(posedge clk_i) begin
        live <= 1'b1;
        if (sdram_valid_i) asked_q <= 1'b0;
        if (dut__re && dut__rdram && !dut__rwait) asked_q <= 1'b1;
        if (rst_i) asked_q <= 1'b0;
    end
    always @(*) begin
        if (!live) assume (rst_i);
        if (!asked_q) assume (!sdram_valid_i);
    end

    // ---- What must hold ----
    reg        shown_q, we_was;
    reg [23:0] index_was;
    reg [35:0] word_was;
    always @(posedge clk_i) begin
        shown_q   <= req && !sdram_take_i && !rst_i;
        we_was    <= we;
        index_was <= index;
        word_was  <= {wstrb, wdata};
    end
    always @(*) if (live && shown_q) begin
        a_stays:     assert (req && we == we_was && index == index_was);
        if (we) a_same_word: assert ({wstrb, wdata} == word_was);
    end

    // ---- Invariants: there is one read at a time, and a waiting one is told apart ----
    wire       dut__rdram_q, dut__reader__busy_q, dut__rvalid_o;
    wire [1:0] dut__posted;
    wire [4:0] stage = {dut__re, dut__re_o, dut__granted_q, asked_q, dut__rvalid_o};
    always @(*) if (live) begin
        i_posted: assert (dut__posted != 2'd3);
        i_one: assert ((stage & (stage - 5'd1)) == 5'd0 && (stage == 5'd0 || dut__reader__busy_q));
        i_waits: assert (!dut__rdram_q || (dut__re && dut__rdram));
        if (shown_q) i_shown: assert (we_was ? dut__posted != 2'd0 : dut__rdram_q);
    end
endmodule

`default_nettype wire
