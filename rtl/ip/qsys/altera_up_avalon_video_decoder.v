// altera_up_avalon_video_decoder.v - the University Program's video-in decoder: a stream of pixels
// out of the TV decoder's bytes, ITU-R BT.656
//
//   FF 00 00 XY | Cb Y Cr Y ... | FF 00 00 XY      XY = 1 F V H P3 P2 P1 P0: field, vertical
//        SAV                           EAV         blanking, end of the line, their protection
//
// Each field is a packet of its lines without vertical blanking.  A pixel is Cb or Cr in 15:8, in
// turn, and Y in 7:0.  The first packet begins with the first field that begins.  A pixel for which
// the FIFO of 128 has no room is lost, and overflow_flag stays high from then on.
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards; ITU-R BT.656.
//
// Not handled: codes with a wrong bit are ignored, not corrected.

`default_nettype none

module altera_up_avalon_video_decoder (
    input  wire        clk,
    input  wire        reset,

    input  wire        TD_CLK27,
    input  wire [7:0]  TD_DATA,
    // verilator lint_off UNUSED
    input  wire        TD_HS,
    input  wire        TD_VS,
    // verilator lint_on UNUSED
    input  wire        clk27_reset,
    output wire        TD_RESET,
    output reg         overflow_flag,

    output wire [15:0] stream_out_data,
    output wire        stream_out_startofpacket,
    output wire        stream_out_endofpacket,
    output wire        stream_out_valid,
    input  wire        stream_out_ready
);
    assign TD_RESET = 1'b1;

    // ---- Timing reference codes: the latest four bytes ----------------------
    reg  [31:0] bytes_q;
    wire        f = bytes_q[6], v = bytes_q[5], h = bytes_q[4];
    wire        code = bytes_q[31:8] == 24'hFF0000
                       && bytes_q[3:0] == {v ^ h, f ^ h, f ^ v, f ^ v ^ h};

    always @(posedge TD_CLK27) begin
        bytes_q <= {bytes_q[23:0], TD_DATA};
        if (clk27_reset) bytes_q <= 32'd0;
    end

    // ---- Pixels: the oldest of the four -----------------------------------
    reg        active_q, second_q;        // in a line; the byte is Y
    reg  [1:0] code_q;                    // bytes of the code before the line that are left
    reg        field_q, known_q;          // of the last line with a picture
    reg        begins_q;                  // the next pixel is the first of a packet
    reg  [7:0] chroma_q;
    reg        runs_q;                    // a packet has begun
    wire       line   = code && !v && !h;
    wire       pixel  = active_q && !code && second_q && (runs_q || begins_q);

    always @(posedge TD_CLK27) begin
        if (code) begin
            active_q <= line;
            code_q   <= 2'd3;
            second_q <= 1'b0;
        end else begin
            if (code_q != 2'd0) code_q <= code_q - 2'd1;
            second_q <= active_q && code_q == 2'd0 && !second_q;
        end
        chroma_q <= bytes_q[31:24];
        if (line) begin
            if (known_q && f != field_q) begins_q <= 1'b1;
            {known_q, field_q} <= {1'b1, f};
        end
        if (pixel) {begins_q, runs_q} <= 2'b01;
        if (clk27_reset) {active_q, second_q, begins_q, runs_q, known_q} <= 5'd0;
    end

    // ---- The pixel before, until it is known whether it is the last of its packet --------------
    reg  [15:0] before_q;
    reg         before_begins_q, holds_q;
    wire        room;

    always @(posedge TD_CLK27) begin
        if (pixel) begin
            before_q        <= {chroma_q, bytes_q[31:24]};
            before_begins_q <= begins_q;
            holds_q         <= 1'b1;
        end
        if (pixel && holds_q && !room) overflow_flag <= 1'b1;
        if (clk27_reset) {holds_q, overflow_flag} <= 2'b00;
    end

    de1sim_up_crossing #(.BITS(16)) crossing (
        .clk_stream_in(TD_CLK27), .reset_stream_in(clk27_reset),
        .clk_stream_out(clk), .reset_stream_out(reset),
        .stream_in_data(before_q), .stream_in_startofpacket(before_begins_q),
        .stream_in_endofpacket(begins_q), .stream_in_valid(pixel && holds_q),
        .stream_in_ready(room), .stream_out_data(stream_out_data),
        .stream_out_startofpacket(stream_out_startofpacket),
        .stream_out_endofpacket(stream_out_endofpacket), .stream_out_valid(stream_out_valid),
        .stream_out_ready(stream_out_ready)
    );
endmodule

`default_nettype wire
