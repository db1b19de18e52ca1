// vga_timing.v - 640 x 480 at 60 Hz (VESA DMT): 800 x 525 clocks of 25 MHz

module vga_timing (
    input            clock,
    output     [9:0] x,        // of the picture, while it is visible
    output     [9:0] y,
    output           visible,
    output           frame,    // for one clock, below the picture
    output           hs,
    output           vs
);
    reg [9:0] column = 0, line = 0;

    always @(posedge clock)
        if (column != 799) column <= column + 1;
        else begin
            column <= 0;
            line <= line == 524 ? 0 : line + 1;
        end

    assign hs = column >= 96;
    assign vs = line >= 2;
    assign visible = column >= 144 && column < 784 && line >= 35 && line < 515;
    assign x = column - 144;
    assign y = line - 35;
    assign frame = column == 0 && line == 520;
endmodule
