// h2f_bridge.v - full HPS bridge: AXI3 slave in front, the two pictures and the characters behind
//
//   PICTURE0, PICTURE1: 320 x 240 RGB565, pixel (x, y) at y << 10 | x << 1 (regmap.def).
//   CHARACTERS: 80 x 60 bytes, (x, y) at y << 7 | x.
//   The bytes between the rows' ends and behind the last row are nobody's storage: they read 0 and
//   ignore writes, because programs clear whole powers of two.  Any other address: DECERR.
//
// Writes go at a beat a clock.  Reads take turns with the screen, which has first call on two
// clocks in four: 6 clocks a word, at most 8.  Beats to and from the characters wait while those
// are cleared, after a reset and when a program asks for it.

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

    output reg  [3:0]      we_o,        // byte lanes, to the pictures
    output reg  [3:0]      cell_we_o,   // to the characters
    output reg  [16:0]     windex_o,    // picture_index.vh, or row << 5 | word of characters
    output reg  [31:0]     wdata_o,
    output reg             re_o,        // held until rgrant_i
    output reg  [16:0]     rindex_o,
    input  wire            rgrant_i,
    input  wire [31:0]     rdata_i,     // one clock after the grant
    input  wire [31:0]     cells_i,
    input  wire            cells_wait_i, // the characters are being cleared

    output wire            awake_o
);
    `include "regmap.vh"
    `include "picture_index.vh"

    // Offset of a picture's window in the bridge, without the bits inside the window.
    localparam [10:0] WINDOW0 = PICTURE0_BASE[29:19];
    localparam [10:0] WINDOW1 = PICTURE1_BASE[29:19];
    localparam [16:0] CELLS   = CHARACTERS_BASE[29:13];

    // Whether a byte offset among the characters is on the screen.
    // The two lowest bits choose a lane.
    // verilator lint_off UNUSED
    function cells_stored;
        input [12:0] offset;
        cells_stored = offset[12:7] < 6'd60 && offset[6:2] < 5'd20;
    endfunction
    // verilator lint_on UNUSED

    // ---- Writes -----------------------------------------------------------
    wire        we;
    wire [29:0] waddr;
    wire [31:0] wdata;
    wire [3:0]  wstrb;
    wire        win0 = waddr[29:19] == WINDOW0;
    wire        win1 = waddr[29:19] == WINDOW1;
    wire        winc = waddr[29:13] == CELLS;
    reg         werror_q;
    reg         wcells_q;               // the burst is one of characters: none crosses 4 KB
    wire        wwait = wcells_q && cells_wait_i;
    wire        wready, writer_awake, reader_awake;

    assign wready_o = wready && !wwait;
    always @(posedge clk_i)
        if (awvalid_i && awready_o) wcells_q <= awaddr_i[29:13] == CELLS;

    axi_write #(.ADDR_W(30), .ID_W(ID_W)) writer (
        .clk_i(clk_i), .rst_i(rst_i),
        .awid_i(awid_i), .awaddr_i(awaddr_i), .awlen_i(awlen_i), .awsize_i(awsize_i),
        .awburst_i(awburst_i), .awvalid_i(awvalid_i), .awready_o(awready_o),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .wvalid_i(wvalid_i && !wwait), .wready_o(wready),
        .bid_o(bid_o), .bresp_o(bresp_o), .bvalid_o(bvalid_o), .bready_i(bready_i),
        .we_o(we), .waddr_o(waddr), .wdata_o(wdata), .wstrb_o(wstrb), .werror_i(werror_q),
        .awake_o(writer_awake)
    );

    always @(posedge clk_i) begin
        we_o      <= 4'd0;
        cell_we_o <= 4'd0;
        if (we) begin
            we_o      <= (win0 || win1) && stored(waddr[18:0]) ? wstrb : 4'd0;
            cell_we_o <= winc && cells_stored(waddr[12:0]) ? wstrb : 4'd0;
            windex_o  <= winc ? {6'd0, waddr[12:2]} : picture_index(win1, waddr[18:0]);
            wdata_o   <= wdata;
            werror_q  <= !(win0 || win1 || winc);
        end
        if (rst_i) {we_o, cell_we_o} <= 8'd0;
    end

    // ---- Reads ------------------------------------------------------------
    wire        re;
    wire [29:0] raddr;
    wire        rin0 = raddr[29:19] == WINDOW0;
    wire        rin1 = raddr[29:19] == WINDOW1;
    wire        rinc = raddr[29:13] == CELLS;
    wire        rwait = rinc && cells_wait_i;
    reg         rempty_q, rcells_q, rerror_q, granted_q;

    axi_read #(.ADDR_W(30), .ID_W(ID_W)) reader (
        .clk_i(clk_i), .rst_i(rst_i),
        .arid_i(arid_i), .araddr_i(araddr_i), .arlen_i(arlen_i), .arsize_i(arsize_i),
        .arburst_i(arburst_i), .arvalid_i(arvalid_i), .arready_o(arready_o),
        .rid_o(rid_o), .rdata_o(rdata_o), .rresp_o(rresp_o), .rlast_o(rlast_o),
        .rvalid_o(rvalid_o), .rready_i(rready_i),
        .re_o(re), .raddr_o(raddr), .rgrant_i(!rwait),
        .rdone_i(granted_q), .rdata_i(rempty_q ? 32'd0 : rcells_q ? cells_i : rdata_i),
        .rerror_i(rerror_q), .awake_o(reader_awake)
    );

    assign awake_o = writer_awake || we || we_o != 4'd0 || cell_we_o != 4'd0
                     || reader_awake || re || re_o || granted_q;

    always @(posedge clk_i) begin
        if (re && !rwait) begin
            re_o     <= 1'b1;
            rindex_o <= rinc ? {6'd0, raddr[12:2]} : picture_index(rin1, raddr[18:0]);
            rempty_q <= rinc ? !cells_stored(raddr[12:0]) : !stored(raddr[18:0]);
            rcells_q <= rinc;
            rerror_q <= !(rin0 || rin1 || rinc);
        end else if (rgrant_i) begin
            re_o <= 1'b0;
        end
        granted_q <= re_o && rgrant_i;
        if (rst_i) begin
            re_o      <= 1'b0;
            granted_q <= 1'b0;
        end
    end

endmodule

`default_nettype wire
