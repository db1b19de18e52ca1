// altera_up_avalon_video_vga_controller.v - the University Program's VGA controller: a stream of
// pixels with 10 bits of each colour to the board's DAC
//
// A picture of the stream begins on the screen's first pixel.  What comes before a first pixel is
// lost; where pixels are missing the screen is black.
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards.

`default_nettype none

module altera_up_avalon_video_vga_controller #(
    parameter H_SHOWN = 640, H_FRONT = 16, H_SYNC = 96, H_BACK = 48,
    parameter V_SHOWN = 480, V_FRONT = 10, V_SYNC = 2, V_BACK = 33,
    parameter POSITIVE = 0         // pulses of the syncs are high
) (
    input  wire        clk,
    input  wire        reset,

    // verilator lint_off UNUSED
    input  wire [29:0] data,
    input  wire        endofpacket,
    // verilator lint_on UNUSED
    input  wire        startofpacket,
    input  wire        valid,
    output wire        ready,

    output wire        VGA_CLK,
    output reg         VGA_HS,
    output reg         VGA_VS,
    output reg         VGA_BLANK,
    output wire        VGA_SYNC,
    output reg  [7:0]  VGA_R,
    output reg  [7:0]  VGA_G,
    output reg  [7:0]  VGA_B
);
    localparam H_ALL = H_SHOWN + H_FRONT + H_SYNC + H_BACK;
    localparam V_ALL = V_SHOWN + V_FRONT + V_SYNC + V_BACK;

    reg [11:0] x_q, y_q;
    reg        shows_q;            // this screen has a picture

    wire shown  = x_q < H_SHOWN && y_q < V_SHOWN;
    wire first  = x_q == 12'd0 && y_q == 12'd0;
    wire fits   = first ? startofpacket : shows_q && !startofpacket;
    wire strays = valid && !startofpacket && !(shows_q && y_q < V_SHOWN);

    assign VGA_CLK  = !clk;
    assign VGA_SYNC = 1'b0;
    assign ready    = (shown && fits) || strays;

    always @(posedge clk) begin
        x_q <= x_q == H_ALL - 1 ? 12'd0 : x_q + 12'd1;
        if (x_q == H_ALL - 1) y_q <= y_q == V_ALL - 1 ? 12'd0 : y_q + 12'd1;
        if (first) shows_q <= valid && startofpacket;
        VGA_BLANK <= shown;
        VGA_HS    <= (x_q >= H_SHOWN + H_FRONT && x_q < H_SHOWN + H_FRONT + H_SYNC)
                     == (POSITIVE != 0);
        VGA_VS    <= (y_q >= V_SHOWN + V_FRONT && y_q < V_SHOWN + V_FRONT + V_SYNC)
                     == (POSITIVE != 0);
        {VGA_R, VGA_G, VGA_B} <= shown && fits && valid ? {data[29:22], data[19:12], data[9:2]}
                                                        : 24'd0;
        if (reset) begin
            x_q     <= 12'd0;
            y_q     <= 12'd0;
            shows_q <= 1'b0;
        end
    end
endmodule

`default_nettype wire
