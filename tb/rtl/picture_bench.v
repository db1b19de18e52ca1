// picture_bench.v - the full bridge and its memories together, with the screen's ports outside.

`default_nettype none

module picture_bench (
    input  wire            clk_i,
    input  wire            rst_i,

    input  wire [11:0]     awid_i,
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
    output wire [11:0]     bid_o,
    output wire [1:0]      bresp_o,
    output wire            bvalid_o,
    input  wire            bready_i,
    input  wire [11:0]     arid_i,
    input  wire [29:0]     araddr_i,
    input  wire [3:0]      arlen_i,
    input  wire [2:0]      arsize_i,
    input  wire [1:0]      arburst_i,
    input  wire            arvalid_i,
    output wire            arready_o,
    output wire [11:0]     rid_o,
    output wire [31:0]     rdata_o,
    output wire [1:0]      rresp_o,
    output wire            rlast_o,
    output wire            rvalid_o,
    input  wire            rready_i,

    input  wire            screen_re_i,
    input  wire [15:0]     screen_index_i,
    output wire [31:0]     screen_word_o,

    input  wire            screen_req_i,    // of the SDRAM
    input  wire [23:0]     screen_sdram_index_i,
    output wire            screen_take_o,
    output wire            screen_valid_o,
    output wire [31:0]     sdram_word_o,
    output wire            dram_cs_no,
    output wire            dram_ras_no,
    output wire            dram_cas_no,
    output wire            dram_we_no,
    output wire [1:0]      dram_ba_o,
    output wire [12:0]     dram_addr_o,
    output wire [1:0]      dram_dqm_o,
    output wire [15:0]     dram_dq_o,
    output wire            dram_dq_oe_o,
    input  wire [15:0]     dram_dq_i,

    input  wire            clear_i,
    output wire            clearing_o,
    output wire            any_o,           // some character is not a blank
    input  wire            cell_re_i,       // only beside screen_re_i
    input  wire [10:0]     cell_index_i,
    output wire [31:0]     cells_o
);
    wire [3:0]  we, cell_we, sdram_wstrb;
    wire        re, grant, cells_wait, sdram_req, sdram_we, sdram_take, sdram_valid;
    wire [15:0] windex, rindex;
    wire [23:0] sdram_index;
    wire [31:0] wdata, sdram_wdata;

    // verilator lint_off PINCONNECTEMPTY
    h2f_bridge bridge (
        .clk_i(clk_i), .rst_i(rst_i),
        .awid_i(awid_i), .awaddr_i(awaddr_i), .awlen_i(awlen_i), .awsize_i(awsize_i),
        .awburst_i(awburst_i), .awvalid_i(awvalid_i), .awready_o(awready_o),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .wvalid_i(wvalid_i), .wready_o(wready_o),
        .bid_o(bid_o), .bresp_o(bresp_o), .bvalid_o(bvalid_o), .bready_i(bready_i),
        .arid_i(arid_i), .araddr_i(araddr_i), .arlen_i(arlen_i), .arsize_i(arsize_i),
        .arburst_i(arburst_i), .arvalid_i(arvalid_i), .arready_o(arready_o),
        .rid_o(rid_o), .rdata_o(rdata_o), .rresp_o(rresp_o), .rlast_o(rlast_o),
        .rvalid_o(rvalid_o), .rready_i(rready_i),
        .we_o(we), .cell_we_o(cell_we), .windex_o(windex), .wdata_o(wdata),
        .re_o(re), .rindex_o(rindex), .rgrant_i(grant),
        .rdata_i(screen_word_o), .cells_i(cells_o), .cells_wait_i(cells_wait),
        .sdram_req_o(sdram_req), .sdram_we_o(sdram_we), .sdram_index_o(sdram_index),
        .sdram_wdata_o(sdram_wdata), .sdram_wstrb_o(sdram_wstrb), .sdram_take_i(sdram_take),
        .sdram_valid_i(sdram_valid), .sdram_i(sdram_word_o), .awake_o()
    );

    sdram sdram (
        .clk_i(clk_i), .rst_i(rst_i),
        .screen_req_i(screen_req_i), .screen_index_i(screen_sdram_index_i),
        .screen_take_o(screen_take_o), .screen_valid_o(screen_valid_o),
        .req_i(sdram_req), .we_i(sdram_we), .index_i(sdram_index), .wdata_i(sdram_wdata),
        .wstrb_i(sdram_wstrb), .take_o(sdram_take), .valid_o(sdram_valid), .rdata_o(sdram_word_o),
        .dram_cs_no(dram_cs_no), .dram_ras_no(dram_ras_no), .dram_cas_no(dram_cas_no),
        .dram_we_no(dram_we_no), .dram_ba_o(dram_ba_o), .dram_addr_o(dram_addr_o),
        .dram_dqm_o(dram_dqm_o), .dram_dq_o(dram_dq_o), .dram_dq_oe_o(dram_dq_oe_o),
        .dram_dq_i(dram_dq_i), .awake_o()
    );

    onchip_store store (
        .clk_i(clk_i),
        .screen_re_i(screen_re_i),
        .screen_index_i(screen_index_i), .re_i(re), .rindex_i(rindex), .rgrant_o(grant),
        .rdata_o(screen_word_o),
        .we_i(we), .windex_i(windex), .wdata_i(wdata)
    );

    character_store characters (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(clear_i), .clearing_o(clearing_o),
        .filling_o(cells_wait), .any_o(any_o),
        .screen_re_i(cell_re_i), .screen_index_i(cell_index_i),
        .re_i(re && grant), .rindex_i(rindex[10:0]), .rdata_o(cells_o),
        .we_i(cell_we), .windex_i(windex[10:0]), .wdata_i(wdata), .awake_o()
    );
    // verilator lint_on PINCONNECTEMPTY
endmodule

`default_nettype wire
