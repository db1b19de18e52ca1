// de1sim_hps_avalon_port.v - an Avalon-MM port to the processor's SDRAM

`default_nettype none

module de1sim_hps_avalon_port #(
    parameter PORT  = 0,
    parameter WIDTH = 64,  // 32 to 256
    parameter BYTES = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire [29:0]      address_i,  // in words
    input  wire [7:0]       burstcount_i,
    input  wire             read_i,
    input  wire             write_i,
    input  wire [WIDTH-1:0] writedata_i,
    input  wire [BYTES-1:0] byteenable_i,
    output wire             waitrequest_o,
    output wire [WIDTH-1:0] readdata_o,
    output wire             readdatavalid_o
);
    localparam [1:0] SIZE = WIDTH == 32 ? 2'd0 : WIDTH == 64 ? 2'd1 : WIDTH == 128 ? 2'd2 : 2'd3;

    wire         ready;
    // verilator lint_off UNUSED
    wire [255:0] readdata;
    wire [10:0]  rd_end;
    wire         wr_ready, wrack_valid;
    wire [9:0]   wrack_data;
    // verilator lint_on UNUSED

    de1sim_hps_sdram_port #(.PORT(PORT)) port (
        .clk_i(clk_i), .is_axi_i(1'b0), .width_i(SIZE),
        .cmd_valid_i(read_i || write_i), .cmd_ready_o(ready),
        .cmd_data_i({18'd0, burstcount_i, 2'd0, address_i, write_i, read_i}),
        .rd_valid_o(readdatavalid_o), .rd_ready_i(1'b1), .rd_data_o(readdata), .rd_end_o(rd_end),
        .wr_valid_i(1'b0), .wr_ready_o(wr_ready),
        .wr_data_i({{256-WIDTH{1'b0}}, writedata_i}),
        .wr_strobes_i({{32-BYTES{1'b0}}, byteenable_i}),
        .wrack_valid_o(wrack_valid), .wrack_ready_i(1'b1), .wrack_data_o(wrack_data)
    );

    assign waitrequest_o = !ready;
    assign readdata_o    = readdata[WIDTH-1:0];
endmodule

`default_nettype wire
