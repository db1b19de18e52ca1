// tilt_sensor.v - reads X of an ADXL345 over and over, by SPI of four wires
//
//   2D 08    measure                F2 then two bytes: X's low and high byte, 256 to the g
//
// SPI mode 3 at 390 kHz: what is sent changes at the fall of SCLK, and is taken at its rise.

module tilt_sensor (
    input            clock,    // 25 MHz
    output reg       cs_n = 1,
    output           sclk,
    output           sdi,
    input            sdo,
    output reg [7:0] x = 0     // bits 9 to 2
);
    reg  [5:0]  divider = 0;
    reg  [5:0]  step = 0;      // halves of a bit, from the begin of a transfer on
    reg         measures = 0;  // 2D has been written
    reg  [23:0] sent = 0, taken = 0;
    wire [5:0]  last = measures ? 48 : 32;

    assign sclk = cs_n || !step[0];
    assign sdi = sent[23];

    always @(posedge clock) begin
        divider <= divider == 31 ? 0 : divider + 1;
        if (divider == 31) begin
            if (cs_n) begin
                cs_n <= 0;
                step <= 0;
                sent <= measures ? 24'hf20000 : 24'h2d0800;
            end else if (step == last) begin
                cs_n <= 1;
                measures <= 1;
                if (measures) x <= {taken[1:0], taken[15:10]};
            end else begin
                step <= step + 1;
                if (step[0]) taken <= {taken[22:0], sdo};
                if (!step[0] && step != 0) sent <= sent << 1;
            end
        end
    end
endmodule
