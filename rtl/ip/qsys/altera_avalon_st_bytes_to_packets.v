// altera_avalon_st_bytes_to_packets.v - Platform Designer's converter of bytes to packets
//
// The bytes are those of altera_avalon_st_packets_to_bytes.v.
//
// Source: Platform Designer User Guide, Avalon-ST Bytes to Packets Converter.

`default_nettype none

module altera_avalon_st_bytes_to_packets (
    input  wire       clk,
    input  wire       reset_n,

    output wire       in_ready,
    input  wire       in_valid,
    input  wire [7:0] in_data,

    input  wire       out_ready,
    output wire       out_valid,
    output wire [7:0] out_data,
    output wire [7:0] out_channel,
    output wire       out_startofpacket,
    output wire       out_endofpacket
);
    reg        begins_q, ends_q, names_q, escaped_q;
    reg  [7:0] channel_q;
    wire       is_special = in_data >= 8'h7a && in_data <= 8'h7d && !escaped_q;
    wire       is_data    = !is_special && !names_q;

    assign out_valid         = in_valid && is_data;
    assign in_ready          = !is_data || out_ready;
    assign out_data          = escaped_q ? in_data ^ 8'h20 : in_data;
    assign out_channel       = channel_q;
    assign out_startofpacket = begins_q;
    assign out_endofpacket   = ends_q;

    always @(posedge clk) begin
        if (in_valid && in_ready) begin
            escaped_q <= is_special && in_data == 8'h7d;
            if (is_special)
                case (in_data)
                    8'h7a:   begins_q <= 1'b1;
                    8'h7b:   ends_q   <= 1'b1;
                    8'h7c:   names_q  <= 1'b1;
                    default: ;
                endcase
            else begin
                if (names_q) channel_q <= out_data;
                else {begins_q, ends_q} <= 2'b00;
                names_q <= 1'b0;
            end
        end
        if (!reset_n) begin
            {begins_q, ends_q, names_q, escaped_q} <= 4'd0;
            channel_q <= 8'd0;
        end
    end
endmodule

`default_nettype wire
