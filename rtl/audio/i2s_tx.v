// i2s_tx.v - sends a stereo pair per frame in I2S format, 24 bits in slots of 32
//
//   LRCK  ~~|_______________________________|~~~~~~~~~~~
//   slot  63| 0 | 1 | 2 | ...  |24 |25 |... |32 |33 | ...
//   data   0| 0 |L31|L30| ...  |L8 | 0 |... | 0 |R31| ...
//
// The pair is taken when slot 0 begins: take_o is high in the clock at whose end that happens, and
// left_i and right_i must be valid in it.  Bits 7:0 of a sample are not sent.

`default_nettype none

module i2s_tx (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        fall_i,        // BCLK falls at the end of this clock
    input  wire [5:0]  next_slot_i,   // and this slot begins

    output wire        take_o,
    input  wire [23:0] left_i,
    input  wire [23:0] right_i,

    output reg         dacdat_o
);
    reg [23:0] shift_q, right_q;

    assign take_o = fall_i && next_slot_i == 6'd0;

    always @(posedge clk_i) begin
        if (fall_i) begin
            dacdat_o <= shift_q[23];
            shift_q  <= {shift_q[22:0], 1'b0};
            // By now a whole word has been sent, and zeros after it.
            if (next_slot_i == 6'd0) begin
                shift_q <= left_i;
                right_q <= right_i;
            end
            if (next_slot_i == 6'd32) shift_q <= right_q;
        end
        if (rst_i) begin
            dacdat_o <= 1'b0;
            shift_q  <= 24'd0;
        end
    end
endmodule

`default_nettype wire
