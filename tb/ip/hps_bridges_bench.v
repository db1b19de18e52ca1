// hps_bridges_bench.v - both bridges of the processor, the lightweight one in the low bits of each
// port, and the part of de1sim_chip.v by which they get their bursts

`default_nettype none

module hps_bridges_bench (
    input  wire         clk_i,
    input  wire [1:0]   size_i,      // of the full bridge
    input  wire [1:0]   request_i,
    output wire [1:0]   answer_o,

    output wire [23:0]  awid_o, wid_o, arid_o,
    output wire [59:0]  awaddr_o, araddr_o,
    output wire [7:0]   awlen_o, awcache_o, arlen_o, arcache_o,
    output wire [5:0]   awsize_o, awprot_o, arsize_o, arprot_o,
    output wire [3:0]   awburst_o, arburst_o, awlock_o, arlock_o,
    output wire [1:0]   awvalid_o, arvalid_o, wvalid_o, wlast_o, bready_o, rready_o,
    input  wire [1:0]   awready_i, arready_i, wready_i,
    output wire [255:0] wdata_o,
    output wire [31:0]  wstrb_o,
    input  wire [23:0]  bid_i, rid_i,
    input  wire [3:0]   bresp_i, rresp_i,
    input  wire [1:0]   bvalid_i, rvalid_i, rlast_i,
    input  wire [255:0] rdata_i
);
    generate
        if (1) begin : de1sim_chip
            wire [1:0]  hps_request = request_i;
            wire [1:0]  hps_reset = 2'd0;
            wire [1:0]  hps_answer;
            // verilator lint_off UNUSED
            wire [3:0]  hps_size;
            wire [39:0] hps_waits;
            // verilator lint_on UNUSED
            assign answer_o = hps_answer;
        end
    endgenerate

    assign awaddr_o[29:21] = 9'd0;
    assign araddr_o[29:21] = 9'd0;
    assign wdata_o[127:32] = 96'd0;
    assign wstrb_o[15:4]   = 12'd0;

    cyclonev_hps_interface_hps2fpga_light_weight lightweight (
        .clk(clk_i),
        .awid(awid_o[11:0]), .awaddr(awaddr_o[20:0]), .awlen(awlen_o[3:0]), .awsize(awsize_o[2:0]),
        .awburst(awburst_o[1:0]), .awlock(awlock_o[1:0]), .awcache(awcache_o[3:0]),
        .awprot(awprot_o[2:0]), .awvalid(awvalid_o[0]), .awready(awready_i[0]),
        .wid(wid_o[11:0]), .wdata(wdata_o[31:0]), .wstrb(wstrb_o[3:0]), .wlast(wlast_o[0]),
        .wvalid(wvalid_o[0]), .wready(wready_i[0]),
        .bid(bid_i[11:0]), .bresp(bresp_i[1:0]), .bvalid(bvalid_i[0]), .bready(bready_o[0]),
        .arid(arid_o[11:0]), .araddr(araddr_o[20:0]), .arlen(arlen_o[3:0]), .arsize(arsize_o[2:0]),
        .arburst(arburst_o[1:0]), .arlock(arlock_o[1:0]), .arcache(arcache_o[3:0]),
        .arprot(arprot_o[2:0]), .arvalid(arvalid_o[0]), .arready(arready_i[0]),
        .rid(rid_i[11:0]), .rdata(rdata_i[31:0]), .rresp(rresp_i[1:0]), .rlast(rlast_i[0]),
        .rvalid(rvalid_i[0]), .rready(rready_o[0])
    );

    cyclonev_hps_interface_hps2fpga full (
        .clk(clk_i), .port_size_config(size_i),
        .awid(awid_o[23:12]), .awaddr(awaddr_o[59:30]), .awlen(awlen_o[7:4]),
        .awsize(awsize_o[5:3]), .awburst(awburst_o[3:2]), .awlock(awlock_o[3:2]),
        .awcache(awcache_o[7:4]), .awprot(awprot_o[5:3]), .awvalid(awvalid_o[1]),
        .awready(awready_i[1]),
        .wid(wid_o[23:12]), .wdata(wdata_o[255:128]), .wstrb(wstrb_o[31:16]), .wlast(wlast_o[1]),
        .wvalid(wvalid_o[1]), .wready(wready_i[1]),
        .bid(bid_i[23:12]), .bresp(bresp_i[3:2]), .bvalid(bvalid_i[1]), .bready(bready_o[1]),
        .arid(arid_o[23:12]), .araddr(araddr_o[59:30]), .arlen(arlen_o[7:4]),
        .arsize(arsize_o[5:3]), .arburst(arburst_o[3:2]), .arlock(arlock_o[3:2]),
        .arcache(arcache_o[7:4]), .arprot(arprot_o[5:3]), .arvalid(arvalid_o[1]),
        .arready(arready_i[1]),
        .rid(rid_i[23:12]), .rdata(rdata_i[255:128]), .rresp(rresp_i[3:2]), .rlast(rlast_i[1]),
        .rvalid(rvalid_i[1]), .rready(rready_o[1])
    );
endmodule

`default_nettype wire
