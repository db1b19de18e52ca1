// i2s_tone.v - a square wave of 440 Hz as I2S: 48.8 kHz, slots of 32 bits, 16 of them used
//
// SDATA changes as SCLK falls; the first bit of a slot comes one SCLK after LRCLK has moved.

module i2s_tone (
    input  clock,  // 25 MHz
    input  on,
    output sclk,
    output lrclk,  // low: left
    output reg sdata = 0
);
    localparam [15:0] STEP = 16'd591;  // of a turn of 65536: 440 Hz x 65536 / 48.8 kHz

    reg  [8:0]  divider = 0;  // [2:0] an SCLK, [7:3] its number in the slot, [8] the slot
    reg  [15:0] phase = 0;
    wire [4:0]  number = divider[7:3];
    wire [15:0] level = !on ? 16'd0 : phase[15] ? 16'hE000 : 16'h2000;

    assign sclk = divider[2];
    assign lrclk = divider[8];

    always @(posedge clock) begin
        divider <= divider + 9'd1;
        if (divider == 9'd511) phase <= phase + STEP;
        // At the falling edge that begins `number` + 1.
        if (divider[2:0] == 3'd7) sdata <= number < 5'd16 ? level[15 - number[3:0]] : 1'b0;
    end
endmodule
