// de1sim_st_adapter.v - Platform Designer's adapters of streams: between a source and a sink that
// differ in their signals, the symbols of a beat, or the ready latency
//
//   in -> channel, error -> timing -> symbols of a beat -> timing -> out
//
// A sink without a channel, or with a smaller one, does not get what has a channel above
// MAX_CHANNEL.  An error bit of the sink is the one of the same number; where they are NAMED, it is
// those of MAP, which has IN_ERROR bits for each of them.  What a side has not is 0, or
// always valid, or always ready.
//
// Source: Platform Designer User Guide, Avalon Streaming Adapters.

`default_nettype none

module de1sim_st_adapter #(
    parameter SYMBOL      = 8,
    parameter IN_SYMBOLS  = 1,   // of a beat
    parameter OUT_SYMBOLS = 1,
    parameter IN_EMPTY    = 0,   // bits; 0 = the side has no such signal
    parameter OUT_EMPTY   = 0,
    parameter IN_CHANNEL  = 0,
    parameter OUT_CHANNEL = 0,
    parameter MAX_CHANNEL = -1,  // -1 = all pass
    parameter IN_ERROR    = 0,
    parameter OUT_ERROR   = 0,
    parameter NAMED       = 0,
    parameter MAP         = 0,
    parameter IN_VALID    = 1,
    parameter IN_READY    = 1,
    parameter IN_LATENCY  = 0,
    parameter OUT_READY   = 1,
    parameter OUT_LATENCY = 0,
    parameter RESET_N     = 0    // 1 = reset_n is the reset
) (
    input  wire                                         clk,
    // verilator lint_off UNUSED
    input  wire                                         reset,
    input  wire                                         reset_n,
    input  wire                                         in_valid,
    output wire                                         in_ready,
    input  wire [IN_SYMBOLS*SYMBOL-1:0]                 in_data,
    input  wire                                         in_startofpacket,
    input  wire                                         in_endofpacket,
    input  wire [(IN_EMPTY>0?IN_EMPTY:1)-1:0]           in_empty,
    input  wire [(IN_CHANNEL>0?IN_CHANNEL:1)-1:0]       in_channel,
    input  wire [(IN_ERROR>0?IN_ERROR:1)-1:0]           in_error,
    input  wire                                         out_ready,
    // verilator lint_on UNUSED

    output wire                                         out_valid,
    output wire [OUT_SYMBOLS*SYMBOL-1:0]                out_data,
    output wire                                         out_startofpacket,
    output wire                                         out_endofpacket,
    output wire [(OUT_EMPTY>0?OUT_EMPTY:1)-1:0]         out_empty,
    output wire [(OUT_CHANNEL>0?OUT_CHANNEL:1)-1:0]     out_channel,
    output wire [(OUT_ERROR>0?OUT_ERROR:1)-1:0]         out_error
);
    localparam CHANNEL = OUT_CHANNEL > 0 ? OUT_CHANNEL : 1;
    localparam ERROR   = OUT_ERROR > 0 ? OUT_ERROR : 1;
    localparam SIDE    = 2 + 10 + CHANNEL + ERROR;   // sop, eop, empty, channel, error
    localparam IN      = IN_SYMBOLS * SYMBOL, OUT = OUT_SYMBOLS * SYMBOL;
    localparam BITS    = IN_ERROR * OUT_ERROR + IN_ERROR + 1;
    localparam [BITS-1:0] BIT_MAP = MAP;

    wire             rst = RESET_N != 0 ? !reset_n : reset;

    // ---- What goes with the data ----
    // A signal that a side has not is one bit here, and MAX_CHANNEL may be the greatest there is.
    // verilator lint_off WIDTH
    // verilator lint_off CMPCONST
    wire [CHANNEL-1:0] channel = IN_CHANNEL > 0 ? in_channel : 0;
    wire [9:0]       empty   = IN_EMPTY > 0 ? in_empty : 0;
    wire             is_in   = MAX_CHANNEL < 0 || in_channel <= MAX_CHANNEL;
    // verilator lint_on CMPCONST
    // verilator lint_on WIDTH
    wire [ERROR-1:0] error;
    genvar n;
    generate
        for (n = 0; n < ERROR; n = n + 1) begin : errors
            if (IN_ERROR == 0 || OUT_ERROR == 0) begin : none
                assign error[n] = 1'b0;
            end else if (NAMED != 0) begin : named
                assign error[n] = |(in_error & BIT_MAP[n*IN_ERROR +: IN_ERROR]);
            end else if (n < IN_ERROR) begin : numbered
                assign error[n] = in_error[n];
            end else begin : missing
                assign error[n] = 1'b0;
            end
        end
    endgenerate
    wire [SIDE-1:0]  side = {in_startofpacket, in_endofpacket, empty, channel, error};
    wire [SIDE-1:0]  out_side;
    wire [9:0]       last_empty;
    wire [CHANNEL-1:0] last_channel;
    wire [ERROR-1:0] last_error;

    assign {out_startofpacket, out_endofpacket, last_empty, last_channel, last_error} = out_side;
    assign out_empty   = last_empty[(OUT_EMPTY>0?OUT_EMPTY:1)-1:0];
    assign out_channel = last_channel;
    assign out_error   = last_error;

    // ---- Timing and width ----
    generate
        if (IN_SYMBOLS == OUT_SYMBOLS) begin : same
            de1sim_st_timing #(
                .WIDTH(IN + SIDE), .IN_LATENCY(IN_LATENCY), .IN_READY(IN_READY),
                .IN_VALID(IN_VALID), .OUT_LATENCY(OUT_LATENCY), .OUT_READY(OUT_READY)
            ) timing (
                .clk_i(clk), .rst_i(rst), .valid_i(in_valid && is_in), .ready_o(in_ready),
                .data_i({in_data, side}), .valid_o(out_valid), .ready_i(out_ready),
                .data_o({out_data, out_side})
            );
        end else begin : other
            wire            valid, ready, fits, fits_ready;
            wire [IN-1:0]   data;
            wire [OUT-1:0]  fitting;
            wire [SIDE-1:0] with_data, fitting_side;

            de1sim_st_timing #(
                .WIDTH(IN + SIDE), .IN_LATENCY(IN_LATENCY), .IN_READY(IN_READY),
                .IN_VALID(IN_VALID)
            ) ahead (
                .clk_i(clk), .rst_i(rst), .valid_i(in_valid && is_in), .ready_o(in_ready),
                .data_i({in_data, side}), .valid_o(valid), .ready_i(ready),
                .data_o({data, with_data})
            );
            de1sim_st_width #(
                .SYMBOL(SYMBOL), .IN(IN_SYMBOLS), .OUT(OUT_SYMBOLS), .CHANNEL(CHANNEL),
                .ERROR(ERROR)
            ) width (
                .clk_i(clk), .rst_i(rst), .valid_i(valid), .ready_o(ready), .data_i(data),
                .sop_i(with_data[SIDE-1]), .eop_i(with_data[SIDE-2]),
                .empty_i(with_data[SIDE-3 -: 10]), .channel_i(with_data[ERROR +: CHANNEL]),
                .error_i(with_data[ERROR-1:0]), .valid_o(fits), .ready_i(fits_ready),
                .data_o(fitting), .sop_o(fitting_side[SIDE-1]), .eop_o(fitting_side[SIDE-2]),
                .empty_o(fitting_side[SIDE-3 -: 10]),
                .channel_o(fitting_side[ERROR +: CHANNEL]), .error_o(fitting_side[ERROR-1:0])
            );
            de1sim_st_timing #(
                .WIDTH(OUT + SIDE), .OUT_LATENCY(OUT_LATENCY), .OUT_READY(OUT_READY)
            ) behind (
                .clk_i(clk), .rst_i(rst), .valid_i(fits), .ready_o(fits_ready),
                .data_i({fitting, fitting_side}), .valid_o(out_valid), .ready_i(out_ready),
                .data_o({out_data, out_side})
            );
        end
    endgenerate
endmodule

`default_nettype wire
