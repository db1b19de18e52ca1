// altera_up_avalon_video_edge_detection.v - the University Program's edge detection, of brightness
//
//   smooth    the 5 x 5 pixels around, weighed 15 in the middle to 2 at the corners, 159 in all;
//             a 128th of the sum
//   Sobel     gx, what is right less what is left, and gy, what is below less what is above:
//             strength (|gx| + |gy|) / 4, at most 255, and in which of four directions
//   thin      0, unless it is as strong as its two neighbours across the edge
//   choose    32 more, at most 255, where one of the 3 x 3 around has 10 or more; else 0
//
// A stage's result takes the place of the middle one of the pixels that it used.  Beyond the left
// and the right edge these are pixels of the other edge, one row off (de1sim_up_rows.v).  Above the
// first row they are the last pixel of the picture before, and below the last row that of this
// one, with which the stages go on while no picture comes.
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards.  On one side of an edge
// two neighbours are averaged, on the other side one is taken alone, as in that core.

`default_nettype none

module altera_up_avalon_video_edge_detection #(parameter WIDTH = 720) (
    input  wire       clk,
    input  wire       reset,
    input  wire [7:0] in_data,
    input  wire       in_startofpacket,
    input  wire       in_endofpacket,
    input  wire       in_valid,
    output wire       in_ready,
    output reg  [7:0] out_data,
    output reg        out_startofpacket,
    output reg        out_endofpacket,
    output reg        out_valid,
    input  wire       out_ready
);
    // Steps from a pixel to its result: rows and columns of the four windows, and five registers.
    localparam DELAY = 5 * WIDTH + 14;

    reg  [7:0] data_q;
    reg        flush_q;          // a picture has ended, and none has begun
    wire       free  = out_ready || !out_valid;
    wire       taken = in_valid && free;
    wire       step  = free && (in_valid || flush_q);

    assign in_ready = free;

    // ---- Smooth -----------------------------------------------------------
    wire [25*8-1:0] five;
    reg  [8:0]      smooth_q;

    function [3:0] weight(input integer across, input integer down);
        case (across * across + down * down)
            0:       weight = 4'd15;
            1:       weight = 4'd12;
            2:       weight = 4'd9;
            4:       weight = 4'd5;
            5:       weight = 4'd4;
            default: weight = 4'd2;
        endcase
    endfunction

    de1sim_up_rows #(.BITS(8), .N(5), .WIDTH(WIDTH)) smoothed (
        .clk(clk), .step_i(step), .pixel_i(data_q), .window_o(five)
    );

    // verilator lint_off UNUSED
    function [8:0] smooth(input [25*8-1:0] all);
        integer    x, y;
        reg [15:0] sum;
        begin
            sum = 16'd0;
            for (y = 0; y < 5; y = y + 1)
                for (x = 0; x < 5; x = x + 1)
                    sum = sum + {8'd0, all[8*(5*y + x) +: 8]} * {12'd0, weight(x - 2, y - 2)};
            smooth = sum[15:7];
        end
    endfunction
    // verilator lint_on UNUSED

    // ---- Sobel: column 0 is right, row 0 below ------------------------------
    wire [9*9-1:0]      three;
    reg  [9:0]          sobel_q; // direction, strength

    // Three in a row from `first` on, the one in the middle twice.
    function signed [12:0] side(input [9*9-1:0] all, input integer first, input integer distance);
        side = {4'd0, all[9*first +: 9]} + {3'd0, all[9*(first + distance) +: 9], 1'b0}
               + {4'd0, all[9*(first + 2*distance) +: 9]};
    endfunction

    // Its last quarters do not count.
    // verilator lint_off UNUSED
    function [9:0] slope(input [9*9-1:0] all);
        reg signed [12:0] gx, gy;
        reg [12:0]        ax, ay, strength;
        reg               falls;
        begin
            gx       = side(all, 0, 3) - side(all, 2, 3);
            gy       = side(all, 0, 1) - side(all, 6, 1);
            ax       = gx < 0 ? -gx : gx;
            ay       = gy < 0 ? -gy : gy;
            strength = ax + ay;
            falls    = (gx < 0) ^ (gy < 0);
            slope    = {falls, falls ^ (ay > ax),
                        strength[12:10] == 3'd0 ? strength[9:2] : 8'hFF};
        end
    endfunction
    // verilator lint_on UNUSED

    de1sim_up_rows #(.BITS(9), .N(3), .WIDTH(WIDTH)) slopes (
        .clk(clk), .step_i(step), .pixel_i(smooth_q), .window_o(three)
    );

    // ---- Thin ---------------------------------------------------------------
    wire [9*10-1:0] edges;
    reg  [7:0]      thin_q;

    function [7:0] at(input [9*10-1:0] all, input integer n);
        at = all[10*n +: 8];
    endfunction
    // Half of a sum counts.
    // verilator lint_off UNUSED
    function [7:0] thin(input [9*10-1:0] all);
        reg [8:0] two;
        reg [7:0] one;
        begin
            case (all[10*4 + 8 +: 2])
                2'd0:    {two, one} = {{1'b0, at(all, 0)} + {1'b0, at(all, 3)}, at(all, 5)};
                2'd1:    {two, one} = {{1'b0, at(all, 0)} + {1'b0, at(all, 1)}, at(all, 7)};
                2'd2:    {two, one} = {{1'b0, at(all, 1)} + {1'b0, at(all, 2)}, at(all, 6)};
                default: {two, one} = {{1'b0, at(all, 2)} + {1'b0, at(all, 5)}, at(all, 3)};
            endcase
            thin = at(all, 4) >= two[8:1] && at(all, 4) >= one ? at(all, 4) : 8'd0;
        end
    endfunction
    // verilator lint_on UNUSED

    de1sim_up_rows #(.BITS(10), .N(3), .WIDTH(WIDTH)) lines (
        .clk(clk), .step_i(step), .pixel_i(sobel_q), .window_o(edges)
    );

    // ---- Choose -------------------------------------------------------------
    reg  [7:0]     chosen_q;
    wire [8:0]     high;         // of the pixels around
    // verilator lint_off UNUSED
    wire [9*8-1:0] thinned;      // of which the one in the middle counts
    // verilator lint_on UNUSED
    wire [8:0]     brighter = {1'b0, thinned[8*4 +: 8]} + 9'd32;

    de1sim_up_rows #(.BITS(1), .N(3), .WIDTH(WIDTH)) choice (
        .clk(clk), .step_i(step), .pixel_i(thin_q >= 8'd10), .window_o(high)
    );
    de1sim_up_rows #(.BITS(8), .N(3), .WIDTH(WIDTH)) chosen (
        .clk(clk), .step_i(step), .pixel_i(thin_q), .window_o(thinned)
    );

    // ---- Where the picture begins and ends, as late ---------------------------
    wire begins, ends, is_pixel;
    de1sim_up_delay #(.BITS(3), .STEPS(DELAY)) frame (
        .clk(clk), .step_i(step),
        .in_i(in_valid ? {1'b1, in_startofpacket, in_endofpacket} : 3'd0),
        .out_o({is_pixel, begins, ends})
    );

    always @(posedge clk) begin
        if (taken) begin
            data_q  <= in_data;
            flush_q <= in_endofpacket || (flush_q && !in_startofpacket);
        end
        if (step) begin
            smooth_q <= smooth(five);
            sobel_q  <= slope(three);
            thin_q   <= thin(edges);
            chosen_q <= high == 9'd0 ? 8'd0 : brighter[8] ? 8'hFF : brighter[7:0];
        end
        if (free) out_valid <= step && is_pixel;
        if (step) {out_startofpacket, out_endofpacket, out_data} <= {begins, ends, chosen_q};
        if (reset) {flush_q, out_valid} <= 2'b00;
    end
endmodule

`default_nettype wire
