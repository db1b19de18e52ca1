// line_buffer.v - two rows of the picture: one on the screen, one being fetched
//
// A row is up to 161 words of two pixels: a row of 320 that begins in the upper half of a word ends
// in the lower half of the 161st.  Two M10K blocks.
//
// On the device both clocks are the same.  In the simulation sim/fpga/line_buffer.v takes its
// place.

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

    always @(posedge wclk_i) if (we_i) words[windex_i] <= wdata_i;
    always @(posedge rclk_i) if (re_i) rdata_o <= words[rindex_i];
endmodule

`default_nettype wire
