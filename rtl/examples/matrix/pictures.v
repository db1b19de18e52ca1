// pictures.v - four pictures of 8 x 8 dots

module pictures (
    input      [1:0] picture,
    input      [2:0] row,
    output reg [7:0] dots      // the left one is bit 7
);
    always @*
        case ({picture, row})
            {2'd0, 3'd0}: dots = 8'b00111100;   // a face
            {2'd0, 3'd1}: dots = 8'b01000010;
            {2'd0, 3'd2}: dots = 8'b10100101;
            {2'd0, 3'd3}: dots = 8'b10000001;
            {2'd0, 3'd4}: dots = 8'b10100101;
            {2'd0, 3'd5}: dots = 8'b10011001;
            {2'd0, 3'd6}: dots = 8'b01000010;
            {2'd0, 3'd7}: dots = 8'b00111100;

            {2'd1, 3'd0}: dots = 8'b01100110;   // a heart
            {2'd1, 3'd1}: dots = 8'b11111111;
            {2'd1, 3'd2}: dots = 8'b11111111;
            {2'd1, 3'd3}: dots = 8'b11111111;
            {2'd1, 3'd4}: dots = 8'b01111110;
            {2'd1, 3'd5}: dots = 8'b00111100;
            {2'd1, 3'd6}: dots = 8'b00011000;
            {2'd1, 3'd7}: dots = 8'b00000000;

            {2'd2, 3'd0}: dots = 8'b00010000;   // an arrow
            {2'd2, 3'd1}: dots = 8'b00011000;
            {2'd2, 3'd2}: dots = 8'b11111100;
            {2'd2, 3'd3}: dots = 8'b11111110;
            {2'd2, 3'd4}: dots = 8'b11111110;
            {2'd2, 3'd5}: dots = 8'b11111100;
            {2'd2, 3'd6}: dots = 8'b00011000;
            {2'd2, 3'd7}: dots = 8'b00010000;

            default: dots = row[0] ? 8'b01010101 : 8'b10101010;
        endcase
endmodule
