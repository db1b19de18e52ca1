// picture_store.v - the two pictures and who reads them when
//
// The screen's reads always go first; the processor's wait, one clock at the most, since the screen
// reads one clock in four.  Writes never wait.

`default_nettype none

module picture_store (
    input  wire        clk_i,

    input  wire        screen_re_i,
    input  wire        screen_picture_i,
    input  wire [15:0] screen_index_i,

    input  wire        re_i,           // processor; held until rgrant_o
    input  wire        rpicture_i,
    input  wire [15:0] rindex_i,
    output wire        rgrant_o,

    output wire [31:0] rdata_o,        // one clock after whichever read

    input  wire [3:0]  we_i,
    input  wire        wpicture_i,
    input  wire [15:0] windex_i,
    input  wire [31:0] wdata_i
);
    assign rgrant_o = !screen_re_i;

    wire        re      = screen_re_i || re_i;
    wire        picture = screen_re_i ? screen_picture_i : rpicture_i;
    wire [15:0] index   = screen_re_i ? screen_index_i : rindex_i;
    wire [31:0] rdata0, rdata1;
    reg         picture_q;

    picture_memory picture0 (
        .clk_i(clk_i),
        .we_i(wpicture_i ? 4'd0 : we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .re_i(re && !picture), .rindex_i(index), .rdata_o(rdata0)
    );
    picture_memory picture1 (
        .clk_i(clk_i),
        .we_i(wpicture_i ? we_i : 4'd0), .windex_i(windex_i), .wdata_i(wdata_i),
        .re_i(re && picture), .rindex_i(index), .rdata_o(rdata1)
    );

    always @(posedge clk_i) if (re) picture_q <= picture;
    assign rdata_o = picture_q ? rdata1 : rdata0;
endmodule

`default_nettype wire
