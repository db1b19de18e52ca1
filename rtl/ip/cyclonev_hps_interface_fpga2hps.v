// cyclonev_hps_interface_fpga2hps.v - the FPGA-to-HPS bridge: the processor's memory and
// peripherals for a master in the FPGA
//
// Addresses: DDR3 from 0 to 0x3FFFFFFF, and once more from 0x80000000 on, where the board's
// accesses are coherent with the processor's caches; peripherals and on-chip RAM where the
// processor has them; the bridges to the FPGA answer DECERR.
//
// Not handled: exclusive accesses; AxCACHE, AxPROT and AxUSER, which change nothing.

`default_nettype none

module cyclonev_hps_interface_fpga2hps #(
    // The device's primitive has no parameters.  A Platform Designer system has an AXI port of
    // fpga2sdram by these.
    parameter command_port = 6, COMMAND_PORT = command_port,  // as in de1sim_hps_memory.vh
    parameter width = 128, WIDTH = width   // 32 to 256
) (
    input  wire                   clk,
    input  wire [1:0]             port_size_config,  // 0: 32 bits, 1: 64, 2: 128, 3: 256, or unused
    input  wire [7:0]             awid,
    input  wire [31:0]            awaddr,
    input  wire [3:0]             awlen,
    input  wire [2:0]             awsize,
    input  wire [1:0]             awburst,
    input  wire [1:0]             awlock,
    input  wire [3:0]             awcache,
    input  wire [2:0]             awprot,
    input  wire [4:0]             awuser,
    input  wire                   awvalid,
    output wire                   awready,

    input  wire [7:0]             wid,
    input  wire [WIDTH-1:0]       wdata,
    input  wire [WIDTH/8-1:0]     wstrb,
    input  wire                   wlast,
    input  wire                   wvalid,
    output wire                   wready,

    output wire [7:0]             bid,
    output wire [1:0]             bresp,
    output wire                   bvalid,
    input  wire                   bready,

    input  wire [7:0]             arid,
    input  wire [31:0]            araddr,
    input  wire [3:0]             arlen,
    input  wire [2:0]             arsize,
    input  wire [1:0]             arburst,
    input  wire [1:0]             arlock,
    input  wire [3:0]             arcache,
    input  wire [2:0]             arprot,
    input  wire [4:0]             aruser,
    input  wire                   arvalid,
    output wire                   arready,

    output wire [7:0]             rid,
    output wire [WIDTH-1:0]       rdata,
    output wire [1:0]             rresp,
    output wire                   rlast,
    output wire                   rvalid,
    input  wire                   rready
);
    wire [5:0]   bytes = 6'd4 << port_size_config;
    wire         used  = WIDTH == 256 || port_size_config != 2'd3;
    // verilator lint_off UNUSED
    wire [255:0] word;
    wire         is_last;
    // verilator lint_on UNUSED

    de1sim_hps_reads #(.PORT(COMMAND_PORT)) reads (
        .clk_i(clk), .width_i(bytes),
        .valid_i(arvalid && used), .ready_o(arready), .address_i(araddr),
        .beats_i({4'd0, arlen} + 8'd1), .size_i(arsize), .burst_i(arburst), .id_i(arid),
        .valid_o(rvalid), .ready_i(rready), .data_o(word), .response_o(rresp), .last_o(rlast),
        .id_o(rid)
    );
    assign rdata = word[WIDTH-1:0];

    de1sim_hps_writes #(.PORT(COMMAND_PORT)) writes (
        .clk_i(clk), .width_i(bytes),
        .valid_i(awvalid && used), .ready_o(awready), .address_i(awaddr),
        .beats_i({4'd0, awlen} + 8'd1), .size_i(awsize), .burst_i(awburst), .id_i(awid),
        .data_valid_i(wvalid), .data_ready_o(wready), .data_last_o(is_last),
        .data_i({{256-WIDTH{1'b0}}, wdata}), .strobes_i({{32-WIDTH/8{1'b0}}, wstrb}),
        .valid_o(bvalid), .ready_i(bready), .response_o(bresp), .id_o(bid)
    );

    // verilator lint_off UNUSED
    wire unused = &{1'b0, awlock, awcache, awprot, awuser, wid, wlast, arlock, arcache, arprot,
                    aruser};
    // verilator lint_on UNUSED
endmodule

`default_nettype wire
