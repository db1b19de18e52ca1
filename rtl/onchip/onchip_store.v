// onchip_store.v - the on-chip memory and the arbiter of its reads
//
// The screen's reads have priority.  The processor's wait for one clock at most, because the screen
// reads in every second clock at most.  Writes never wait.

`default_nettype none

module onchip_store (
    input  wire        clk_i,

    input  wire        screen_re_i,
    input  wire [15:0] screen_index_i,

    input  wire        re_i,           // processor; held until rgrant_o
    input  wire [15:0] rindex_i,
    output wire        rgrant_o,

    output wire [31:0] rdata_o,        // one clock after a read of either, until the next

    input  wire [3:0]  we_i,
    input  wire [15:0] windex_i,
    input  wire [31:0] wdata_i
);
    assign rgrant_o = !screen_re_i;

    onchip_memory memory (
        .clk_i(clk_i), .we_i(we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .re_i(screen_re_i || re_i), .rindex_i(screen_re_i ? screen_index_i : rindex_i),
        .rdata_o(rdata_o)
    );
endmodule

`default_nettype wire
