// i2s_rx.v - receives a stereo pair a frame in I2S format, 24 bits in slots of 32
//
// The codec moves ADCDAT when BCLK falls.  Read when BCLK falls next and through two flip-flops,
// the level is that of two clocks before: never earlier than the middle of BCLK's high half, when
// the codec's 35 ns and the board's delays have long passed.

`default_nettype none

module i2s_rx (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        fall_i,        // from audio_clocks
    input  wire [5:0]  next_slot_i,

    input  wire        adcdat_i,      // asynchronous

    output reg         valid_o,       // one clock a frame, beside the new pair
    output reg  [23:0] left_o,
    output reg  [23:0] right_o,

    output wire        awake_o
);
    localparam [5:0] LEFT_END  = 6'd25;   // the slot after the last bit: bits are in 1 to 24
    localparam [5:0] RIGHT_END = 6'd57;

    wire       adcdat;
    reg [22:0] shift_q;

    wire       adcdat_awake;
    sync adcdat_sync (
        .clk_i(clk_i), .async_i(adcdat_i), .sync_o(adcdat), .awake_o(adcdat_awake)
    );

    assign awake_o = valid_o || adcdat_awake;

    always @(posedge clk_i) begin
        valid_o <= 1'b0;
        if (fall_i) begin
            valid_o <= next_slot_i == RIGHT_END;
            shift_q <= {shift_q[21:0], adcdat};
            if (next_slot_i == LEFT_END) left_o <= {shift_q, adcdat};
            if (next_slot_i == RIGHT_END) right_o <= {shift_q, adcdat};
        end
        if (rst_i) begin
            valid_o <= 1'b0;
            shift_q <= 23'd0;
            left_o  <= 24'd0;
            right_o <= 24'd0;
        end
    end
endmodule

`default_nettype wire
