// bands.v - 640 x 480 pixels: ramps of red, green, blue and white in a frame, and a counter of KEY0
//
// One clock of 25 MHz, the pixel clock.  All outputs come from registers, so that they change
// together.

module bands (
    input            clock,
    input            key_n,    // counts when it is pressed, once per frame at most
    input            negative,
    output reg       hs = 1,
    output reg       vs = 1,
    output reg       visible = 0,
    output reg [3:0] red = 0,
    output reg [3:0] green = 0,
    output reg [3:0] blue = 0,
    output reg [7:0] count = 0
);
    reg [9:0] x = 0, y = 0;
    reg       was_up = 1;

    always @(posedge clock) begin
        x <= x == 799 ? 0 : x + 1;
        if (x == 799) y <= y == 524 ? 0 : y + 1;
        if (x == 799 && y == 524) begin
            was_up <= key_n;
            if (was_up && !key_n) count <= count + 1;
        end
    end

    wire       shown = x < 640 && y < 480;
    wire       frame = x == 0 || x == 639 || y == 0 || y == 479;
    wire [3:0] ramp = x / 40;
    wire [1:0] band = y / 120;
    wire [3:0] level = (frame ? 4'hf : ramp) ^ {4{negative}};

    always @(posedge clock) begin
        hs <= !(x >= 656 && x < 752);
        vs <= !(y >= 490 && y < 492);
        visible <= shown;
        red   <= shown && (frame || band == 0 || band == 3) ? level : 0;
        green <= shown && (frame || band == 1 || band == 3) ? level : 0;
        blue  <= shown && (frame || band == 2 || band == 3) ? level : 0;
    end
endmodule
