// cyclonev_hps_interface_hps2fpga.v - the HPS-to-FPGA bridge as AXI3

`default_nettype none

module cyclonev_hps_interface_hps2fpga (
    input  wire          clk,
    input  wire [1:0]    port_size_config,  // 0: 32 bits, 1: 64, 2: 128
    output wire [11:0]   awid,
    output wire [29:0]   awaddr,
    output wire [3:0]    awlen,
    output wire [2:0]    awsize,
    output wire [1:0]    awburst,
    output wire [1:0]    awlock,
    output wire [3:0]    awcache,
    output wire [2:0]    awprot,
    output wire          awvalid,
    input  wire          awready,

    output wire [11:0]   wid,
    output wire [127:0]  wdata,
    output wire [15:0]   wstrb,
    output wire          wlast,
    output wire          wvalid,
    input  wire          wready,

    input  wire [11:0]   bid,
    input  wire [1:0]    bresp,
    input  wire          bvalid,
    output wire          bready,

    output wire [11:0]   arid,
    output wire [29:0]   araddr,
    output wire [3:0]    arlen,
    output wire [2:0]    arsize,
    output wire [1:0]    arburst,
    output wire [1:0]    arlock,
    output wire [3:0]    arcache,
    output wire [2:0]    arprot,
    output wire          arvalid,
    input  wire          arready,

    input  wire [11:0]   rid,
    input  wire [127:0]  rdata,
    input  wire [1:0]    rresp,
    input  wire          rlast,
    input  wire          rvalid,
    output wire          rready
);
    de1sim_hps_axi #(.FULL(1), .ADDRESS_BITS(30)) bridge (
        .clk(clk), .size_i(port_size_config),
        .id(awid), .addr(awaddr), .len(awlen), .size(awsize), .burst(awburst), .lock(awlock),
        .cache(awcache), .prot(awprot),
        .awvalid(awvalid), .awready(awready),
        .wdata(wdata), .wstrb(wstrb), .wlast(wlast), .wvalid(wvalid), .wready(wready),
        .bid(bid), .bresp(bresp), .bvalid(bvalid),
        .arvalid(arvalid), .arready(arready),
        .rid(rid), .rdata(rdata), .rresp(rresp), .rlast(rlast), .rvalid(rvalid)
    );

    assign wid = awid;
    assign {arid, araddr, arlen, arsize} = {awid, awaddr, awlen, awsize};
    assign {arburst, arlock, arcache, arprot} = {awburst, awlock, awcache, awprot};
    assign {bready, rready} = 2'b11;
endmodule

`default_nettype wire
