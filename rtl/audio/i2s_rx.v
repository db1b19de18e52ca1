// i2s_rx.v - receives a stereo pair per frame in I2S format, 24 bits in slots of 32
//
// The codec changes ADCDAT when BCLK falls, and BCLK is an output of the FPGA.  ADCDAT is sampled
// when BCLK rises, half a period later.  The codec's 35 ns and the board's delays have passed by
// then, so no synchroniser is needed.

`default_nettype none

module i2s_rx (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        rise_i,        // BCLK rises at the end of this clock
    input  wire [5:0]  slot_i,

    input  wire        adcdat_i,

    output reg         valid_o,       // one clock per frame, with the new pair
    output reg  [23:0] left_o,
    output reg  [23:0] right_o
);
    localparam [5:0] LEFT_LAST  = 6'd24;   // bits are in slots 1 to 24
    localparam [5:0] RIGHT_LAST = 6'd56;   // and 33 to 56

    reg [22:0] shift_q;

    always @(posedge clk_i) begin
        valid_o <= 1'b0;
        if (rise_i) begin
            valid_o <= slot_i == RIGHT_LAST;
            shift_q <= {shift_q[21:0], adcdat_i};
            if (slot_i == LEFT_LAST) left_o <= {shift_q, adcdat_i};
            if (slot_i == RIGHT_LAST) right_o <= {shift_q, adcdat_i};
        end
        if (rst_i) valid_o <= 1'b0;
    end
endmodule

`default_nettype wire
