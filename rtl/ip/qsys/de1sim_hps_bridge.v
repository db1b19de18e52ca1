// de1sim_hps_bridge.v - a bridge of the processor to the FPGA: its bursts as commands
//
// Commands as in de1sim_avalon_decoder.v, one for each beat of a burst, and one at a time.

`default_nettype none

module de1sim_hps_bridge #(
    parameter FULL  = 0,   // 1: HPS-to-FPGA, 0: the lightweight one
    parameter WIDTH = 32,  // 32, 64 or 128
    parameter BYTES = WIDTH / 8
) (
    input  wire             clk_i,

    output wire             valid_o,
    input  wire             ready_i,
    output wire             write_o,
    output wire [15:0]      count_o,
    output wire [31:0]      address_o,
    output wire [WIDTH-1:0] wdata_o,
    output wire [BYTES-1:0] be_o,
    input  wire             rvalid_i,
    input  wire [WIDTH-1:0] rdata_i
);
    localparam [1:0] INCR = 2'd1;
    localparam [1:0] SIZE = WIDTH == 128 ? 2'd2 : WIDTH == 64 ? 2'd1 : 2'd0;

    reg              valid_q = 0;
    reg  [3:0]       beat_q = 0;
    wire             begins, ends, reset;

    de1sim_hps_port #(.FULL(FULL)) port (
        .clk_i(clk_i), .size_i(SIZE),
        .begins_o(begins), .ends_i(ends), .reset_o(reset), .waits_i(20'd0)
    );

    assign valid_o = valid_q;

`ifdef DE1SIM_LISTS
    assign {write_o, count_o, address_o, wdata_o, be_o} = {1 + 16 + 32 + WIDTH + BYTES{1'b0}};
    assign ends = 1'b0;
`else
    `include "de1sim_hps_bridge.vh"

    reg              write_q = 0;
    reg              joined_q = 0;  // its beats are whole words, one after the other
    reg  [3:0]       last_q = 0;
    reg  [31:0]      address_q = 0;
    reg  [WIDTH-1:0] wdata_q = 0;
    reg  [BYTES-1:0] be_q = 0;
    wire             next = rvalid_i && beat_q != last_q;

    assign ends      = rvalid_i && beat_q == last_q;
    assign write_o   = write_q;
    assign count_o   = joined_q ? {12'd0, last_q - beat_q} + 16'd1 : 16'd1;
    assign address_o = address_q;
    assign wdata_o   = wdata_q;
    assign be_o      = be_q;

    // verilator lint_off UNUSED
    reg  [63:0]      burst;
    reg  [127:0]     data;
    integer          strobes, address;
    // verilator lint_on UNUSED
    // verilator lint_off BLKSEQ
    always @(posedge clk_i) begin
        if (valid_q && ready_i) valid_q <= 1'b0;
        if (rvalid_i && !write_q)
            de1sim_hps_answered({28'd0, beat_q}, {{128-WIDTH{1'b0}}, rdata_i});
        if (begins) begin
            burst = de1sim_hps_burst();
            {write_q, last_q} <= {burst[62], burst[35:32]};
            joined_q <= burst[40:39] == INCR && 8 << burst[38:36] == WIDTH;
        end
        if (begins || next) begin
            strobes   = de1sim_hps_beat(begins ? 0 : {28'd0, beat_q} + 1, address, data);
            valid_q   <= 1'b1;
            beat_q    <= begins ? 4'd0 : beat_q + 4'd1;
            address_q <= address;
            wdata_q   <= data[WIDTH-1:0];
            be_q      <= strobes[BYTES-1:0];
        end
        if (reset) valid_q <= 1'b0;
    end
    // verilator lint_on BLKSEQ
`endif
endmodule

`default_nettype wire
