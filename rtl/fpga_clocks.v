// fpga_clocks.v - a clock for each group of blocks that sleep together (README.md, Sleep)
//
//   clk_i --> root_clock --+--> clk_o: the beam, the numbering of the clocks
//                          +--> group_clock --> lw_clk_o ... audio_clk_o
//
// A group gets a clock if it wakes or if one of its inputs from outside has moved.  In a reset all
// of moved_i is 1.

`default_nettype none

module fpga_clocks (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire [2:0]  moved_i,        // as fpga.v says
    input  wire [9:0]  skip_i,
    output wire [9:0]  rest_o,
    output wire        stirs_o,

    input  wire        lw_wakes_i,     // a block is awake or due, or another group accesses it
    input  wire        h2f_wakes_i,
    input  wire        memory_wakes_i,
    input  wire        fetch_due_i,    // of the memories' group, and wakes no other
    input  wire        audio_wakes_i,
    input  wire        ports_wakes_i,
    input  wire [9:0]  beam_rest_i,    // rest_o of the blocks that wait
    input  wire [9:0]  fetch_rest_i,
    input  wire [9:0]  sdram_rest_i,
    input  wire [9:0]  keypad_rest_i,
    input  wire [9:0]  ps2_rest_i,
    input  wire [9:0]  timer0_rest_i,
    input  wire [9:0]  timer1_rest_i,

    output wire        clk_o,
    output wire        lw_clk_o,
    output wire        h2f_clk_o,
    output wire        memory_clk_o,
    output wire        ports_clk_o,
    output wire        audio_clk_o,
    output wire [29:0] now_o
);
    wire lw_awake    = lw_wakes_i || moved_i[0];
    wire h2f_awake   = h2f_wakes_i || moved_i[1];
    wire memory_awake = memory_wakes_i || fetch_due_i || rst_i;
    wire ports_awake = ports_wakes_i || moved_i[2];
    wire audio_awake = audio_wakes_i || moved_i[2];

    root_clock root (.clk_i(clk_i), .clk_o(clk_o));
    group_clock lw_group (.clk_i(clk_o), .awake_i(lw_awake), .clk_o(lw_clk_o));
    group_clock h2f_group (.clk_i(clk_o), .awake_i(h2f_awake), .clk_o(h2f_clk_o));
    group_clock memory_group (.clk_i(clk_o), .awake_i(memory_awake), .clk_o(memory_clk_o));
    group_clock ports_group (.clk_i(clk_o), .awake_i(ports_awake), .clk_o(ports_clk_o));
    group_clock audio_group (.clk_i(clk_o), .awake_i(audio_awake), .clk_o(audio_clk_o));

    timebase base (.clk_i(clk_o), .rst_i(rst_i), .skip_i(skip_i), .now_o(now_o));

    assign stirs_o = ports_wakes_i || audio_wakes_i;

    function [9:0] least;
        input [9:0] a;
        input [9:0] b;
        least = a < b ? a : b;
    endfunction

    // While a group is awake it may wake another one in any clock, so no clock can be left out.
    wire awake = lw_wakes_i || h2f_wakes_i || memory_wakes_i || ports_wakes_i || audio_wakes_i;

    assign rest_o = awake ? 10'd0
                    : least(least(least(beam_rest_i, fetch_rest_i), sdram_rest_i),
                            least(least(keypad_rest_i, ps2_rest_i),
                                  least(timer0_rest_i, timer1_rest_i)));
endmodule

`default_nettype wire
