// hps_masters_bench.v - fpga2hps, and fpga2sdram in the configuration that the test sets

`default_nettype none

module hps_masters_bench (
    input  wire         clk_i,

    // fpga2hps
    input  wire [1:0]   size_i,
    input  wire [7:0]   awid_i, arid_i,
    input  wire [31:0]  awaddr_i, araddr_i,
    input  wire [3:0]   awlen_i, arlen_i,
    input  wire [2:0]   awsize_i, arsize_i,
    input  wire [1:0]   awburst_i, arburst_i,
    input  wire         awvalid_i, arvalid_i,
    output wire         awready_o, arready_o,
    input  wire [127:0] wdata_i,
    input  wire [15:0]  wstrb_i,
    input  wire         wlast_i, wvalid_i,
    output wire         wready_o,
    output wire [7:0]   bid_o, rid_o,
    output wire [1:0]   bresp_o, rresp_o,
    output wire         bvalid_o, rvalid_o, rlast_o,
    input  wire         bready_i, rready_i,
    output wire [127:0] rdata_o,

    // fpga2sdram, with a bit or a field for each port
    input  wire [5:0]   cfg_axi_mm_select_i,
    input  wire [11:0]  cfg_port_width_i, cfg_cport_type_i,
    input  wire [17:0]  cfg_cport_rfifo_map_i, cfg_cport_wfifo_map_i,
    input  wire [15:0]  cfg_rfifo_cport_map_i, cfg_wfifo_cport_map_i,
    input  wire [359:0] cmd_data_i,
    input  wire [5:0]   cmd_valid_i, wrack_ready_i,
    output wire [5:0]   cmd_ready_o, wrack_valid_o,
    output wire [59:0]  wrack_data_o,
    output wire [319:0] rd_data_o,
    output wire [3:0]   rd_valid_o, wr_ready_o,
    input  wire [3:0]   rd_ready_i, wr_valid_i,
    input  wire [359:0] wr_data_i
);
    cyclonev_hps_interface_fpga2hps bridge (
        .clk(clk_i), .port_size_config(size_i),
        .awid(awid_i), .awaddr(awaddr_i), .awlen(awlen_i), .awsize(awsize_i),
        .awburst(awburst_i), .awlock(2'd0), .awcache(4'd0), .awprot(3'd0), .awuser(5'd0),
        .awvalid(awvalid_i), .awready(awready_o),
        .wid(8'd0), .wdata(wdata_i), .wstrb(wstrb_i), .wlast(wlast_i), .wvalid(wvalid_i),
        .wready(wready_o), .bid(bid_o), .bresp(bresp_o), .bvalid(bvalid_o), .bready(bready_i),
        .arid(arid_i), .araddr(araddr_i), .arlen(arlen_i), .arsize(arsize_i),
        .arburst(arburst_i), .arlock(2'd0), .arcache(4'd0), .arprot(3'd0), .aruser(5'd0),
        .arvalid(arvalid_i), .arready(arready_o),
        .rid(rid_o), .rdata(rdata_o), .rresp(rresp_o), .rlast(rlast_o), .rvalid(rvalid_o),
        .rready(rready_i)
    );

    cyclonev_hps_interface_fpga2sdram memory (
        .cfg_axi_mm_select(cfg_axi_mm_select_i), .cfg_port_width(cfg_port_width_i),
        .cfg_cport_type(cfg_cport_type_i), .cfg_cport_rfifo_map(cfg_cport_rfifo_map_i),
        .cfg_cport_wfifo_map(cfg_cport_wfifo_map_i), .cfg_rfifo_cport_map(cfg_rfifo_cport_map_i),
        .cfg_wfifo_cport_map(cfg_wfifo_cport_map_i),
        .cmd_data_0(cmd_data_i[59:0]), .cmd_data_1(cmd_data_i[119:60]),
        .cmd_data_2(cmd_data_i[179:120]), .cmd_data_3(cmd_data_i[239:180]),
        .cmd_data_4(cmd_data_i[299:240]), .cmd_data_5(cmd_data_i[359:300]),
        .cmd_valid_0(cmd_valid_i[0]), .cmd_valid_1(cmd_valid_i[1]), .cmd_valid_2(cmd_valid_i[2]),
        .cmd_valid_3(cmd_valid_i[3]), .cmd_valid_4(cmd_valid_i[4]), .cmd_valid_5(cmd_valid_i[5]),
        .cmd_port_clk_0(clk_i), .cmd_port_clk_1(clk_i), .cmd_port_clk_2(clk_i),
        .cmd_port_clk_3(clk_i), .cmd_port_clk_4(clk_i), .cmd_port_clk_5(clk_i),
        .wrack_ready_0(wrack_ready_i[0]), .wrack_ready_1(wrack_ready_i[1]),
        .wrack_ready_2(wrack_ready_i[2]), .wrack_ready_3(wrack_ready_i[3]),
        .wrack_ready_4(wrack_ready_i[4]), .wrack_ready_5(wrack_ready_i[5]),
        .rd_ready_0(rd_ready_i[0]), .rd_ready_1(rd_ready_i[1]), .rd_ready_2(rd_ready_i[2]),
        .rd_ready_3(rd_ready_i[3]), .rd_clk_0(clk_i), .rd_clk_1(clk_i), .rd_clk_2(clk_i),
        .rd_clk_3(clk_i),
        .wr_data_0(wr_data_i[89:0]), .wr_data_1(wr_data_i[179:90]),
        .wr_data_2(wr_data_i[269:180]), .wr_data_3(wr_data_i[359:270]),
        .wr_valid_0(wr_valid_i[0]), .wr_valid_1(wr_valid_i[1]), .wr_valid_2(wr_valid_i[2]),
        .wr_valid_3(wr_valid_i[3]), .wr_clk_0(clk_i), .wr_clk_1(clk_i), .wr_clk_2(clk_i),
        .wr_clk_3(clk_i),
        .cmd_ready_0(cmd_ready_o[0]), .cmd_ready_1(cmd_ready_o[1]), .cmd_ready_2(cmd_ready_o[2]),
        .cmd_ready_3(cmd_ready_o[3]), .cmd_ready_4(cmd_ready_o[4]), .cmd_ready_5(cmd_ready_o[5]),
        .wrack_data_0(wrack_data_o[9:0]), .wrack_data_1(wrack_data_o[19:10]),
        .wrack_data_2(wrack_data_o[29:20]), .wrack_data_3(wrack_data_o[39:30]),
        .wrack_data_4(wrack_data_o[49:40]), .wrack_data_5(wrack_data_o[59:50]),
        .wrack_valid_0(wrack_valid_o[0]), .wrack_valid_1(wrack_valid_o[1]),
        .wrack_valid_2(wrack_valid_o[2]), .wrack_valid_3(wrack_valid_o[3]),
        .wrack_valid_4(wrack_valid_o[4]), .wrack_valid_5(wrack_valid_o[5]),
        .rd_data_0(rd_data_o[79:0]), .rd_data_1(rd_data_o[159:80]),
        .rd_data_2(rd_data_o[239:160]), .rd_data_3(rd_data_o[319:240]),
        .rd_valid_0(rd_valid_o[0]), .rd_valid_1(rd_valid_o[1]), .rd_valid_2(rd_valid_o[2]),
        .rd_valid_3(rd_valid_o[3]), .wr_ready_0(wr_ready_o[0]), .wr_ready_1(wr_ready_o[1]),
        .wr_ready_2(wr_ready_o[2]), .wr_ready_3(wr_ready_o[3])
    );
endmodule

`default_nettype wire
