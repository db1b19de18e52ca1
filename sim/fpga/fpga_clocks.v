// fpga_clocks.v - in the simulation: clocks of groups that sleep, and how many can be left out
//
//   clk_i --> root_clock --+--> clk_o: the beam, the numbering of the clocks
//                          +--> group_clock --> lw_clk_o ... audio_clk_o
//
// A group gets a clock if a block of it is awake or due, or if one of its inputs from outside has
// moved.  fabric.cpp drives `moved` and `skip`, and reads the rest.

`default_nettype none

module fpga_clocks (
    input  wire clk_i,
    input  wire rst_i,
    input  wire lw_awake_i,
    input  wire h2f_awake_i,
    input  wire memory_awake_i,
    // Always while it fetches; here only in the clocks in which it does.
    // verilator lint_off UNUSED
    input  wire fetch_awake_i,
    // verilator lint_on UNUSED
    input  wire audio_awake_i,
    input  wire ports_awake_i,
    input  wire td_awake_i,

    output wire clk_o,
    output wire lw_clk_o,
    output wire h2f_clk_o,
    output wire memory_clk_o,
    output wire ports_clk_o,
    output wire audio_clk_o
);
    // An input has moved since the clock before: bit 0 of lw_*, 1 of h2f_*, 2 of the pins; all in a
    // reset.
    reg  [2:0]  moved /* verilator public_flat_rw */;
    reg  [9:0]  skip  /* verilator public_flat_rw */;       // clocks after this one left out
    wire [9:0]  rest  /* verilator public_flat_rd */;       // how many that may be
    wire        pins_may_move /* verilator public_flat_rd */;   // others than the beam may
    wire        td_awake /* verilator public_flat_rd */ = td_awake_i;

    // ---- Who waits ----------------------------------------------------------
    wire        timer0_due, timer1_due, keypad_due, ps2_due, sdram_due;
    wire [9:0]  timer0_rest, timer1_rest, keypad_rest, ps2_rest, sdram_rest, beam_rest;
    wire        fetch_busy, fetch_sdram, fetch_odd, line_end;

    waiting_blocks waiting (
        .timer0_due_o(timer0_due), .timer1_due_o(timer1_due), .keypad_due_o(keypad_due),
        .ps2_due_o(ps2_due), .sdram_due_o(sdram_due),
        .timer0_rest_o(timer0_rest), .timer1_rest_o(timer1_rest), .keypad_rest_o(keypad_rest),
        .ps2_rest_o(ps2_rest), .sdram_rest_o(sdram_rest), .beam_rest_o(beam_rest),
        .fetch_busy_o(fetch_busy), .fetch_sdram_o(fetch_sdram), .fetch_odd_o(fetch_odd),
        .line_end_o(line_end)
    );

    // The picture's fetch from the on-chip memory goes on in odd clocks of the line alone.
    wire        fetch_due  = line_end || (fetch_busy && fetch_odd);
    wire [9:0]  fetch_rest = fetch_busy ? {9'd0, fetch_odd} : 10'd1023;

    // ---- Groups -------------------------------------------------------------
    wire memory_wakes = memory_awake_i || (fetch_busy && fetch_sdram) || sdram_due;
    wire ports_wakes  = ports_awake_i || keypad_due || ps2_due || timer0_due || timer1_due;

    wire lw_awake     = lw_awake_i || moved[0];
    wire h2f_awake    = h2f_awake_i || moved[1];
    wire memory_awake = memory_wakes || fetch_due || rst_i;
    wire ports_awake  = ports_wakes || moved[2];
    wire audio_awake  = audio_awake_i || moved[2];

    root_clock root (.clk_i(clk_i), .clk_o(clk_o));
    group_clock lw_group (.clk_i(clk_o), .awake_i(lw_awake), .clk_o(lw_clk_o));
    group_clock h2f_group (.clk_i(clk_o), .awake_i(h2f_awake), .clk_o(h2f_clk_o));
    group_clock memory_group (.clk_i(clk_o), .awake_i(memory_awake), .clk_o(memory_clk_o));
    group_clock ports_group (.clk_i(clk_o), .awake_i(ports_awake), .clk_o(ports_clk_o));
    group_clock audio_group (.clk_i(clk_o), .awake_i(audio_awake), .clk_o(audio_clk_o));

    assign pins_may_move = ports_wakes || audio_awake_i;

    // ---- Time ---------------------------------------------------------------
    reg  [29:0] now;                         // the number of the clock

    always @(posedge clk_o) now <= now + 30'd1 + {20'd0, skip};

    function [9:0] least;
        input [9:0] a;
        input [9:0] b;
        least = a < b ? a : b;
    endfunction

    // Of the registers that sleep, when the first wakes by itself.
    wire [9:0] ports_rest
        = least(least(keypad_rest, ps2_rest), least(timer0_rest, timer1_rest));

    // While a group is awake it may wake another one in any clock, so no clock can be left out.
    wire awake = lw_awake_i || h2f_awake_i || memory_wakes || ports_wakes || audio_awake_i;

    assign rest = awake ? 10'd0
                  : least(least(least(beam_rest, fetch_rest), sdram_rest), ports_rest);
endmodule

`default_nettype wire
