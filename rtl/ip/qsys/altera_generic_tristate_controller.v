// altera_generic_tristate_controller.v - Platform Designer's controller of an SRAM, a flash or
// another device on a bus outside, which altera_tristate_conduit_bridge joins with the pins
//
// A transfer has the timing of an Avalon-MM slave (de1sim_avalon_slave.v), as soon as the bus is
// granted.  A write waits TURNAROUND clocks, and LATENCY, after a read.
//
// Source: Platform Designer User Guide, Generic Tri-State Controller; Avalon Interface
// Specifications, Avalon Tri-State Conduit Interfaces.

`default_nettype none

module altera_generic_tristate_controller #(
    parameter ADDRESS    = 21,  // bits, of bytes
    parameter WIDTH      = 16,
    parameter SETUP      = 0,   // clocks
    parameter READ_WAIT  = 1,
    parameter WRITE_WAIT = 0,
    parameter HOLD       = 0,
    parameter TURNAROUND = 2,
    parameter LATENCY    = 2,
    parameter WAITS      = 0,   // 1: the device has waitrequest
    parameter SELECTED   = 0,   // 1: chipselect stays until the data of a read are there
    parameter BYTES      = WIDTH / 8
) (
    input  wire               clk,
    input  wire               reset,

    input  wire [ADDRESS-1:0] uas_address,
    input  wire               uas_read,
    input  wire               uas_write,
    input  wire [BYTES-1:0]   uas_byteenable,
    input  wire [WIDTH-1:0]   uas_writedata,
    output wire [WIDTH-1:0]   uas_readdata,
    output wire               uas_readdatavalid,
    output wire               uas_waitrequest,

    output wire               tcm_request,
    input  wire               tcm_grant,
    output wire [ADDRESS-1:0] tcm_address_out,
    output wire               tcm_read_out, tcm_read_n_out,
    output wire               tcm_write_out, tcm_write_n_out,
    output wire               tcm_chipselect_out, tcm_chipselect_n_out,
    output wire               tcm_outputenable_out, tcm_outputenable_n_out,
    output wire               tcm_begintransfer_out, tcm_begintransfer_n_out,
    output wire               tcm_reset_out, tcm_reset_n_out,
    output wire [BYTES-1:0]   tcm_byteenable_out, tcm_byteenable_n_out,
    output wire [BYTES-1:0]   tcm_writebyteenable_out, tcm_writebyteenable_n_out,
    output wire [WIDTH-1:0]   tcm_data_out,
    output wire               tcm_data_outen,
    input  wire [WIDTH-1:0]   tcm_data_in,
    input  wire               tcm_waitrequest_in
);
    // ---- When a transfer may run ----
    localparam [7:0] AFTER_READ = TURNAROUND + LATENCY;
    reg  [7:0] since_read_q = 8'd0;   // clocks until a write may begin
    reg  [6:0] reads_q = 7'd0;        // reads whose data are to come
    wire       asks = uas_read || (uas_write && since_read_q == 8'd0);
    wire       ends, answer;

    assign tcm_request     = uas_read || uas_write || since_read_q != 8'd0 || reads_q != 7'd0;
    assign uas_waitrequest = !ends;

    // ---- The transfer, and which answers are of reads ----
    reg        read_q [0:63];
    reg  [5:0] first_q = 6'd0, end_q = 6'd0;
    wire       selected;

    de1sim_avalon_slave #(
        .WIDTH(WIDTH), .ADDRESS(ADDRESS), .SHIFT(0), .SETUP(SETUP), .READ_WAIT(READ_WAIT),
        .WRITE_WAIT(WRITE_WAIT), .HOLD(HOLD), .LATENCY(LATENCY), .WAITREQUEST(WAITS)
    ) device (
        .clk_i(clk), .rst_i(reset), .valid_i(asks && tcm_grant), .ready_o(ends),
        .write_i(uas_write), .address_i({{32-ADDRESS{1'b0}}, uas_address}),
        .wdata_i(uas_writedata), .be_i(uas_byteenable), .length_i(12'd1), .rvalid_o(answer),
        .rdata_o(uas_readdata), .address_o(tcm_address_out), .chipselect_o(selected),
        .read_o(tcm_read_out), .write_o(tcm_write_out), .begintransfer_o(tcm_begintransfer_out),
        .byteenable_o(tcm_byteenable_out), .writedata_o(tcm_data_out), .readdata_i(tcm_data_in),
        .waitrequest_i(tcm_waitrequest_in), .readdatavalid_i(1'b0)
    );
    assign uas_readdatavalid = answer && read_q[first_q];

    always @(posedge clk) begin
        if (ends) begin
            read_q[end_q] <= !uas_write;
            end_q         <= end_q + 6'd1;
        end
        if (answer) first_q <= first_q + 6'd1;
        reads_q      <= reads_q + {6'd0, ends && !uas_write} - {6'd0, uas_readdatavalid};
        since_read_q <= tcm_read_out ? AFTER_READ
                        : since_read_q == 8'd0 ? 8'd0 : since_read_q - 8'd1;
        if (reset) begin
            {first_q, end_q} <= 12'd0;
            reads_q          <= 7'd0;
            since_read_q     <= 8'd0;
        end
    end

    // ---- The device's signals ----
    assign tcm_chipselect_out        = selected || (SELECTED != 0 && reads_q != 7'd0);
    assign tcm_outputenable_out      = tcm_read_out;
    assign tcm_data_outen            = selected && uas_write;
    assign tcm_writebyteenable_out   = tcm_byteenable_out & {BYTES{tcm_write_out}};
    assign tcm_reset_out             = reset;
    assign tcm_read_n_out            = !tcm_read_out;
    assign tcm_write_n_out           = !tcm_write_out;
    assign tcm_chipselect_n_out      = !tcm_chipselect_out;
    assign tcm_outputenable_n_out    = !tcm_outputenable_out;
    assign tcm_begintransfer_n_out   = !tcm_begintransfer_out;
    assign tcm_reset_n_out           = !tcm_reset_out;
    assign tcm_byteenable_n_out      = ~tcm_byteenable_out;
    assign tcm_writebyteenable_n_out = ~tcm_writebyteenable_out;
endmodule

`default_nettype wire
