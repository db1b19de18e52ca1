// de1sim_axi_slave.v - commands as transfers of an AXI slave, one of a word at a time
//
// Commands and answers as in de1sim_avalon_decoder.v; an answer comes a clock after BVALID or
// RVALID.  A slave that has IDs gets another one with each transfer, as the processor makes them
// for its reads; what it answers with another ID is no answer.
//
// Source: AMBA AXI Protocol Specification, channels and handshakes.
//
// Not handled: BRESP, RRESP; bursts, which are divided before.

`default_nettype none

module de1sim_axi_slave #(
    parameter WIDTH   = 32,
    parameter ADDRESS = 12,
    parameter ID      = 1,  // bits
    parameter BYTES   = WIDTH / 8
) (
    input  wire               clk_i,
    input  wire               rst_i,

    input  wire               valid_i,
    output wire               ready_o,
    input  wire               write_i,
    // verilator lint_off UNUSED
    input  wire [31:0]        address_i,
    // verilator lint_on UNUSED
    input  wire [WIDTH-1:0]   wdata_i,
    input  wire [BYTES-1:0]   be_i,
    output reg                rvalid_o,
    output reg  [WIDTH-1:0]   rdata_o,

    output wire [ID-1:0]      id_o,       // AWID, WID, ARID
    output wire [ADDRESS-1:0] awaddr_o,
    output wire               awvalid_o,
    input  wire               awready_i,
    output wire [WIDTH-1:0]   wdata_o,
    output wire [BYTES-1:0]   wstrb_o,
    output wire               wvalid_o,
    input  wire               wready_i,
    input  wire [ID-1:0]      bid_i,
    input  wire               bvalid_i,
    output wire               bready_o,
    output wire [ADDRESS-1:0] araddr_o,
    output wire               arvalid_o,
    input  wire               arready_i,
    input  wire [ID-1:0]      rid_i,
    input  wire [WIDTH-1:0]   axi_rdata_i,
    input  wire               axi_rvalid_i,
    output wire               axi_rready_o
);
    // The channels that have taken this transfer.
    reg aw_q = 0, w_q = 0, ar_q = 0;

    wire runs = valid_i && !rst_i;

    assign awaddr_o     = address_i[ADDRESS-1:0];
    assign araddr_o     = address_i[ADDRESS-1:0];
    assign awvalid_o    = runs && write_i && !aw_q;
    assign wvalid_o     = runs && write_i && !w_q;
    assign arvalid_o    = runs && !write_i && !ar_q;
    assign wdata_o      = wdata_i;
    assign wstrb_o      = be_i;
    assign bready_o     = aw_q && w_q;
    assign axi_rready_o = ar_q;
    assign ready_o      = (bready_o && bvalid_i && bid_i == id_o)
                          || (axi_rready_o && axi_rvalid_i && rid_i == id_o);

    reg  [1:0]     number_q = 0;
    // verilator lint_off UNUSED
    wire [ID+11:0] id = {{ID+5{1'b0}}, number_q, 5'b11010};
    // verilator lint_on UNUSED
    assign id_o = id[ID-1:0];

    always @(posedge clk_i) begin
        if (ready_o) number_q <= number_q + 2'd1;
        aw_q     <= !ready_o && (aw_q || (awvalid_o && awready_i));
        w_q      <= !ready_o && (w_q || (wvalid_o && wready_i));
        ar_q     <= !ready_o && (ar_q || (arvalid_o && arready_i));
        rvalid_o <= ready_o && !rst_i;
        rdata_o  <= axi_rready_o ? axi_rdata_i : {WIDTH{1'b0}};
        if (rst_i) {aw_q, w_q, ar_q} <= 3'b000;
    end
endmodule

`default_nettype wire
