// lt24.v - sets an LT24 on GPIO_0 up, and fills it with a picture: bands, and a white square
//
// A word takes six clocks of 50 MHz: WR_N is low in the first three.  The pins go by name, as
// Terasic's system builder writes them; lt24.qsf says where they are.

`default_nettype none

module lt24 (
    input  wire        CLOCK_50,
    output wire        LT24_CS_N,
    output wire        LT24_LCD_ON,
    output wire        LT24_RD_N,
    output reg         LT24_RESET_N,
    output wire        LT24_RS,
    output wire        LT24_WR_N,
    output wire [15:0] LT24_D
);
    // ---- Words: {RS, word}, first those of the list, then the pixels ----

    localparam COMMANDS = 23;

    reg [16:0] list;
    reg [4:0]  at = 0;

    always @*
        case (at)
            0:  list = 17'h00011;                          // sleep out
            1:  list = 17'h000c7; 2:  list = 17'h100a2;    // VCM control, which is ignored
            3:  list = 17'h00036; 4:  list = 17'h10008;    // BGR
            5:  list = 17'h0003a; 6:  list = 17'h10055;    // 16 bits
            7:  list = 17'h000b6; 8:  list = 17'h1000a; 9: list = 17'h100a2;
            10: list = 17'h0002a;
            11: list = 17'h10000; 12: list = 17'h10000;
            13: list = 17'h10000; 14: list = 17'h100ef;    // columns 0 to 239
            15: list = 17'h0002b;
            16: list = 17'h10000; 17: list = 17'h10000;
            18: list = 17'h10001; 19: list = 17'h1003f;    // pages 0 to 319
            20: list = 17'h00029;                          // display on
            21: list = 17'h0002c;                          // memory write
            default: list = 17'h00000;
        endcase

    reg [7:0] x = 0;
    reg [8:0] y = 0;

    wire        square = x >= 16 && x < 48 && y >= 16 && y < 48;
    wire [15:0] band   = y < 80  ? {x[7:3], 11'd0} :       // red, green, blue and grey,
                         y < 160 ? {5'd0, x[7:2], 5'd0} :  // brighter to the right
                         y < 240 ? {11'd0, x[7:3]} : {x[7:3], x[7:2], x[7:3]};
    wire [15:0] pixel  = square ? 16'hffff : band;

    wire pixels = at == COMMANDS - 1;
    wire done   = pixels && y == 320;

    reg [2:0] phase = 0;
    reg [9:0] reset = 0;

    initial LT24_RESET_N = 0;

    always @(posedge CLOCK_50)
        if (!LT24_RESET_N) begin
            reset <= reset + 1;
            LT24_RESET_N <= &reset;
        end else if (!done) begin
            phase <= phase == 5 ? 0 : phase + 1;
            if (phase == 5 && !pixels) at <= at + 1;
            if (phase == 5 && pixels) begin
                x <= x == 239 ? 0 : x + 1;
                if (x == 239) y <= y + 1;
            end
        end

    assign LT24_LCD_ON = 1;
    assign LT24_CS_N   = !LT24_RESET_N;
    assign LT24_RD_N   = 1;
    assign LT24_WR_N   = !LT24_RESET_N || done || phase >= 3;
    assign LT24_RS     = pixels || list[16];
    assign LT24_D      = pixels ? pixel : list[15:0];
endmodule

`default_nettype wire
