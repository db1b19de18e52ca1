// pong.v - the game on a DE1-SoC without a processor
//
// KEY3 and KEY2 move the left bat, KEY1 and KEY0 the right one.  HEX5 and HEX0 count the points,
// SW0 holds the ball.  One clock of 25 MHz, the pixel clock; the game moves once per frame.

module pong (
    input        CLOCK_50,
    input  [3:0] KEY,
    input  [9:0] SW,
    output [9:0] LEDR,
    output [6:0] HEX0,
    output [6:0] HEX5,
    output       VGA_CLK,
    output       VGA_HS,
    output       VGA_VS,
    output       VGA_BLANK_N,
    output       VGA_SYNC_N,
    output [7:0] VGA_R,
    output [7:0] VGA_G,
    output [7:0] VGA_B
);
    reg clock = 0;
    always @(posedge CLOCK_50) clock <= ~clock;

    wire [9:0] x, y;
    wire       visible, frame;
    vga_timing timing (.clock(clock), .x(x), .y(y), .visible(visible), .frame(frame),
                       .hs(VGA_HS), .vs(VGA_VS));

    reg  [9:0] ball_x = 316, ball_y = 236, left_y = 208, right_y = 208;
    reg        to_right = 1, to_bottom = 1;
    reg  [3:0] left_points = 0, right_points = 0;

    localparam BALL = 8, BAT = 64, BAT_WIDTH = 8, LEFT_X = 24, RIGHT_X = 608, STEP = 4;

    wire hits_left  = ball_x == LEFT_X + BAT_WIDTH &&
                      ball_y + BALL > left_y && ball_y < left_y + BAT;
    wire hits_right = ball_x + BALL == RIGHT_X &&
                      ball_y + BALL > right_y && ball_y < right_y + BAT;

    always @(posedge clock)
        if (frame) begin
            if (!KEY[3] && left_y >= STEP) left_y <= left_y - STEP;
            if (!KEY[2] && left_y <= 480 - BAT - STEP) left_y <= left_y + STEP;
            if (!KEY[1] && right_y >= STEP) right_y <= right_y - STEP;
            if (!KEY[0] && right_y <= 480 - BAT - STEP) right_y <= right_y + STEP;
            if (!SW[0]) begin
                if (ball_x == 0 || ball_x == 640 - BALL) begin  // behind a bat
                    ball_x <= 316;
                    ball_y <= 236;
                    to_right <= ball_x == 0;
                    if (ball_x == 0) right_points <= right_points + 1;
                    else left_points <= left_points + 1;
                end else begin
                    to_right <= hits_left ? 1 : hits_right ? 0 : to_right;
                    ball_x <= (hits_left || to_right && !hits_right) ? ball_x + STEP
                                                                    : ball_x - STEP;
                    if (ball_y == 0) to_bottom <= 1;
                    if (ball_y == 480 - BALL) to_bottom <= 0;
                    ball_y <= (ball_y == 0 || to_bottom && ball_y != 480 - BALL) ? ball_y + STEP
                                                                                : ball_y - STEP;
                end
            end
        end

    wire ball  = x >= ball_x && x < ball_x + BALL && y >= ball_y && y < ball_y + BALL;
    wire left  = x >= LEFT_X && x < LEFT_X + BAT_WIDTH && y >= left_y && y < left_y + BAT;
    wire right = x >= RIGHT_X && x < RIGHT_X + BAT_WIDTH && y >= right_y && y < right_y + BAT;
    wire net   = x >= 318 && x < 322 && y[4];

    assign VGA_CLK = clock;
    assign VGA_BLANK_N = visible;
    assign VGA_SYNC_N = 0;
    assign VGA_R = !visible ? 0 : ball | right | net ? 8'hff : 8'h00;
    assign VGA_G = !visible ? 0 : ball | left | net ? 8'hff : 8'h20;
    assign VGA_B = !visible ? 0 : ball | net ? 8'hff : 8'h40;
    assign LEDR = {10{ball_x < 8 || ball_x > 624}};

    seven_segment left_digit (.value(left_points), .segments(HEX5));
    seven_segment right_digit (.value(right_points), .segments(HEX0));
endmodule
