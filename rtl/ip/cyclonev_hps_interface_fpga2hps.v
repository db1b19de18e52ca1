// cyclonev_hps_interface_fpga2hps.v - the FPGA-to-HPS bridge: it takes nothing

`default_nettype none

module cyclonev_hps_interface_fpga2hps (
    input  wire          clk,
    input  wire [1:0]    port_size_config,
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
    assign {awready, wready, bid, bresp, bvalid} = 13'd0;
    assign {arready, rid, rdata, rresp, rlast, rvalid} = 141'd0;
    // verilator lint_off UNUSED
    wire unused = &{1'b0, clk, port_size_config, awid, awaddr, awlen, awsize, awburst, awlock,
                    awcache, awprot, awuser, awvalid, wid, wdata, wstrb, wlast, wvalid, bready,
                    arid, araddr, arlen, arsize, arburst, arlock,
                    arcache, arprot, aruser, arvalid, rready};
    // verilator lint_on UNUSED
endmodule

`default_nettype wire
