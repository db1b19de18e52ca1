// de1sim_up_resampler.v - the University Program's RGB resampler: pixels of one format as those of
// another
//
// A format is its bits: 1 black and white, 8 grey (-8: RGB 3-3-2), 9, 16 (5-6-5), 24, 30 RGB; with
// alpha in front of red 17 (4-4-4-4, 16 bits), 32, 40.  A colour of fewer bits is repeated until it
// has as many as are wanted; of one with more the upper ones count.

`default_nettype none

module de1sim_up_resampler #(
    parameter FROM  = 16,
    parameter TO    = 30,
    parameter IN    = 16,          // bits of the streams
    parameter OUT   = 30,
    parameter ALPHA = 1023         // of a format that has none
) (
    // verilator lint_off UNUSED
    input  wire           clk,
    input  wire           reset,
    input  wire           slave_read,
    // verilator lint_on UNUSED
    output wire [31:0]    slave_readdata,

    input  wire [IN-1:0]  stream_in_data,
    input  wire           stream_in_startofpacket,
    input  wire           stream_in_endofpacket,
    input  wire           stream_in_valid,
    output wire           stream_in_ready,
    output wire [OUT-1:0] stream_out_data,
    output wire           stream_out_startofpacket,
    output wire           stream_out_endofpacket,
    output wire           stream_out_valid,
    input  wire           stream_out_ready
);
    wire [39:0] in = {{(40-IN){1'b0}}, stream_in_data};
    reg  [9:0]  a, r, g, b;

    always @* begin
        a = ALPHA[9:0];
        case (FROM)
            1:  {r, g, b} = {30{in[0]}};
            8:  {r, g, b} = {3{in[7:0], in[7:6]}};
            -8: {r, g, b} = {{3{in[7:5]}}, in[7], {3{in[4:2]}}, in[4], {5{in[1:0]}}};
            9:  {r, g, b} = {{3{in[8:6]}}, in[8], {3{in[5:3]}}, in[5], {3{in[2:0]}}, in[2]};
            16: {r, g, b} = {{2{in[15:11]}}, in[10:5], in[10:7], {2{in[4:0]}}};
            24, 32:
                {r, g, b} = {in[23:16], in[23:22], in[15:8], in[15:14], in[7:0], in[7:6]};
            17: {r, g, b} = {{2{in[11:8]}}, in[11:10], {2{in[7:4]}}, in[7:6], {2{in[3:0]}},
                             in[3:2]};
            default: {r, g, b} = in[29:0];
        endcase
        if (FROM == 17) a = {{2{in[15:12]}}, in[15:14]};
        if (FROM == 32) a = {in[31:24], in[31:30]};
        if (FROM == 40) a = in[39:30];
    end

    // Brightness as the core computes it: a half of green, a quarter each of red and blue.
    wire [11:0] grey = {2'b0, r} + {1'b0, g, 1'b0} + {2'b0, b};
    reg  [39:0] out;
    always @* case (TO)
        1:       out = {39'd0, grey[11]};
        8:       out = {32'd0, grey[11:4]};
        -8:      out = {32'd0, r[9:7], g[9:7], b[9:8]};
        9:       out = {31'd0, r[9:7], g[9:7], b[9:7]};
        16:      out = {24'd0, r[9:5], g[9:4], b[9:5]};
        17:      out = {24'd0, a[9:6], r[9:6], g[9:6], b[9:6]};
        24:      out = {16'd0, r[9:2], g[9:2], b[9:2]};
        32:      out = {8'd0, a[9:2], r[9:2], g[9:2], b[9:2]};
        default: out = {a, r, g, b};
    endcase

    assign slave_readdata           = {22'd0, ALPHA[9:0]};
    assign stream_out_data          = out[OUT-1:0];
    assign stream_out_startofpacket = stream_in_startofpacket;
    assign stream_out_endofpacket   = stream_in_endofpacket;
    assign stream_out_valid         = stream_in_valid;
    assign stream_in_ready          = stream_out_ready;
endmodule

`default_nettype wire
