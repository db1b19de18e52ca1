// de1sim_up_rows.v - a window of N x N pixels of a stream: the pixels around one that has come
//
// Pixel (column, row) is at BITS * (N * row + column), the newest in column 0 of row 0; row by row
// they are WIDTH older.  The stream is one line without end: what is left of a picture's left edge
// is the right edge of the row before.  The pixel in the middle came
// (N - 1) / 2 * (WIDTH + 1) steps before the newest.

`default_nettype none

module de1sim_up_rows #(parameter BITS = 8, N = 3, WIDTH = 720) (
    input  wire                clk,
    input  wire                step_i,
    input  wire [BITS-1:0]     pixel_i,
    output wire [N*N*BITS-1:0] window_o
);
    genvar n;
    generate
        for (n = 0; n < N; n = n + 1) begin : row
            wire [BITS-1:0]   in;
            reg  [N*BITS-1:0] pixels_q;
            assign window_o[n*N*BITS +: N*BITS] = pixels_q;
            always @(posedge clk) if (step_i) pixels_q <= {pixels_q[(N-1)*BITS-1:0], in};
            if (n == 0) begin : newest
                assign in = pixel_i;
            end else begin : older
                de1sim_up_delay #(.BITS(BITS), .STEPS(WIDTH)) line (
                    .clk(clk), .step_i(step_i), .in_i(row[n-1].in), .out_o(in)
                );
            end
        end
    endgenerate
endmodule

`default_nettype wire
