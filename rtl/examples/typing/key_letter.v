// key_letter.v - the letter on a key, in ASCII; 0 where it has none

module key_letter (
    input      [7:0] key,
    output reg [6:0] letter
);
    always @(*)
        case (key)
            8'h1c: letter = "A";
            8'h32: letter = "B";
            8'h21: letter = "C";
            8'h23: letter = "D";
            8'h24: letter = "E";
            8'h2b: letter = "F";
            8'h34: letter = "G";
            8'h33: letter = "H";
            8'h43: letter = "I";
            8'h3b: letter = "J";
            8'h42: letter = "K";
            8'h4b: letter = "L";
            8'h3a: letter = "M";
            8'h31: letter = "N";
            8'h44: letter = "O";
            8'h4d: letter = "P";
            8'h15: letter = "Q";
            8'h2d: letter = "R";
            8'h1b: letter = "S";
            8'h2c: letter = "T";
            8'h3c: letter = "U";
            8'h2a: letter = "V";
            8'h1d: letter = "W";
            8'h22: letter = "X";
            8'h35: letter = "Y";
            8'h1a: letter = "Z";
            8'h45: letter = "0";
            8'h16: letter = "1";
            8'h1e: letter = "2";
            8'h26: letter = "3";
            8'h25: letter = "4";
            8'h2e: letter = "5";
            8'h36: letter = "6";
            8'h3d: letter = "7";
            8'h3e: letter = "8";
            8'h46: letter = "9";
            8'h41: letter = ",";
            8'h49: letter = ".";
            8'h4e: letter = "-";
            8'h29: letter = " ";
            default: letter = 0;
        endcase
endmodule
