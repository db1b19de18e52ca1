// ps2_keyboard.v - the keyboard's frames of 11 bits: which key has gone down

module ps2_keyboard (
    input            clock,
    input            ps2_clk,
    input            ps2_dat,
    output reg       pressed,  // for one clock
    output reg [7:0] key       // its code of set 2
);
    reg [2:0]  level = 0;
    reg [9:0]  frame = 0;      // the last bits, the newest at the left
    reg [3:0]  count = 0;
    reg        released = 0;   // F0 came before
    reg [15:0] quiet = 0;

    wire       falls = level[2] && !level[1];
    wire [7:0] code = frame[8:1];

    always @(posedge clock) begin
        level <= {level[1:0], ps2_clk};
        pressed <= 0;
        quiet <= falls ? 0 : quiet + 1;
        if (&quiet) count <= 0;  // a frame lasts less than a millisecond between its bits
        if (falls) begin
            frame <= {ps2_dat, frame[9:1]};
            count <= count == 10 ? 0 : count + 1;
            if (count == 10) begin
                key <= code;
                pressed <= !released && code != 8'hf0 && code != 8'he0;
                if (code != 8'he0) released <= code == 8'hf0;
            end
        end
    end
endmodule
