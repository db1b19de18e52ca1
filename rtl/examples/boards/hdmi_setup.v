// hdmi_setup.v - writes the registers of an ADV7513 that RGB of 24 bits and sound by I2S need, by
// I2C at 100 kHz
//
// A quarter of a bit at a time: SDA changes while SCL is low.  A register that is not acknowledged
// is written again.

module hdmi_setup (
    input      clock,  // 25 MHz
    output     scl,
    inout      sda,
    output reg done = 0
);
    localparam LAST = 15;

    reg  [5:0]  divider = 0;
    reg  [1:0]  quarter = 0;
    reg  [4:0]  part = 0;      // 0 START, 1 to 27 the bits of three bytes, 28 STOP, 29 and 30 pause
    reg  [3:0]  index = 0;
    reg         refused = 0;
    reg  [15:0] entry;         // register and value
    wire [26:0] bits = {8'h72, 1'b1, entry[15:8], 1'b1, entry[7:0], 1'b1};
    wire        acknowledges = part == 9 || part == 18 || part == 27;

    always @*
        case (index)
            0: entry = 16'h4110;   // power up
            1: entry = 16'h9803;   // values that the Programming Guide wants
            2: entry = 16'h9ae0;
            3: entry = 16'h9c30;
            4: entry = 16'h9d61;
            5: entry = 16'ha2a4;
            6: entry = 16'ha3a4;
            7: entry = 16'he0d0;
            8: entry = 16'hf900;
            9: entry = 16'h1520;   // RGB of 24 bits, syncs apart; the monitor is told 48 kHz
            10: entry = 16'h1630;  // 8 bits a colour
            11: entry = 16'h1846;  // no conversion of colours
            12: entry = 16'haf06;  // HDMI, which has sound
            13: entry = 16'h0cbc;  // sound in the format I2S
            14: entry = 16'h0218;  // N = 6144, for rates about 48 kHz
            default: entry = 16'h4080;
        endcase

    reg low, clock_low;
    always @* begin
        low = 0;
        clock_low = 0;
        if (!done)
            if (part == 0) begin
                low = quarter >= 2;
                clock_low = quarter == 3;
            end else if (part <= 27) begin
                low = !bits[27 - part];
                clock_low = quarter == 0 || quarter == 3;
            end else if (part == 28) begin
                low = quarter < 2;
                clock_low = quarter == 0;
            end
    end
    assign sda = low ? 1'b0 : 1'bz;
    assign scl = !clock_low;

    always @(posedge clock) begin
        divider <= divider == 62 ? 0 : divider + 1;
        if (divider == 62 && !done) begin
            quarter <= quarter + 1;
            if (acknowledges && quarter == 2 && sda) refused <= 1;
            if (quarter == 3) part <= part == 30 ? 0 : part + 1;
            if (quarter == 3 && part == 30) begin
                refused <= 0;
                if (!refused) begin
                    index <= index + 1;
                    done <= index == LAST;
                end
            end
        end
    end
endmodule
