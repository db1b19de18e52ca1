// de1sim_up_blender.v - the University Program's alpha blender: a foreground over a background
//
// Both pictures are brought together by their first pixels.  SIMPLE: where alpha is 0 there is the
// background, elsewhere the foreground; else each colour is mixed in 1,024 steps.

`default_nettype none

module de1sim_up_blender #(parameter SIMPLE = 0) (
    // verilator lint_off UNUSED
    input  wire        clk,
    input  wire        reset,
    // verilator lint_on UNUSED
    input  wire [29:0] background_data,
    input  wire        background_startofpacket,
    input  wire        background_endofpacket,
    input  wire        background_valid,
    output wire        background_ready,
    input  wire [39:0] foreground_data,      // alpha, red, green, blue
    input  wire        foreground_startofpacket,
    // verilator lint_off UNUSED
    input  wire        foreground_endofpacket,
    // verilator lint_on UNUSED
    input  wire        foreground_valid,
    output wire        foreground_ready,
    output wire [29:0] output_data,
    output wire        output_startofpacket,
    output wire        output_endofpacket,
    output wire        output_valid,
    input  wire        output_ready
);
    function [9:0] mixed;
        input [9:0] fore;
        input [9:0] back;
        input [9:0] alpha;
        reg [20:0] sum;
        begin
            sum = fore * ({11'd0, alpha} + 21'd1) + back * (21'd1023 - {11'd0, alpha});
            mixed = sum[19:10];
        end
    endfunction

    wire [9:0] alpha = foreground_data[39:30];
    wire both  = background_valid && foreground_valid;
    wire fits  = background_startofpacket == foreground_startofpacket;

    assign output_valid = both && fits;
    assign background_ready = both && (fits ? output_ready : !background_startofpacket);
    assign foreground_ready = both && (fits ? output_ready : !foreground_startofpacket);
    assign output_startofpacket = background_startofpacket;
    assign output_endofpacket   = background_endofpacket;
    assign output_data = alpha == 10'd0 ? background_data
                       : SIMPLE != 0 ? foreground_data[29:0]
                       : {mixed(foreground_data[29:20], background_data[29:20], alpha),
                          mixed(foreground_data[19:10], background_data[19:10], alpha),
                          mixed(foreground_data[9:0], background_data[9:0], alpha)};
endmodule

`default_nettype wire
