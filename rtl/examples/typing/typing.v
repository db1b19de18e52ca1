// typing.v - what is typed on the PS/2 keyboard appears on the screen, with a beep for each key
//
// Twenty letters of 32 x 32 pixels in each of 15 rows.  Enter goes to the next row and sounds
// lower; Backspace takes a letter back.  LEDR0 is lit once the codec is set up.

module typing (
    input        CLOCK_50,
    inout        PS2_CLK,
    inout        PS2_DAT,
    output [9:0] LEDR,
    output reg   VGA_CLK,
    output       VGA_HS,
    output       VGA_VS,
    output       VGA_BLANK_N,
    output       VGA_SYNC_N,
    output [7:0] VGA_R,
    output [7:0] VGA_G,
    output [7:0] VGA_B,
    output       AUD_XCK,
    inout        AUD_BCLK,
    inout        AUD_DACLRCK,
    inout        AUD_ADCLRCK,
    output       AUD_DACDAT,
    output       FPGA_I2C_SCLK,
    inout        FPGA_I2C_SDAT
);
    initial VGA_CLK = 0;
    always @(posedge CLOCK_50) VGA_CLK <= ~VGA_CLK;

    // ---- Keyboard ----

    wire       pressed;
    wire [7:0] key;
    wire [6:0] letter;
    ps2_keyboard keyboard (.clock(CLOCK_50), .ps2_clk(PS2_CLK), .ps2_dat(PS2_DAT),
                           .pressed(pressed), .key(key));
    key_letter letters (.key(key), .letter(letter));

    wire enter = key == 8'h5a, backspace = key == 8'h66;
    wire typed = pressed && (letter != 0 || enter || backspace);

    // ---- Text ----

    reg  [6:0] text [0:511];  // row in 8:5, column in 4:0
    reg  [4:0] column = 0;
    reg  [3:0] row = 0;
    wire [4:0] previous = column - 1;
    wire       erases = backspace && column != 0;
    wire [3:0] next_row = row == 14 ? 0 : row + 1;

    always @(posedge CLOCK_50)
        if (typed) begin
            if (letter != 0 || erases) text[{row, erases ? previous : column}] <= letter;
            if (erases) column <= previous;
            else if (enter || column == 19) begin
                column <= 0;
                row <= next_row;
            end else if (letter != 0) column <= column + 1;
        end

    // ---- Screen ----

    wire [9:0] x, y;
    wire       visible;
    vga_timing timing (.clock(VGA_CLK), .x(x), .y(y), .visible(visible), .hs(VGA_HS), .vs(VGA_VS));

    reg  [7:0] font [0:1023];  // eight rows of each letter; bit 0 is on the left
    initial $readmemh("font.hex", font);
    wire [7:0] pixels = font[{text[{y[8:5], x[9:5]}], y[4:2]}];
    wire       cursor = x[9:5] == column && y[8:5] == row && y[4:2] == 7;
    wire       lit = visible && (pixels[x[4:2]] || cursor);

    assign VGA_BLANK_N = visible;
    assign VGA_SYNC_N = 0;
    assign VGA_R = lit ? 8'hff : 8'h00;
    assign VGA_G = lit ? 8'hc0 : 8'h00;
    assign VGA_B = !visible ? 8'h00 : lit ? 8'h40 : 8'h30;

    // ---- Sound: the codec makes BCLK and LRCK from its clock of 12.5 MHz ----

    reg [1:0] divider = 0;
    always @(posedge CLOCK_50) divider <= divider + 1;
    assign AUD_XCK = divider[1];
    assign AUD_BCLK = 1'bz;
    assign AUD_DACLRCK = 1'bz;
    assign AUD_ADCLRCK = 1'bz;

    codec_setup setup (.clock(CLOCK_50), .sclk(FPGA_I2C_SCLK), .sdat(FPGA_I2C_SDAT),
                       .done(LEDR[0]));
    beep beep (.clock(CLOCK_50), .start(typed), .low(enter), .bclk(AUD_BCLK), .lrck(AUD_DACLRCK),
               .dacdat(AUD_DACDAT));
    assign LEDR[9:1] = 0;
endmodule
