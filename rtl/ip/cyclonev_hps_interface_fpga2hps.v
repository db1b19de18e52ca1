// cyclonev_hps_interface_fpga2hps.v - the FPGA-to-HPS bridge: the processor's memory and
// peripherals for a master in the FPGA
//
// Addresses: DDR3 from 0 to 0x3FFFFFFF, and once more from 0x80000000 on, where the board's
// accesses are coherent with the processor's caches; peripherals and on-chip RAM where the
// processor has them; the bridges to the FPGA answer DECERR.
//
// Not handled: exclusive accesses; AxCACHE, AxPROT and AxUSER, which change nothing.

`default_nettype none

module cyclonev_hps_interface_fpga2hps (
    input  wire          clk,
    input  wire [1:0]    port_size_config,  // 0: 32 bits, 1: 64, 2: 128, 3: unused
    input  wire [7:0]    awid,
    input  wire [31:0]   awaddr,
    input  wire [3:0]    awlen,
    input  wire [2:0]    awsize,
    input  wire [1:0]    awburst,
    input  wire [1:0]    awlock,
    input  wire [3:0]    awcache,
    input  wire [2:0]    awprot,
    input  wire [4:0]    awuser,
    input  wire          awvalid,
    output wire          awready,

    input  wire [7:0]    wid,
    input  wire [127:0]  wdata,
    input  wire [15:0]   wstrb,
    input  wire          wlast,
    input  wire          wvalid,
    output wire          wready,

    output wire [7:0]    bid,
    output wire [1:0]    bresp,
    output wire          bvalid,
    input  wire          bready,

    input  wire [7:0]    arid,
    input  wire [31:0]   araddr,
    input  wire [3:0]    arlen,
    input  wire [2:0]    arsize,
    input  wire [1:0]    arburst,
    input  wire [1:0]    arlock,
    input  wire [3:0]    arcache,
    input  wire [2:0]    arprot,
    input  wire [4:0]    aruser,
    input  wire          arvalid,
    output wire          arready,

    output wire [7:0]    rid,
    output wire [127:0]  rdata,
    output wire [1:0]    rresp,
    output wire          rlast,
    output wire          rvalid,
    input  wire          rready
);
    de1sim_hps_axi_port #(.PORT(6)) port (
        .clk(clk), .port_size_config(port_size_config), .awid(awid), .awaddr(awaddr),
        .awlen(awlen), .awsize(awsize), .awburst(awburst), .awlock(awlock), .awcache(awcache),
        .awprot(awprot), .awuser(awuser), .awvalid(awvalid), .awready(awready), .wid(wid),
        .wdata(wdata), .wstrb(wstrb), .wlast(wlast), .wvalid(wvalid), .wready(wready), .bid(bid),
        .bresp(bresp), .bvalid(bvalid), .bready(bready), .arid(arid), .araddr(araddr),
        .arlen(arlen), .arsize(arsize), .arburst(arburst), .arlock(arlock), .arcache(arcache),
        .arprot(arprot), .aruser(aruser), .arvalid(arvalid), .arready(arready), .rid(rid),
        .rdata(rdata), .rresp(rresp), .rlast(rlast), .rvalid(rvalid), .rready(rready)
    );
endmodule

`default_nettype wire
