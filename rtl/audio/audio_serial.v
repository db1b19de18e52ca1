// audio_serial.v - the serial side of the audio block: BCLK and LRCK of a WM8731 in slave mode
//
//   clk_i   _|~|_|~|_|~|_|~|_|~|_   128 per frame
//   BCLK    ~~~|___|~~~|___|~~~|_   64 per frame
//   slot      63   | 0     | 1      LRCK is low for slots 0 to 31 and high for 32 to 63
//
// LRCK and data move when BCLK falls.  A frame takes the pair that it sends when it begins, or
// zeros if none waits.  It has received a pair in the middle of slot 56.  The other clock domain
// learns of the frame by this received pair, and has the 15 clocks that are left to provide the
// pair of the next frame.

`default_nettype none

module audio_serial (
    input  wire        clk_i,
    input  wire        rst_i,

    output reg         bclk_o,
    output wire        lrck_o,
    output wire        dacdat_o,
    input  wire        adcdat_i,    // changes after BCLK falls

    input  wire        waits_i,     // a pair to send
    input  wire [47:0] pair_i,      // left, right
    output wire        take_o,      // it counts in this clock

    output wire        received_o,  // one clock per frame
    output wire [47:0] pair_o
);
    reg  [5:0] slot_q;
    wire [5:0] next_slot = slot_q + 6'd1;

    assign lrck_o = slot_q[5];

    always @(posedge clk_i) begin
        bclk_o <= !bclk_o;
        if (bclk_o) slot_q <= next_slot;
        if (rst_i) begin
            bclk_o <= 1'b0;
            slot_q <= 6'd63;   // the first fall of BCLK begins a frame
        end
    end

    i2s_tx tx (
        .clk_i(clk_i), .rst_i(rst_i), .fall_i(bclk_o), .next_slot_i(next_slot), .take_o(take_o),
        .left_i(waits_i ? pair_i[47:24] : 24'd0), .right_i(waits_i ? pair_i[23:0] : 24'd0),
        .dacdat_o(dacdat_o)
    );
    i2s_rx rx (
        .clk_i(clk_i), .rst_i(rst_i), .rise_i(!bclk_o), .slot_i(slot_q), .adcdat_i(adcdat_i),
        .valid_o(received_o), .left_o(pair_o[47:24]), .right_o(pair_o[23:0])
    );
endmodule

`default_nettype wire
