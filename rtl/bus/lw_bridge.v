// lw_bridge.v - lightweight HPS bridge: from its AXI3 slave port to select lines and the register
// bus
//
//   write:  we_o[block] for one clock, with waddr_o, wdata_o, wstrb_o; always taken.  A block that
//           needs longer raises hold_i in that clock, until it is done: the response waits for it
//   read:   re_o[block] for one clock, with raddr_o; rdata_i is sampled one clock later and is
//           the OR of all blocks, so a block that was not asked gives 0.  A block that cannot
//           answer yet raises rhold_i in the clock of re_o, until the clock before its answer
//
// A register read takes 5 clocks from ARVALID to RVALID, a single write 5 from AWVALID to BVALID.
// Each address is some block's: lw_decode.v.

`default_nettype none

module lw_bridge #(
    parameter ID_W = 12
) (
    input  wire            clk_i,
    input  wire            rst_i,

    input  wire [ID_W-1:0] awid_i,
    input  wire [20:0]     awaddr_i,
    input  wire [3:0]      awlen_i,
    input  wire [2:0]      awsize_i,
    input  wire [1:0]      awburst_i,
    input  wire            awvalid_i,
    output wire            awready_o,
    input  wire [31:0]     wdata_i,
    input  wire [3:0]      wstrb_i,
    input  wire            wvalid_i,
    output wire            wready_o,
    output wire [ID_W-1:0] bid_o,
    output wire [1:0]      bresp_o,
    output wire            bvalid_o,
    input  wire            bready_i,
    input  wire [ID_W-1:0] arid_i,
    input  wire [20:0]     araddr_i,
    input  wire [3:0]      arlen_i,
    input  wire [2:0]      arsize_i,
    input  wire [1:0]      arburst_i,
    input  wire            arvalid_i,
    output wire            arready_o,
    output wire [ID_W-1:0] rid_o,
    output wire [31:0]     rdata_o,
    output wire [1:0]      rresp_o,
    output wire            rlast_o,
    output wire            rvalid_o,
    input  wire            rready_i,

    output wire [31:0]     we_o,      // one line per block, SEL_... of regmap.vh
    output reg  [11:0]     waddr_o,   // low 12 bits of the address, word aligned
    output reg  [31:0]     wdata_o,
    output reg  [3:0]      wstrb_o,
    input  wire            hold_i,
    output wire [31:0]     re_o,
    output wire [11:0]     raddr_o,
    output wire            rlow_o,    // the read is of the word's lowest byte, too
    input  wire            rhold_i,
    input  wire [31:0]     rdata_i,

    output wire            awake_o
);
    // ---- Writes -----------------------------------------------------------
    wire        we;
    wire [20:0] waddr;
    wire [31:0] wdata;
    wire [3:0]  wstrb;
    wire        writer_awake, write_decode_awake, reader_awake, read_decode_awake;

    axi_write #(.ADDR_W(21), .ID_W(ID_W)) writer (
        .clk_i(clk_i), .rst_i(rst_i),
        .awid_i(awid_i), .awaddr_i(awaddr_i), .awlen_i(awlen_i), .awsize_i(awsize_i),
        .awburst_i(awburst_i), .awvalid_i(awvalid_i), .awready_o(awready_o),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .wvalid_i(wvalid_i), .wready_o(wready_o),
        .bid_o(bid_o), .bresp_o(bresp_o), .bvalid_o(bvalid_o), .bready_i(bready_i),
        .we_o(we), .waddr_o(waddr), .wdata_o(wdata), .wstrb_o(wstrb),
        .hold_i(hold_i), .awake_o(writer_awake)
    );

    lw_decode write_decode (
        .clk_i(clk_i), .rst_i(rst_i), .enable_i(we), .write_i(1'b1), .addr_i(waddr), .sel_o(we_o),
        .awake_o(write_decode_awake)
    );

    always @(posedge clk_i) if (we) begin
        waddr_o <= waddr[11:0];
        wdata_o <= wdata;
        wstrb_o <= wstrb;
    end

    // ---- Reads ------------------------------------------------------------
    wire        re;
    wire [20:0] raddr;
    reg         asked_q, done_q;

    axi_read #(.ADDR_W(21), .ID_W(ID_W)) reader (
        .clk_i(clk_i), .rst_i(rst_i),
        .arid_i(arid_i), .araddr_i(araddr_i), .arlen_i(arlen_i), .arsize_i(arsize_i),
        .arburst_i(arburst_i), .arvalid_i(arvalid_i), .arready_o(arready_o),
        .rid_o(rid_o), .rdata_o(rdata_o), .rresp_o(rresp_o), .rlast_o(rlast_o),
        .rvalid_o(rvalid_o), .rready_i(rready_i),
        .re_o(re), .raddr_o(raddr), .rlow_o(rlow_o), .rgrant_i(1'b1),
        .rdone_i(done_q), .rdata_i(rdata_i), .awake_o(reader_awake)
    );

    lw_decode read_decode (
        .clk_i(clk_i), .rst_i(rst_i), .enable_i(re), .write_i(1'b0), .addr_i(raddr), .sel_o(re_o),
        .awake_o(read_decode_awake)
    );

    assign awake_o = writer_awake || we || write_decode_awake
                     || reader_awake || re || read_decode_awake || asked_q || done_q;

    assign raddr_o = raddr[11:0];   // stable until the beat is done

    always @(posedge clk_i) begin
        asked_q <= re || (asked_q && rhold_i);
        done_q  <= asked_q && !rhold_i;
        if (rst_i) begin
            asked_q <= 1'b0;
            done_q  <= 1'b0;
        end
    end

endmodule

`default_nettype wire
