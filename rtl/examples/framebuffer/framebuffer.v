// framebuffer.v - a picture of 160 x 120 in three colours' bits, in a memory that starts with one
//
// The memory is the wizard's (picture_ram.v, with house.mif), and so is the pixel clock's PLL.
// SW2-SW0 is a colour; KEY0 paints the picture with it from the top, 4,000 pixels per second.

module framebuffer (
    input        CLOCK_50,
    input  [3:0] KEY,
    input  [9:0] SW,
    output [9:0] LEDR,
    output       VGA_CLK,
    output       VGA_HS,
    output       VGA_VS,
    output       VGA_BLANK_N,
    output       VGA_SYNC_N,
    output [7:0] VGA_R,
    output [7:0] VGA_G,
    output [7:0] VGA_B
);
    wire clock, locked;
    pixel_pll pll (.inclk0(CLOCK_50), .c0(clock), .locked(locked));

    // ---- The beam: two clocks ahead of the pins, since the memory answers two clocks later ----

    reg [9:0] column = 0, line = 0;

    always @(posedge clock)
        if (column != 799) column <= column + 1;
        else begin
            column <= 0;
            line <= line == 524 ? 0 : line + 1;
        end

    wire       visible = column >= 144 && column < 784 && line >= 35 && line < 515;
    wire [9:0] x = column - 144, y = line - 35;
    reg  [2:0] hs = 0, vs = 0, shown = 0;

    always @(posedge clock) begin
        hs <= {hs[1:0], column >= 96};
        vs <= {vs[1:0], line >= 2};
        shown <= {shown[1:0], visible};
    end

    // ---- The picture ----

    wire [14:0] read = y[8:2] * 8'd160 + x[9:2];
    reg  [14:0] write = 0;
    reg  [13:0] pause = 0;
    reg         painting = 0;
    wire        next = pause == 12_499;
    wire [2:0]  colour;

    always @(posedge CLOCK_50) begin
        pause <= next ? 0 : pause + 1;
        if (!KEY[0] && !painting) begin
            painting <= 1;
            write <= 0;
        end else if (painting && next) begin
            write <= write + 1;
            painting <= write != 160 * 120 - 1;
        end
    end

    picture_ram ram (.wrclock(CLOCK_50), .wraddress(write), .data(SW[2:0]), .wren(painting && next),
                     .rdclock(clock), .rdaddress(read), .q(colour));

    assign VGA_CLK = clock;
    assign VGA_HS = hs[1];
    assign VGA_VS = vs[1];
    assign VGA_BLANK_N = shown[1];
    assign VGA_SYNC_N = 0;
    assign VGA_R = {8{shown[1] & colour[2]}};
    assign VGA_G = {8{shown[1] & colour[1]}};
    assign VGA_B = {8{shown[1] & colour[0]}};
    assign LEDR = {locked, 8'd0, painting};
endmodule
