// de1sim_up_scaler.v - the University Program's scaler: each pixel X times, each line Y times, of
// those that are left when of X_LOST pixels, and of Y_LOST lines, the first stays
//
// stream_out_channel has the line of a pixel in its upper half, the column in its lower.

`default_nettype none

module de1sim_up_scaler #(
    parameter BITS   = 30,
    parameter WIDTH  = 320,        // of a line that comes in
    parameter HEIGHT = 240,
    parameter X      = 2,
    parameter Y      = 2,
    parameter X_LOST = 1,
    parameter Y_LOST = 1
) (
    input  wire            clk,
    input  wire            reset,
    input  wire [BITS-1:0] stream_in_data,
    input  wire            stream_in_startofpacket,
    // verilator lint_off UNUSED
    input  wire            stream_in_endofpacket,
    // verilator lint_on UNUSED
    input  wire            stream_in_valid,
    output wire            stream_in_ready,
    output wire [BITS-1:0] stream_out_data,
    output wire [5:0]      stream_out_channel,
    output wire            stream_out_startofpacket,
    output wire            stream_out_endofpacket,
    output wire            stream_out_valid,
    input  wire            stream_out_ready
);
    localparam LEFT  = WIDTH / X_LOST;   // of a line
    localparam LINES = HEIGHT / Y_LOST;
    localparam INDEX = $clog2(LEFT);

    // ---- Smaller: which pixels are lost -----------------------------------
    reg  [15:0] in_x_q;
    reg  [2:0]  in_column_q, in_line_q;  // how many are lost since the last that was not
    wire [15:0] in_x      = stream_in_startofpacket ? 16'd0 : in_x_q;
    wire [2:0]  in_column = stream_in_startofpacket ? 3'd0 : in_column_q;
    wire [2:0]  in_line   = stream_in_startofpacket ? 3'd0 : in_line_q;
    wire        in_last   = in_x == WIDTH - 1;
    wire        lost      = in_column != 3'd0 || in_line != 3'd0;
    wire        valid     = stream_in_valid && !lost;
    wire        ready;

    assign stream_in_ready = lost || ready;

    always @(posedge clk) begin
        if (stream_in_valid && stream_in_ready) begin
            in_x_q      <= in_last ? 16'd0 : in_x + 16'd1;
            in_column_q <= in_last || in_column == X_LOST - 1 ? 3'd0 : in_column + 3'd1;
            if (in_last) in_line_q <= in_line == Y_LOST - 1 ? 3'd0 : in_line + 3'd1;
            else in_line_q <= in_line;
        end
        if (reset) {in_x_q, in_column_q, in_line_q} <= 22'd0;
    end

    // ---- Larger -----------------------------------------------------------
    reg [BITS-1:0] line [0:LEFT-1];
    reg [15:0]     x_q, y_q;
    reg [2:0]      column_q, line_q;     // of the pixel

    wire first = line_q == 3'd0;         // from the input; its other lines are kept
    wire last_column = column_q == X - 1, last_line = line_q == Y - 1;
    wire last_x = x_q == LEFT - 1, last_y = y_q == LINES - 1;
    wire begins = x_q == 16'd0 && y_q == 16'd0 && column_q == 3'd0 && first;
    // A picture begins with its first pixel: what comes before is lost.
    wire strays = valid && begins && !stream_in_startofpacket;
    wire goes   = stream_out_valid && stream_out_ready;

    assign stream_out_data          = first ? stream_in_data : line[x_q[INDEX-1:0]];
    assign stream_out_channel       = {line_q, column_q};
    assign stream_out_valid         = first ? valid && !strays : 1'b1;
    assign stream_out_startofpacket = begins;
    assign stream_out_endofpacket   = last_x && last_y && last_column && last_line;
    assign ready                    = strays || (first && last_column && stream_out_ready);

    always @(posedge clk) begin
        if (first && goes) line[x_q[INDEX-1:0]] <= stream_in_data;
        if (goes) begin
            column_q <= last_column ? 3'd0 : column_q + 3'd1;
            if (last_column) x_q <= last_x ? 16'd0 : x_q + 16'd1;
            if (last_column && last_x) line_q <= last_line ? 3'd0 : line_q + 3'd1;
            if (last_column && last_x && last_line) y_q <= last_y ? 16'd0 : y_q + 16'd1;
        end
        if (reset) {x_q, y_q, column_q, line_q} <= 38'd0;
    end
endmodule

`default_nettype wire
