// beep.v - a tone of 60 ms to the codec, in step with its BCLK: left-justified, 16 bits

module beep (
    input  clock,  // 50 MHz
    input  start,
    input  low,    // 440 Hz, else 880 Hz
    input  bclk,
    input  lrck,
    output dacdat
);
    reg [21:0] left = 0;      // clocks that the tone still lasts
    reg [15:0] phase = 0;
    reg        is_low = 0, high = 0;
    wire [15:0] half = is_low ? 56_818 : 28_409;

    always @(posedge clock)
        if (start) begin
            left <= 3_000_000;
            is_low <= low;
        end else if (left != 0) begin
            left <= left - 1;
            phase <= phase == half - 1 ? 0 : phase + 1;
            if (phase == half - 1) high <= ~high;
        end

    reg [2:0]  bclk_was = 0;
    reg [1:0]  lrck_was = 0;
    reg        side = 0;
    reg [15:0] bits = 0;

    assign dacdat = bits[15];

    always @(posedge clock) begin
        bclk_was <= {bclk_was[1:0], bclk};
        lrck_was <= {lrck_was[0], lrck};
        if (bclk_was[2:1] == 2'b10) begin
            side <= lrck_was[1];
            if (side == lrck_was[1]) bits <= {bits[14:0], 1'b0};
            else if (left == 0) bits <= 0;
            else bits <= high ? 16'h1800 : 16'he800;
        end
    end
endmodule
