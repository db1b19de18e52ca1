// matrix.v - a matrix of 8 x 8 LEDs on GPIO_1, and two push buttons beside it
//
// The rows are on GPIO_1[7:0], the top one on [7], and high while they are shown; the columns are
// on GPIO_1[15:8], the left one on [15], and low where an LED is lit.  A row is shown for a
// millisecond, so the whole picture 125 times a second.
//
// The button on GPIO_1[16] shows the next picture; while the one on GPIO_1[17] is held, the
// lower half of the picture is dimmed.  Both pull their pin low.  HEX0 has the picture's number.

module matrix (
    input         CLOCK_50,
    inout  [35:0] GPIO_1,
    output [6:0]  HEX0
);
    // ---- Rows in turn ----

    reg [15:0] clocks = 0;
    reg [2:0]  row = 0;

    wire last = clocks == 49_999;  // of a millisecond

    always @(posedge CLOCK_50)
        if (last) begin
            clocks <= 0;
            row <= row + 1;
        end else clocks <= clocks + 1;

    // ---- The buttons, looked at once a millisecond ----

    reg [1:0] next_is = 2'b11, dim_is = 2'b11;
    reg [1:0] picture = 0;

    always @(posedge CLOCK_50)
        if (last) begin
            next_is <= {next_is[0], GPIO_1[16]};
            dim_is <= {dim_is[0], GPIO_1[17]};
            if (next_is == 2'b10) picture <= picture + 1;
        end

    // ---- Pictures ----

    wire [7:0] dots;
    pictures rom (.picture(picture), .row(row), .dots(dots));

    wire dim   = !dim_is[1] && row[2];
    wire shown = clocks >= 500 && clocks < (dim ? 10_500 : 49_500);  // dark between two rows

    assign GPIO_1[7:0]  = shown ? 8'h80 >> row : 8'h00;
    assign GPIO_1[15:8] = ~dots;

    assign HEX0 = picture == 0 ? 7'b1000000 :
                  picture == 1 ? 7'b1111001 :
                  picture == 2 ? 7'b0100100 : 7'b0110000;
endmodule
