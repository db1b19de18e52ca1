// line_buffer.v - in the simulation: rtl/vga/line_buffer.v, and which of its blocks are flat
//
// flat: the 16 pixels of the block of rindex_i equal the pixel before them.  The colour on the
// screen then stays, and these pixels need not be read.  Words must be written in ascending order.

`default_nettype none

module line_buffer (
    input  wire        wclk_i,
    input  wire        we_i,
    input  wire [8:0]  windex_i,   // row's parity, word
    input  wire [31:0] wdata_i,

    input  wire        rclk_i,
    input  wire        re_i,
    input  wire [8:0]  rindex_i,
    output reg  [31:0] rdata_o     // one clock later; stays until the next read
);
    reg [31:0] words [0:511];
    reg [19:0] even_q, odd_q;      // flat blocks (of eight words) of the even and the odd row
    reg [15:0] last_q;             // the pixel before
    reg        so_far_q;           // all pixels of this block so far equal it

    wire [4:0] block = windex_i[7:3];
    wire       same  = wdata_i == {last_q, last_q} && (so_far_q || windex_i[2:0] == 3'd0);

    wire       whole = same && windex_i[2:0] == 3'd7;

    // The first block has no pixel before it.
    wire [4:0] shown = rindex_i[7:3];
    wire       flat  = shown != 5'd0 && (rindex_i[8] ? odd_q[shown] : even_q[shown]);

    always @(posedge wclk_i)
        if (we_i) begin
            words[windex_i] <= wdata_i;
            last_q          <= wdata_i[31:16];
            so_far_q        <= same;
            if (windex_i[8]) odd_q[block] <= whole;
            else even_q[block] <= whole;
        end

    always @(posedge rclk_i) if (re_i) rdata_o <= words[rindex_i];
endmodule

`default_nettype wire
