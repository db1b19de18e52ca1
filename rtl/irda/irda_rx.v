// irda_rx.v - takes bytes from an infrared receiver: 115,200 baud, 8 data bits, pulses for zeros
//
//   rxd_i  ~|_|~~~~~~~~|_|~~~~~~~~~~~~~~~~~~~|_|~~   low: light
//           start 0     bit 0 = 0  bit 1 = 1  bit 2 = 0
//
// A byte begins with the first low level.  Each of its ten bits is the level 1.2 us after the bit's
// begin; the stop bit is not checked.  So one long low level is received as consecutive zero bytes.

`default_nettype none

module irda_rx (
    input  wire       clk_i,
    input  wire       rst_i,

    input  wire       rxd_i,       // asynchronous, high while it is dark

    output reg        valid_o,     // one clock, with the byte
    output wire [7:0] data_o,

    output wire       awake_o
);
    localparam [7:0] SAMPLE = 8'd30;    // 1.2 us
    localparam [7:0] LAST   = 8'd216;   // 8.68 us per bit
    localparam [7:0] END    = 8'd212;   // of the stop bit: early, so as not to fall behind

    wire rxd, rxd_awake;
    sync rxd_sync (.clk_i(clk_i), .async_i(rxd_i), .sync_o(rxd), .awake_o(rxd_awake));

    reg       busy_q;
    reg [7:0] clock_q;   // of the bit
    reg [3:0] bit_q;
    reg [8:0] bits_q;    // the latest on top; in the end the start bit has been shifted out

    assign data_o  = bits_q[7:0];
    assign awake_o = rxd_awake || !rxd || busy_q || valid_o;

    always @(posedge clk_i) begin
        valid_o <= 1'b0;
        if (!busy_q && !rxd) begin
            busy_q  <= 1'b1;
            clock_q <= 8'd0;
            bit_q   <= 4'd0;
        end
        if (busy_q) begin
            clock_q <= clock_q == LAST ? 8'd0 : clock_q + 8'd1;
            if (clock_q == SAMPLE) bits_q <= {rxd, bits_q[8:1]};
            if (clock_q == LAST) bit_q <= bit_q + 4'd1;
            if (clock_q == END && bit_q == 4'd9) begin
                busy_q  <= 1'b0;
                valid_o <= 1'b1;
            end
        end
        if (rst_i) begin
            busy_q  <= 1'b0;
            valid_o <= 1'b0;
        end
    end
endmodule

`default_nettype wire
