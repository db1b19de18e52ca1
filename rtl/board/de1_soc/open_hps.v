// open_hps.v - replaces the processor in tools without its bridges: paints colour bars, once
//
// The unchanged fabric shows them: bus, picture memory, VGA.  Ports as in hps.v.  Registers get
// their values by `initial`, because this module has no reset.

`default_nettype none
// verilator lint_off DECLFILENAME
// verilator lint_off UNUSED

module hps #(
    parameter ID_W = 12
) (
    input  wire            clk_i,
    output wire            rst_no,        // asynchronous; low while the HPS is in reset
    input  wire [63:0]     irq_i,

    // Lightweight bridge
    output wire [ID_W-1:0] lw_awid_o,
    output wire [20:0]     lw_awaddr_o,
    output wire [3:0]      lw_awlen_o,
    output wire [2:0]      lw_awsize_o,
    output wire [1:0]      lw_awburst_o,
    output wire            lw_awvalid_o,
    input  wire            lw_awready_i,
    output wire [31:0]     lw_wdata_o,
    output wire [3:0]      lw_wstrb_o,
    output wire            lw_wvalid_o,
    input  wire            lw_wready_i,
    input  wire [ID_W-1:0] lw_bid_i,
    input  wire [1:0]      lw_bresp_i,
    input  wire            lw_bvalid_i,
    output wire            lw_bready_o,
    output wire [ID_W-1:0] lw_arid_o,
    output wire [20:0]     lw_araddr_o,
    output wire [3:0]      lw_arlen_o,
    output wire [2:0]      lw_arsize_o,
    output wire [1:0]      lw_arburst_o,
    output wire            lw_arvalid_o,
    input  wire            lw_arready_i,
    input  wire [ID_W-1:0] lw_rid_i,
    input  wire [31:0]     lw_rdata_i,
    input  wire [1:0]      lw_rresp_i,
    input  wire            lw_rlast_i,
    input  wire            lw_rvalid_i,
    output wire            lw_rready_o,

    // Full bridge
    output wire [ID_W-1:0] h2f_awid_o,
    output wire [29:0]     h2f_awaddr_o,
    output wire [3:0]      h2f_awlen_o,
    output wire [2:0]      h2f_awsize_o,
    output wire [1:0]      h2f_awburst_o,
    output wire            h2f_awvalid_o,
    input  wire            h2f_awready_i,
    output wire [31:0]     h2f_wdata_o,
    output wire [3:0]      h2f_wstrb_o,
    output wire            h2f_wvalid_o,
    input  wire            h2f_wready_i,
    input  wire [ID_W-1:0] h2f_bid_i,
    input  wire [1:0]      h2f_bresp_i,
    input  wire            h2f_bvalid_i,
    output wire            h2f_bready_o,
    output wire [ID_W-1:0] h2f_arid_o,
    output wire [29:0]     h2f_araddr_o,
    output wire [3:0]      h2f_arlen_o,
    output wire [2:0]      h2f_arsize_o,
    output wire [1:0]      h2f_arburst_o,
    output wire            h2f_arvalid_o,
    input  wire            h2f_arready_i,
    input  wire [ID_W-1:0] h2f_rid_i,
    input  wire [31:0]     h2f_rdata_i,
    input  wire [1:0]      h2f_rresp_i,
    input  wire            h2f_rlast_i,
    input  wire            h2f_rvalid_i,
    output wire            h2f_rready_o
);
    localparam [7:0] ROW_LAST  = 8'd239, WORD_LAST = 8'd159;
    localparam       ONCHIP    = 30'h08000000;   // of the bridge's window at 0xC0000000

    assign rst_no = 1'b1;

    // ---- One word after the other -----------------------------------------
    reg       address_q, data_q, done_q;         // to be accepted; the last word was answered
    reg [7:0] row_q, word_q;
    reg [6:0] age_q;                             // the fabric's reset lasts some forty clocks

    initial {address_q, data_q, done_q, row_q, word_q, age_q} = 0;

    always @(posedge clk_i) begin
        if (h2f_awready_i) address_q <= 1'b0;
        if (h2f_wready_i) data_q <= 1'b0;
        if (age_q != 7'd127) begin
            age_q     <= age_q + 7'd1;
            address_q <= age_q == 7'd126;
            data_q    <= age_q == 7'd126;
        end else if (h2f_bvalid_i && row_q == ROW_LAST && word_q == WORD_LAST) done_q <= 1'b1;
        else if (h2f_bvalid_i) begin
            {address_q, data_q} <= 2'b11;
            word_q <= word_q == WORD_LAST ? 8'd0 : word_q + 8'd1;
            if (word_q == WORD_LAST) row_q <= row_q + 8'd1;
        end
    end

    // Eight bars: white, yellow, cyan, green, magenta, red, blue, black; 20 words per bar.
    wire [7:0]  bar    = word_q / 8'd20;
    wire [15:0] colour = {{5{!bar[1]}}, {6{!bar[2]}}, {5{!bar[0]}}};

    assign h2f_awid_o    = {ID_W{1'b0}};
    assign h2f_awaddr_o  = ONCHIP + {12'd0, row_q, word_q, 2'd0};
    assign h2f_awlen_o   = 4'd0;
    assign h2f_awsize_o  = 3'd2;
    assign h2f_awburst_o = 2'd1;
    assign h2f_awvalid_o = address_q;
    assign h2f_wdata_o   = {colour, colour};
    assign h2f_wstrb_o   = 4'b1111;
    assign h2f_wvalid_o  = data_q;
    assign h2f_bready_o  = !done_q;

    // ---- Everything else is idle ------------------------------------------
    assign {lw_awid_o, lw_awaddr_o, lw_awlen_o, lw_awsize_o, lw_awburst_o, lw_awvalid_o, lw_wdata_o,
            lw_wstrb_o, lw_wvalid_o, lw_bready_o, lw_arid_o, lw_araddr_o, lw_arlen_o, lw_arsize_o,
            lw_arburst_o, lw_arvalid_o, lw_rready_o, h2f_arid_o, h2f_araddr_o, h2f_arlen_o,
            h2f_arsize_o, h2f_arburst_o, h2f_arvalid_o, h2f_rready_o} = 0;
endmodule

`default_nettype wire
