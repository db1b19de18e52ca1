// altera_avalon_st_packets_to_bytes.v - Platform Designer's converter of packets to bytes
//
//   0x7a a packet begins   0x7b it ends with the next byte   0x7c the next byte is the channel
//   0x7d the next byte is one of these four, XOR 0x20
//
// The channel comes before a packet, and where it changes.
//
// Source: Platform Designer User Guide, Avalon-ST Packets to Bytes Converter.

`default_nettype none

module altera_avalon_st_packets_to_bytes (
    input  wire       clk,
    input  wire       reset_n,

    output wire       in_ready,
    input  wire       in_valid,
    input  wire [7:0] in_data,
    input  wire [7:0] in_channel,
    input  wire       in_startofpacket,
    input  wire       in_endofpacket,

    input  wire       out_ready,
    output wire       out_valid,
    output reg  [7:0] out_data
);
    function is_special;
        input [7:0] data;
        is_special = data >= 8'h7a && data <= 8'h7d;
    endfunction

    reg  [5:0] sent_q;       // of what comes before the byte itself
    reg  [7:0] channel_q;
    wire       names = in_startofpacket || in_channel != channel_q;
    wire [5:0] wants = {is_special(in_data), in_endofpacket, in_startofpacket, names,
                        names && is_special(in_channel), names} & ~sent_q;

    assign out_valid = in_valid;
    assign in_ready  = out_ready && wants == 6'd0;

    always @*
        if (wants[0])      out_data = 8'h7c;
        else if (wants[1]) out_data = 8'h7d;
        else if (wants[2]) out_data = is_special(in_channel) ? in_channel ^ 8'h20 : in_channel;
        else if (wants[3]) out_data = 8'h7a;
        else if (wants[4]) out_data = 8'h7b;
        else if (wants[5]) out_data = 8'h7d;
        else               out_data = is_special(in_data) ? in_data ^ 8'h20 : in_data;

    always @(posedge clk) begin
        if (in_valid && out_ready) begin
            sent_q <= wants == 6'd0 ? 6'd0 : sent_q | (wants & ~(wants - 6'd1));
            if (wants == 6'd0) channel_q <= in_channel;
        end
        if (!reset_n) begin
            sent_q    <= 6'd0;
            channel_q <= 8'd0;
        end
    end
endmodule

`default_nettype wire
