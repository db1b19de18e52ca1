// bt656_rx.v - pixels out of the video decoder's bytes: ITU-R BT.656, 525 lines
//
//   FF 00 00 XY | Cb Y Cr Y ... 720 pixels | FF 00 00 XY | blanking
//        SAV                                      EAV
//   XY = 1 F V H P3 P2 P1 P0: field, vertical blanking, end of the line, and their protection
//
// Each field becomes a picture of 320 x 240 pixels.  It has the middle 640 of a line's 720 pixels,
// and of these every second one, the pixels for which Cb and Cr are sampled.  The first row is line
// 22 in the first field, line 285 in the second.  Lines are counted from the change of F, because
// revisions 3 and 4 of the standard disagree on the change of V.
//
// Source: ITU-R BT.656; the clipper and the scaler of the DE1-SoC Computer's video-in.
//
// Not handled: codes with a wrong bit are not corrected but ignored; of 625 lines (PAL) the 240
// from the same line on are taken.

`default_nettype none

module bt656_rx (
    input  wire       clk_i,     // 27 MHz, the decoder's
    input  wire       run_i,     // 0 resets the state

    input  wire [7:0] data_i,

    output reg        pixel_o,   // for one clock: a pixel, which stays until the next
    output reg        row_o,     // it is the first of its row
    output reg        first_o,   // ... and of the picture
    output reg  [7:0] y_o,
    output reg  [7:0] cb_o,
    output reg  [7:0] cr_o
);
    localparam [8:0]  FIRST_LINE = 9'd18;              // after the change of F; 1 more with F = 1
    localparam [8:0]  ROWS = 9'd240, NOWHERE = 9'd511;
    localparam [8:0]  FIRST_PAIR = 9'd20, PAIRS = 9'd320;
    localparam [10:0] LAST = 11'd1439;                 // byte of a line

    // ---- Timing reference codes -------------------------------------------
    reg  [1:0] code_q;            // how many bytes of a code have come
    wire       f = data_i[6], v = data_i[5], h = data_i[4];
    wire       code   = code_q == 2'd3 && data_i[7]
                        && data_i[3:0] == {v ^ h, f ^ h, f ^ v, f ^ v ^ h};
    wire       begins = code && !h;

    always @(posedge clk_i)
        if (!run_i) code_q <= 2'd0;
        else if (data_i == 8'hFF) code_q <= 2'd1;
        else if (data_i == 8'h00 && ^code_q) code_q <= code_q + 2'd1;
        else code_q <= 2'd0;

    // ---- Lines ------------------------------------------------------------
    reg        known_q, f_q;      // the field
    reg  [8:0] line_q;            // after the change of F; NOWHERE before the first one
    reg        shown_q, top_q;    // this line is a row of the picture, the first one
    wire [8:0] line = known_q && f != f_q ? 9'd0 : line_q == NOWHERE ? NOWHERE : line_q + 9'd1;
    wire [8:0] row  = line - FIRST_LINE - {8'd0, f};

    always @(posedge clk_i)
        if (!run_i) begin
            known_q <= 1'b0;
            line_q  <= NOWHERE;
        end else if (begins) begin
            known_q <= 1'b1;
            f_q     <= f;
            line_q  <= line;
            shown_q <= row < ROWS;
            top_q   <= row == 9'd0;
        end

    // ---- Pixels: two are four bytes ---------------------------------------
    reg         active_q;
    reg  [10:0] place_q;          // of the byte in the line
    reg  [7:0]  cb_q, y_q;
    wire [8:0]  column = place_q[10:2] - FIRST_PAIR;

    always @(posedge clk_i) begin
        if (active_q) begin
            place_q <= place_q + 11'd1;
            if (place_q[1:0] == 2'd0) cb_q <= data_i;
            if (place_q[1:0] == 2'd1) y_q <= data_i;
            if (place_q[1:0] == 2'd2) {y_o, cb_o, cr_o} <= {y_q, cb_q, data_i};
        end
        if (begins) place_q <= 11'd0;
        active_q <= run_i && (begins || (active_q && !code && place_q != LAST));
        pixel_o  <= run_i && active_q && place_q[1:0] == 2'd2 && shown_q && column < PAIRS;
        row_o    <= run_i && column == 9'd0;
        first_o  <= run_i && column == 9'd0 && top_q;
    end
endmodule

`default_nettype wire
