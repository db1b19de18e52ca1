// character_store.v - 80 x 60 characters, four per word, read by the screen and the processor
//
// An index is row << 5 | word: four byte lanes of 2,048 characters, two M10K blocks each.  Words
// from 20 and rows from 60 on are memory that is not shown.  The screen's reads have priority; the
// processor's wait for them (video.v).
//
// clear_i fills the 60 rows with blanks, a reset with zeros as the FPGA's configuration does, in
// 1,920 clocks without writes; a zero shows nothing, too.  Meanwhile filling_o, high from clear_i
// on, makes the processor wait: otherwise its writes could be blanked and its reads could be stale.
// any_o is high once something else than blanks has been written since, so that nothing is fetched
// for an empty screen.

`default_nettype none

module character_store (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        clear_i,
    output reg         clearing_o,       // after clear_i, not after a reset
    output wire        filling_o,        // during and after either
    output reg         any_o,

    input  wire        screen_re_i,
    input  wire [10:0] screen_index_i,
    input  wire        re_i,
    input  wire [10:0] rindex_i,
    output reg  [31:0] rdata_o,          // one clock after a read of either; stays until the next

    input  wire [3:0]  we_i,             // byte lanes
    input  wire [10:0] windex_i,
    input  wire [31:0] wdata_i,

    output wire        awake_o
);
    `include "lanes.vh"

    localparam [10:0] LAST   = 11'd1919;
    localparam [31:0] BLANKS = 32'h2020_2020;

    reg [7:0]  lane0 [0:2047];
    reg [7:0]  lane1 [0:2047];
    reg [7:0]  lane2 [0:2047];
    reg [7:0]  lane3 [0:2047];
    reg [10:0] fill_q;
    reg        filling_q;

    assign filling_o = filling_q || clear_i;

    wire [10:0] read  = screen_re_i ? screen_index_i : rindex_i;
    wire        write = we_i != 4'd0;
    wire        fill  = filling_q && !write;
    wire [10:0] place = write ? windex_i : fill_q;
    wire [31:0] wdata = write ? wdata_i : clearing_o ? BLANKS : 32'd0;

    assign awake_o = filling_q;

    always @(posedge clk_i)
        if (screen_re_i || re_i) rdata_o <= {lane3[read], lane2[read], lane1[read], lane0[read]};

    always @(posedge clk_i) begin
        if (we_i[0] || fill) lane0[place] <= wdata[7:0];
        if (we_i[1] || fill) lane1[place] <= wdata[15:8];
        if (we_i[2] || fill) lane2[place] <= wdata[23:16];
        if (we_i[3] || fill) lane3[place] <= wdata[31:24];
        if (fill) begin
            filling_q <= fill_q != LAST;
            if (fill_q == LAST) clearing_o <= 1'b0;
            fill_q    <= fill_q + 11'd1;
        end
        if (((wdata_i ^ BLANKS) & lanes(we_i)) != 32'd0) any_o <= 1'b1;
        if (clear_i || rst_i) begin
            fill_q     <= 11'd0;
            filling_q  <= 1'b1;
            clearing_o <= !rst_i;
            any_o      <= 1'b0;
        end
    end
endmodule

`default_nettype wire
