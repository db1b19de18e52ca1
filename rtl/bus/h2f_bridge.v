// h2f_bridge.v - full HPS bridge: from its AXI3 slave port to the FPGA's memories
//
//   SDRAM: 64 MB, through sdram/sdram.v.
//   ONCHIP: 256 KB.
//   CHARACTERS: 8 KB, (x, y) at y << 7 | x; memory also where the screen does not show it.
//   Any other address: the SDRAM, by its lower 26 bits, as Platform Designer's interconnect does it
//   (lw_decode.v).  Bits 29:28 are not looked at, so all of it repeats each 256 MB.
//
// Writes to the on-chip memory and to the characters take one clock per beat.  Reads of these take
// turns with the screen, which has priority in two clocks out of four: a word takes 6 to 8 clocks.
// Beats to and from the characters wait while the characters are being cleared, which happens
// after a reset and when a program asks for it.
//
// Writes to the SDRAM are posted: up to two beats wait here, and a read waits until they are
// written.

`default_nettype none

module h2f_bridge #(
    parameter ID_W = 12
) (
    input  wire            clk_i,
    input  wire            rst_i,

    input  wire [ID_W-1:0] awid_i,
    input  wire [29:0]     awaddr_i,
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
    input  wire [29:0]     araddr_i,
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

    output reg  [3:0]      we_o,        // byte lanes, to the on-chip memory
    output reg  [3:0]      cell_we_o,   // to the characters
    output reg  [15:0]     windex_o,    // of a word; row << 5 | word of characters
    output reg  [31:0]     wdata_o,
    output reg             re_o,        // held until rgrant_i
    output reg  [15:0]     rindex_o,
    input  wire            rgrant_i,
    input  wire [31:0]     rdata_i,     // one clock after the grant
    input  wire [31:0]     cells_i,
    input  wire            cells_wait_i, // the characters are being cleared

    output wire            sdram_req_o,  // stays until sdram_take_i
    output wire            sdram_we_o,
    output wire [23:0]     sdram_index_o,
    output wire [31:0]     sdram_wdata_o,
    output wire [3:0]      sdram_wstrb_o,
    input  wire            sdram_take_i,
    input  wire            sdram_valid_i, // the word that was read
    input  wire [31:0]     sdram_i,

    output wire            awake_o
);
    `include "regmap.vh"

    // Offset in the bridge, without the bits inside the window and those above the decoded ones.
    localparam [9:0]  CHIP   = ONCHIP_BASE[27:18];
    localparam [14:0] CELLS  = CHARACTERS_BASE[27:13];

    wire        re, we;
    // The two lowest bits choose a lane, which the strobes name; the two highest do not count.
    // verilator lint_off UNUSED
    wire [29:0] raddr, waddr;
    // verilator lint_on UNUSED

    // ---- Writes -----------------------------------------------------------
    wire [31:0] wdata;
    wire [3:0]  wstrb;
    wire        wchip = waddr[27:18] == CHIP;
    wire        winc  = waddr[27:13] == CELLS;
    wire        wdram = !wchip && !winc;
    reg         wcells_q, wdram_q;      // where the burst goes: none crosses 4 KB
    wire [1:0]  posted;                 // beats
    wire        full  = {1'b0, posted} + {2'd0, we} >= 3'd2;
    wire        wwait = (wcells_q && cells_wait_i) || (wdram_q && full);
    wire [23:0] post_index;
    wire        wready, writer_awake, reader_awake;

    assign wready_o = wready && !wwait;
    always @(posedge clk_i)
        if (awvalid_i && awready_o) begin
            wcells_q <= awaddr_i[27:13] == CELLS;
            wdram_q  <= awaddr_i[27:13] != CELLS && awaddr_i[27:18] != CHIP;
        end

    axi_write #(.ADDR_W(30), .ID_W(ID_W)) writer (
        .clk_i(clk_i), .rst_i(rst_i),
        .awid_i(awid_i), .awaddr_i(awaddr_i), .awlen_i(awlen_i), .awsize_i(awsize_i),
        .awburst_i(awburst_i), .awvalid_i(awvalid_i), .awready_o(awready_o),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .wvalid_i(wvalid_i && !wwait), .wready_o(wready),
        .bid_o(bid_o), .bresp_o(bresp_o), .bvalid_o(bvalid_o), .bready_i(bready_i),
        .we_o(we), .waddr_o(waddr), .wdata_o(wdata), .wstrb_o(wstrb),
        .hold_i(1'b0), .awake_o(writer_awake)
    );

    always @(posedge clk_i) begin
        we_o      <= 4'd0;
        cell_we_o <= 4'd0;
        if (we) begin
            we_o      <= wchip ? wstrb : 4'd0;
            cell_we_o <= winc ? wstrb : 4'd0;
            windex_o  <= winc ? {5'd0, waddr[12:2]} : waddr[17:2];
            wdata_o   <= wdata;
        end
        if (rst_i) {we_o, cell_we_o} <= 8'd0;
    end

    shift_fifo #(.WIDTH(60), .DEPTH_LOG2(1)) posts (
        .clk_i(clk_i), .rst_i(rst_i), .push_i(we && wdram), .wdata_i({waddr[25:2], wstrb, wdata}),
        .pop_i(sdram_take_i && sdram_we_o), .rdata_o({post_index, sdram_wstrb_o, sdram_wdata_o}),
        .count_o(posted)
    );

    // ---- Reads ------------------------------------------------------------
    wire        rinc  = raddr[27:13] == CELLS;
    wire        rdram = raddr[27:18] != CHIP && !rinc;
    wire        rwait = rdram ? sdram_we_o || !sdram_take_i : rinc && cells_wait_i;
    reg         rdram_q;                // a read of the SDRAM waits, so posted writes wait too
    reg         rcells_q, granted_q;

    assign sdram_we_o    = posted != 2'd0 && !rdram_q;
    assign sdram_req_o   = sdram_we_o || (re && rdram);
    assign sdram_index_o = sdram_we_o ? post_index : raddr[25:2];

    // Memories have no side effects, so the lowest byte is one as others.
    // verilator lint_off PINCONNECTEMPTY
    axi_read #(.ADDR_W(30), .ID_W(ID_W)) reader (
        .clk_i(clk_i), .rst_i(rst_i),
        .arid_i(arid_i), .araddr_i(araddr_i), .arlen_i(arlen_i), .arsize_i(arsize_i),
        .arburst_i(arburst_i), .arvalid_i(arvalid_i), .arready_o(arready_o),
        .rid_o(rid_o), .rdata_o(rdata_o), .rresp_o(rresp_o), .rlast_o(rlast_o),
        .rvalid_o(rvalid_o), .rready_i(rready_i),
        .re_o(re), .raddr_o(raddr), .rlow_o(), .rgrant_i(!rwait),
        .rdone_i(granted_q || sdram_valid_i),
        .rdata_i(sdram_valid_i ? sdram_i : rcells_q ? cells_i : rdata_i),
        .awake_o(reader_awake)
    );
    // verilator lint_on PINCONNECTEMPTY

    assign awake_o = writer_awake || we || posted != 2'd0 || we_o != 4'd0 || cell_we_o != 4'd0
                     || reader_awake || re || rdram_q || re_o || granted_q;

    always @(posedge clk_i) begin
        if (re && !rwait) begin
            re_o     <= !rdram;
            rindex_o <= rinc ? {5'd0, raddr[12:2]} : raddr[17:2];
            rcells_q <= rinc;
        end else if (rgrant_i) begin
            re_o <= 1'b0;
        end
        granted_q <= re_o && rgrant_i;
        rdram_q   <= re && rdram && rwait && !sdram_we_o && !rst_i;
        if (rst_i) begin
            re_o      <= 1'b0;
            granted_q <= 1'b0;
        end
    end

endmodule

`default_nettype wire
