// onchip_memory.v - the FPGA's on-chip memory: 256 KB, 65,536 words in byte lanes
//
// One write port and one read port on one clock.  A byte lane is 64 M10K blocks of 1,024 x 8.  A
// read of a word that is written in the same clock gives an undefined value.

`default_nettype none

module onchip_memory (
    input  wire        clk_i,
    input  wire [3:0]  we_i,       // byte lanes
    input  wire [15:0] windex_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire [15:0] rindex_i,
    output reg  [31:0] rdata_o     // one clock later; stays until the next read
);
    reg [7:0] lane0 [0:65535];
    reg [7:0] lane1 [0:65535];
    reg [7:0] lane2 [0:65535];
    reg [7:0] lane3 [0:65535];

    always @(posedge clk_i) begin
        if (we_i[0]) lane0[windex_i] <= wdata_i[7:0];
        if (we_i[1]) lane1[windex_i] <= wdata_i[15:8];
        if (we_i[2]) lane2[windex_i] <= wdata_i[23:16];
        if (we_i[3]) lane3[windex_i] <= wdata_i[31:24];
        if (re_i) rdata_o <= {lane3[rindex_i], lane2[rindex_i], lane1[rindex_i], lane0[rindex_i]};
    end
endmodule

`default_nettype wire
