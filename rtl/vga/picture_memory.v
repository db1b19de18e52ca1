// picture_memory.v - the two pictures, one behind the other: 76,800 words of two pixels
//
// One write port and one read port on one clock.  Each byte lane is two simple dual-port memories,
// of 5 bits (38 M10K blocks of 2,048 x 5) and of 3 (30 of 8,192 x 1), so no bit of a block lies
// idle: 272 blocks in all, where memories of 8 bits take 304.  What a read gives of a word that is
// written in the same clock is not defined.

`default_nettype none

module picture_memory #(
    parameter WORDS = 76800
) (
    input  wire        clk_i,
    input  wire [3:0]  we_i,       // byte lanes
    input  wire [16:0] windex_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire [16:0] rindex_i,
    output reg  [31:0] rdata_o     // one clock later; stays until the next read
);
    reg [4:0] low0 [0:WORDS-1];
    reg [4:0] low1 [0:WORDS-1];
    reg [4:0] low2 [0:WORDS-1];
    reg [4:0] low3 [0:WORDS-1];
    reg [2:0] high0 [0:WORDS-1];
    reg [2:0] high1 [0:WORDS-1];
    reg [2:0] high2 [0:WORDS-1];
    reg [2:0] high3 [0:WORDS-1];

    always @(posedge clk_i) begin
        if (we_i[0]) {high0[windex_i], low0[windex_i]} <= wdata_i[7:0];
        if (we_i[1]) {high1[windex_i], low1[windex_i]} <= wdata_i[15:8];
        if (we_i[2]) {high2[windex_i], low2[windex_i]} <= wdata_i[23:16];
        if (we_i[3]) {high3[windex_i], low3[windex_i]} <= wdata_i[31:24];
        if (re_i) rdata_o <= {high3[rindex_i], low3[rindex_i], high2[rindex_i], low2[rindex_i],
                              high1[rindex_i], low1[rindex_i], high0[rindex_i], low0[rindex_i]};
    end
endmodule

`default_nettype wire
