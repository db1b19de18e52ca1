// sobel.v - how much the brightness changes from pixel to pixel: Sobel's operator
//
//        | -1 0 1 |        | -1 -2 -1 |
//   gx = | -2 0 2 |   gy = |  0  0  0 |   edge_o = (|gx| + |gy|) / 4, 255 at most
//        | -1 0 1 |        |  1  2  1 |
//
// It uses the pixel, the two before it, and the same three of the two rows above.  So an edge
// appears one pixel to the right of its place in the picture, and one row below.  Where those
// pixels do not exist, edge_o is 0.  The two rows above are an M10K block.
//
// Source: the Sobel operator of the DE1-SoC Computer's edge detection, which sees 720 pixels per
// row, smoothes the picture first and thins the lines afterwards.
//
// Not handled: that smoothing and thinning.

`default_nettype none

module sobel (
    input  wire       clk_i,
    input  wire       run_i,     // 0: pixel_i is ignored

    input  wire       pixel_i,   // at most in every third clock
    input  wire       row_i,     // the first of its row
    input  wire       first_i,   // ... and of the picture
    input  wire [7:0] y_i,       // stable for one clock more

    output wire [7:0] edge_o     // two clocks later, until the next pixel's
);
    reg  [15:0] rows [0:511];    // per column: the pixel above, and in 15:8 the one above that
    reg  [15:0] above_q;
    reg         read_q;          // above_q is this pixel's
    reg  [8:0]  column_q;
    reg  [1:0]  row_q;           // 2 from the third row on
    wire [8:0]  column = row_i ? 9'd0 : column_q + 9'd1;

    // Columns of three, the lowest in 7:0.
    reg  [23:0] left_q, middle_q, right_q;

    always @(posedge clk_i) begin
        if (pixel_i) begin
            above_q  <= rows[column];
            column_q <= column;
            if (first_i) row_q <= 2'd0;
            else if (row_i && row_q != 2'd2) row_q <= row_q + 2'd1;
        end
        read_q <= pixel_i && run_i;
        if (read_q) begin
            rows[column_q] <= {above_q[7:0], y_i};
            left_q   <= middle_q;
            middle_q <= right_q;
            right_q  <= {above_q, y_i};
        end
    end

    function [9:0] weighted;     // a + 2 b + c
        input [7:0] a;
        input [7:0] b;
        input [7:0] c;
        weighted = {2'd0, a} + {1'd0, b, 1'b0} + {2'd0, c};
    endfunction

    function [9:0] distance;
        input [9:0] a;
        input [9:0] b;
        distance = a > b ? a - b : b - a;
    endfunction

    wire [9:0]  gx = distance(weighted(right_q[23:16], right_q[15:8], right_q[7:0]),
                              weighted(left_q[23:16], left_q[15:8], left_q[7:0]));
    wire [9:0]  gy = distance(weighted(left_q[7:0], middle_q[7:0], right_q[7:0]),
                              weighted(left_q[23:16], middle_q[23:16], right_q[23:16]));
    // The last quarters do not count.
    // verilator lint_off UNUSED
    wire [10:0] g  = {1'b0, gx} + {1'b0, gy};
    // verilator lint_on UNUSED

    assign edge_o = row_q != 2'd2 || column_q < 9'd2 ? 8'd0 : g[10] ? 8'd255 : g[9:2];
endmodule

`default_nettype wire
