// vga.v - counts pixels and lines of 640 x 480, 60 frames a second: a pixel is two clocks of 50 MHz

module vga (
    input  wire       clk,
    input  wire       rst_n,
    output reg        pixel,        // the pixel's clock: what is shown changes as it falls
    output wire [9:0] column,       // of the pixel that is shown next
    output wire [9:0] row,
    output wire       line_begins,  // for a clock, at the end of the line before `row`
    output wire       frame_ends,
    output reg        shows,
    output reg        hs_n,
    output reg        vs_n
);
    localparam [9:0] COLUMNS = 10'd800, ROWS = 10'd525;

    reg [9:0] x, y;

    assign column = x;
    assign row    = y == ROWS - 10'd1 ? 10'd0 : y + 10'd1;
    assign line_begins = pixel && x == 640 && row < 480;
    assign frame_ends  = pixel && x == COLUMNS - 10'd1 && y == ROWS - 10'd1;

    always @(posedge clk)
        if (!rst_n) begin
            pixel <= 0;
            x <= 0;
            y <= ROWS - 10'd1;
            shows <= 0;
            hs_n <= 1;
            vs_n <= 1;
        end else begin
            pixel <= !pixel;
            if (pixel) begin
                x <= x == COLUMNS - 10'd1 ? 10'd0 : x + 10'd1;
                if (x == COLUMNS - 10'd1) y <= row;
                shows <= x < 640 && y < 480;
                hs_n <= !(x >= 656 && x < 752);
                vs_n <= !(y >= 490 && y < 492);
            end
        end
endmodule
