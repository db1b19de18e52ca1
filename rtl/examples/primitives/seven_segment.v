// seven_segment.v - a digit as the segments of HEX0 to HEX5, which are lit by 0

module seven_segment (
    input  wire [3:0] digit,
    output reg  [6:0] hex
);
    always @*
        case (digit)
            4'h0: hex = 7'h40;
            4'h1: hex = 7'h79;
            4'h2: hex = 7'h24;
            4'h3: hex = 7'h30;
            4'h4: hex = 7'h19;
            4'h5: hex = 7'h12;
            4'h6: hex = 7'h02;
            4'h7: hex = 7'h78;
            4'h8: hex = 7'h00;
            4'h9: hex = 7'h10;
            4'ha: hex = 7'h08;
            4'hb: hex = 7'h03;
            4'hc: hex = 7'h46;
            4'hd: hex = 7'h21;
            4'he: hex = 7'h06;
            4'hf: hex = 7'h0e;
        endcase
endmodule
