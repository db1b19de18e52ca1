// irda_tx.v - sends bytes as light: 115,200 baud, 8 data bits, a pulse of 3/16 of a bit for a zero

`default_nettype none

module irda_tx (
    input  wire       clk_i,
    input  wire       rst_i,

    input  wire       waits_i,   // a byte to send
    input  wire [7:0] data_i,
    output wire       take_o,    // it counts in this clock

    output reg        txd_o,     // 1 = light

    output wire       awake_o
);
    localparam [7:0] PULSE = 8'd41;    // 1.63 us
    localparam [7:0] LAST  = 8'd216;   // 8.68 us per bit

    reg       busy_q;
    reg [7:0] clock_q;   // of the bit
    reg [3:0] bit_q;
    reg [9:0] bits_q;    // start, 8 of data, stop; bit 0 is the one on the wire

    assign take_o  = waits_i && !busy_q;
    assign awake_o = waits_i || busy_q;

    always @(posedge clk_i) begin
        txd_o <= busy_q && !bits_q[0] && clock_q < PULSE;
        if (take_o) begin
            busy_q  <= 1'b1;
            bits_q  <= {1'b1, data_i, 1'b0};
            clock_q <= 8'd0;
            bit_q   <= 4'd0;
        end
        if (busy_q) begin
            clock_q <= clock_q == LAST ? 8'd0 : clock_q + 8'd1;
            if (clock_q == LAST) begin
                bits_q <= {1'b1, bits_q[9:1]};
                bit_q  <= bit_q + 4'd1;
                if (bit_q == 4'd9) busy_q <= 1'b0;
            end
        end
        if (rst_i) begin
            busy_q <= 1'b0;
            txd_o  <= 1'b0;
        end
    end
endmodule

`default_nettype wire
