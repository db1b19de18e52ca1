// alt_vip_itc.v - the Video and Image Processing Suite's Clocked Video Output: a stream as video
//
//   packets -> FIFO -> video packets, from the start of a frame on -> vid_data
//
//   line:  |front porch, sync, back porch|   active pixels   |
//   frame: |   active lines   |front porch, sync, back porch|
//
// The video begins when the FIFO holds THRESHOLD words.  The syncs are active high.  A frame whose
// packet is too short or comes too late is dark from there on, and `underflow` stays set.
//
// Source: Video and Image Processing Suite User Guide (UG-VIPSUITE), "Clocked Video Output".
//
// Not handled: the control port, embedded syncs, interlaced video, colour planes in sequence.

`default_nettype none

module alt_vip_itc #(
    parameter BITS            = 24,
    parameter H_ACTIVE_PIXELS = 640,
    parameter V_ACTIVE_LINES  = 480,
    parameter H_FRONT_PORCH   = 16,
    parameter H_SYNC_LENGTH   = 96,
    parameter H_BACK_PORCH    = 48,
    parameter V_FRONT_PORCH   = 10,
    parameter V_SYNC_LENGTH   = 2,
    parameter V_BACK_PORCH    = 33,
    parameter FIFO_DEPTH      = 640,
    parameter THRESHOLD       = 639,
    parameter CLOCKS_ARE_SAME = 0
) (
    input  wire            is_clk,
    input  wire            rst,
    input  wire [BITS-1:0] is_data,
    input  wire            is_valid,
    output wire            is_ready,
    input  wire            is_sop,
    // verilator lint_off UNUSED
    input  wire            is_eop,
    // verilator lint_on UNUSED

    // verilator lint_off UNUSED
    input  wire            vid_clk,      // unless CLOCKS_ARE_SAME
    // verilator lint_on UNUSED
    output reg  [BITS-1:0] vid_data,
    output reg             underflow,
    output reg             vid_datavalid,
    output reg             vid_v_sync,
    output reg             vid_h_sync,
    output wire            vid_f,
    output reg             vid_h,
    output reg             vid_v
);
    localparam LOG2    = $clog2(FIFO_DEPTH);
    localparam H_BLANK = H_FRONT_PORCH + H_SYNC_LENGTH + H_BACK_PORCH;
    localparam COLUMNS = H_BLANK + H_ACTIVE_PIXELS;
    localparam ROWS    = V_ACTIVE_LINES + V_FRONT_PORCH + V_SYNC_LENGTH + V_BACK_PORCH;
    localparam [1:0] SEEKS = 2'd0, WAITS = 2'd1, SHOWS = 2'd2, LOST = 2'd3;

    wire            clk = CLOCKS_ARE_SAME ? is_clk : vid_clk;
    reg  [1:0]      rst_q = 2'b11;
    always @(posedge clk) rst_q <= {rst_q[0], rst};

    wire [LOG2:0]   in_used, used;
    wire            sop, pops;
    wire [BITS-1:0] pixel;

    // A ready latency of 1.
    assign is_ready = in_used < (1 << LOG2) - 4;

    de1sim_vip_fifo #(.WIDTH(BITS + 1), .LOG2(LOG2)) fifo (
        .in_clk_i(is_clk), .in_rst_i(rst), .write_i(is_valid), .data_i({is_sop, is_data}),
        .in_used_o(in_used),
        .out_clk_i(clk), .out_rst_i(rst_q[1]), .read_i(pops), .data_o({sop, pixel}),
        .out_used_o(used)
    );

    // ---- The beam ---------------------------------------------------------
    reg  [15:0] h_q, v_q;
    reg         runs_q;

    wire        runs   = runs_q || used >= THRESHOLD;
    wire        active = runs && h_q >= H_BLANK && v_q < V_ACTIVE_LINES;
    wire        begins = active && h_q == H_BLANK && v_q == 16'd0;

    assign vid_f = 1'b0;

    // ---- The packets ------------------------------------------------------
    reg  [1:0]  state_q;

    wire        is_here = used != 0;
    wire        is_video = is_here && sop && pixel[3:0] == 4'd0;
    wire        shows   = active && (state_q == SHOWS || (state_q == WAITS && begins));
    wire        fails   = shows && (!is_here || sop);

    assign pops = state_q == SEEKS ? is_here : shows && !fails;

    always @(posedge clk) begin
        runs_q <= runs;
        if (runs) begin
            h_q <= h_q == COLUMNS - 1 ? 16'd0 : h_q + 16'd1;
            if (h_q == COLUMNS - 1) v_q <= v_q == ROWS - 1 ? 16'd0 : v_q + 16'd1;
        end
        vid_datavalid <= active;
        vid_h         <= runs && h_q < H_BLANK;
        vid_v         <= runs && v_q >= V_ACTIVE_LINES;
        vid_h_sync    <= runs && h_q >= H_FRONT_PORCH && h_q < H_FRONT_PORCH + H_SYNC_LENGTH;
        vid_v_sync    <= runs && v_q >= V_ACTIVE_LINES + V_FRONT_PORCH
                         && v_q < V_ACTIVE_LINES + V_FRONT_PORCH + V_SYNC_LENGTH;
        vid_data      <= shows && !fails ? pixel : {BITS{1'b0}};
        if (active && !is_here) underflow <= 1'b1;
        case (state_q)
            SEEKS:   if (is_video) state_q <= WAITS;
            WAITS:   if (begins) state_q <= fails ? LOST : SHOWS;
            SHOWS:   if (fails) state_q <= LOST;
                     else if (v_q == V_ACTIVE_LINES) state_q <= SEEKS;
            default: if (v_q == V_ACTIVE_LINES) state_q <= SEEKS;
        endcase
        if (rst_q[1]) begin
            {runs_q, underflow, vid_datavalid, vid_h, vid_v, vid_h_sync, vid_v_sync} <= 7'd0;
            {h_q, v_q} <= 32'd0;
            state_q <= SEEKS;
        end
    end
endmodule

`default_nettype wire
