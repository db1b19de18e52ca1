// altera_up_avalon_adc.v - the University Program's ADC controller, on the board's LTC2308
//
//   +00 ... +1C  channel 0 ... 7  bits 11:0 the voltage, 1 mV each; bit 15, while channels are
//                                 converted continuously: new since last read
//   +00          channel 0        a write of any value converts all channels once; a read before
//                                 the end waits for it
//   +04          channel 1        a write of bit 0 = 1 converts them continuously
//
// A round has one transfer more than there are CHANNELS, because a transfer returns the conversion
// that the previous one asked for; at its end all channels are new.  A transfer is CONVST,
// CONVERSION clocks, and twelve bits each way, each of two HALFs of SCK.  Channels that are not
// converted are 0.  A write during a round asks for nothing.
//
// Source: Intel FPGA University Program, ADC Controller for DE-Series Boards, and the Verilog that
// it generates; Linear Technology, LTC2308.
//
// Not handled: the other converters, AD7928 of early boards among them, for which the vendor's core
// looks in its first round.

`default_nettype none

module altera_up_avalon_adc #(
    parameter CHANNELS   = 8,
    parameter HALF       = 4,     // clocks
    parameter CONVERSION = 200    // clocks, 1.6 us or more
) (
    input  wire        clock,
    input  wire        reset,
    input  wire [2:0]  address,
    input  wire        read,
    input  wire        write,
    // verilator lint_off UNUSED
    input  wire [31:0] writedata,
    // verilator lint_on UNUSED
    output wire [31:0] readdata,
    output wire        waitrequest,
    output reg         adc_cs_n,  // CONVST
    output reg         adc_sclk,
    output wire        adc_din,
    input  wire        adc_dout
);
    localparam [15:0] PAUSE = CONVERSION[15:0] - 16'd1, LEVEL = HALF[15:0] - 16'd1;

    reg        busy_q, asked_q, continuous_q;
    reg [3:0]  transfer_q;  // asks for this channel, returns the one before
    reg [15:0] pause_q;     // clocks to the next step
    reg [3:0]  left_q;      // bits
    reg [11:0] bits_q;      // sent from the top, received at the bottom

    assign adc_din = bits_q[11];

    // Single-ended, unipolar, awake: S/D, O/S, S1, S0, UNI, SLP.  O/S is the channel's lowest bit.
    function [11:0] request;
        input [2:0] channel;
        request = {1'b1, channel[0], channel[2:1], 1'b1, 1'b0, 6'd0};
    endfunction

    wire begins = !busy_q && (asked_q || continuous_q);
    wire done   = busy_q && pause_q == 16'd0 && !adc_cs_n && left_q == 4'd0;
    wire ends   = done && transfer_q == CHANNELS[3:0];

    always @(posedge clock) begin
        if (write && address == 3'd0 && !busy_q) asked_q <= 1'b1;
        if (write && address == 3'd1) continuous_q <= writedata[0];
        if (begins) asked_q <= 1'b0;
        if (begins || (done && !ends)) begin
            busy_q     <= 1'b1;
            transfer_q <= begins ? 4'd0 : transfer_q + 4'd1;
            bits_q     <= request(begins ? 3'd0 : transfer_q[2:0] + 3'd1);
            left_q     <= 4'd12;
            adc_cs_n   <= 1'b1;
            pause_q    <= LEVEL;
        end else if (ends) begin
            busy_q <= 1'b0;
        end else if (pause_q != 16'd0) begin
            pause_q <= pause_q - 16'd1;
        end else if (busy_q && adc_cs_n) begin
            adc_cs_n <= 1'b0;
            pause_q  <= PAUSE;
        end else if (busy_q) begin
            adc_sclk <= !adc_sclk;
            pause_q  <= LEVEL;
            if (adc_sclk) begin
                bits_q <= {bits_q[10:0], adc_dout};
                left_q <= left_q - 4'd1;
            end
        end
        if (reset) begin
            {busy_q, asked_q, continuous_q, adc_cs_n, adc_sclk} <= 5'd0;
            pause_q <= 16'd0;
        end
    end

    // ---- Channels ----
    reg [11:0] converted_q [0:7], values_q [0:7];
    reg [7:0]  new_q;
    integer    n;

    wire [2:0] returned = transfer_q[2:0] - 3'd1;

    assign waitrequest = read && (busy_q || asked_q) && !continuous_q;
    assign readdata    = {16'd0, new_q[address] && continuous_q, 3'd0, values_q[address]};

    always @(posedge clock) begin
        if (done && transfer_q != 4'd0) converted_q[returned] <= bits_q;
        if (read && continuous_q) new_q[address] <= 1'b0;
        if (ends) begin
            new_q <= 8'hff;
            for (n = 0; n < CHANNELS - 1; n = n + 1) values_q[n] <= converted_q[n];
            values_q[CHANNELS - 1] <= bits_q;
        end
        if (reset) new_q <= 8'd0;
    end
endmodule

`default_nettype wire
