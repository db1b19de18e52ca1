// codec_setup.v - writes the registers of the WM8731 over I2C, at 100 kHz
//
// A word that is not acknowledged is sent again.

module codec_setup (
    input      clock,
    output reg sclk,
    inout      sdat,
    output     done
);
    localparam WORDS = 6;

    reg  [2:0]  word = 0;
    reg  [15:0] data;
    always @(*)
        case (word)
            0: data = {7'd4, 9'h010};        // the DAC is heard
            1: data = {7'd5, 9'h000};        // not muted
            2: data = {7'd6, 9'h000};        // all is on
            3: data = {7'd7, 9'h041};        // bus master, left-justified, 16 bits
            4: data = {7'd8, 9'h000};        // 256 clocks a sample
            default: data = {7'd9, 9'h001};  // active
        endcase

    // START, three bytes with a bit for the acknowledge, STOP; each in four quarters.
    reg  [6:0]  quarter = 0;                 // of 125 clocks
    reg  [6:0]  pause = 0;
    reg         refused = 0;
    wire [4:0]  slot = quarter[6:2];
    wire        acknowledge = slot == 9 || slot == 18 || slot == 27;
    wire [26:0] bits = {8'h34, 1'b1, data[15:8], 1'b1, data[7:0], 1'b1};
    reg         level = 1;

    assign done = word == WORDS;
    assign sdat = level ? 1'bz : 1'b0;
    initial sclk = 1;

    always @(posedge clock) begin
        pause <= pause == 124 ? 0 : pause + 1;
        if (pause == 124 && !done) begin
            quarter <= quarter == 115 ? 0 : quarter + 1;
            case (slot)
                0: begin
                    sclk <= quarter[1:0] != 3;
                    level <= quarter[1:0] < 2;
                end
                28: begin
                    sclk <= quarter[1:0] != 0;
                    level <= quarter[1:0] == 3;
                end
                default: begin
                    sclk <= quarter[1:0] == 1 || quarter[1:0] == 2;
                    level <= bits[27 - slot];
                end
            endcase
            if (quarter == 0) refused <= 0;
            else if (acknowledge && quarter[1:0] == 2) refused <= refused | sdat;
            if (quarter == 115 && !refused) word <= word + 1;
        end
    end
endmodule
