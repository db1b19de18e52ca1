// inside.v - what the simulation's own modules read of each other, by its place in fpga.v
//
// Not by ports: those of rtl/ are the hardware's.  The proofs read these lines, too
// (tb/formal/block.py).

`default_nettype none

// verilator lint_off DECLFILENAME

// The number of the present clock.
module clock_number (output wire [29:0] now_o);
    assign now_o = fpga.clocks.now;
endmodule

// Whether the block of 16 pixels that is read from the line buffer is flat.
module flat_block (output wire flat_o);
    assign flat_o = fpga.video_block.rows.flat;
endmodule

// vga_timing.v's clocks of rest.
module beam_rest (output wire [9:0] rest_o);
    assign rest_o = fpga.video_block.vga_block.timing.rest;
endmodule

// Blocks that wait: whether this is the clock for which they have waited, and for how many clocks
// after this one it is not.
module waiting_blocks (
    output wire       timer0_due_o,
    output wire       timer1_due_o,
    output wire       keypad_due_o,
    output wire       ps2_due_o,
    output wire       sdram_due_o,
    output wire [9:0] timer0_rest_o,
    output wire [9:0] timer1_rest_o,
    output wire [9:0] keypad_rest_o,
    output wire [9:0] ps2_rest_o,
    output wire [9:0] sdram_rest_o,
    output wire [9:0] beam_rest_o,
    output wire       fetch_busy_o,      // pixel_dma.v
    output wire       fetch_sdram_o,
    output wire       fetch_odd_o,
    output wire       line_end_o
);
    assign timer0_due_o  = fpga.timer0.due;
    assign timer1_due_o  = fpga.timer1.due;
    assign keypad_due_o  = fpga.keypad_block.scanner.slot.due;
    assign ps2_due_o     = fpga.ps2.ticks.due;
    assign sdram_due_o   = fpga.sdram_block.controller.interval.due;
    assign timer0_rest_o = fpga.timer0.rest;
    assign timer1_rest_o = fpga.timer1.rest;
    assign keypad_rest_o = fpga.keypad_block.scanner.slot.rest;
    assign ps2_rest_o    = fpga.ps2.ticks.rest;
    assign sdram_rest_o  = fpga.sdram_block.controller.interval.rest;
    assign beam_rest_o   = fpga.video_block.vga_block.rest;
    assign fetch_busy_o  = fpga.video_block.dma.busy_q;
    assign fetch_sdram_o = fpga.video_block.dma.sdram_q;
    assign fetch_odd_o   = fpga.video_block.dma.odd_i;
    assign line_end_o    = fpga.video_block.dma.line_end_i;
endmodule

`default_nettype wire
