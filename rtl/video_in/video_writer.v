// video_writer.v - video-in's words into the memory, row by row
//
//   came_i --> fifo, 128 words --> on-chip memory (0xC8000000, 256 KB)
//                                  any other address: the SDRAM, by its lower 26 bits
//
// A row is 160 words; rows are 1,024 bytes apart.  Whatever comes in, only 240 such rows are
// written, from the address that buffer_i has when the picture begins: begin_o is high in the clock
// before its first word is written, and buffer_i may change then.  Bits 31:28 and 1:0 of that
// address are ignored.
//
// During a row a word comes every 7.4 clocks.  The screen can keep the SDRAM busy for one of its
// rows, 322 clocks and some refreshes.  The FIFO's 128 words last for 947 clocks.

`default_nettype none

module video_writer (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        enable_i,       // 0: drop what comes, and what was to be written
    // Only a word's address in the memories is used.
    // verilator lint_off UNUSED
    input  wire [31:0] buffer_i,
    // verilator lint_on UNUSED

    input  wire        came_i,         // one word in each clock in which it is high
    input  wire [33:0] word_i,         // in the format of video_capture.v

    output wire        onchip_req_o,   // these two stay until taken
    input  wire        onchip_take_i,
    output wire        sdram_req_o,
    input  wire        sdram_take_i,
    output wire [23:0] index_o,        // of a word in either
    output wire [31:0] wdata_o,

    output wire        begin_o,        // a picture begins in the next clock
    output wire        awake_o
);
    `include "regmap.vh"

    localparam [7:0]  WORDS = 8'd160, LAST_ROW = 8'd239;
    localparam [25:0] PITCH = 26'd256;

    // ---- Words that wait --------------------------------------------------
    wire        none, taken, first, row;

    // It never is full, and nothing clears it.
    // verilator lint_off PINCONNECTEMPTY
    fifo #(.WIDTH(34)) words (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(1'b0), .push_i(came_i), .wdata_i(word_i),
        .pop_i(taken), .rdata_o({first, row, wdata_o}), .count_o(), .full_o(), .empty_o(none),
        .awake_o()
    );
    // verilator lint_on PINCONNECTEMPTY

    // ---- Where the next one goes ------------------------------------------
    reg         run_q;                 // a picture has begun
    reg         begun_q;               // begin_o was high for the word that waits
    reg  [25:0] row_q, next_q;         // addresses of this row, of its next word
    reg  [7:0]  x_q, y_q;              // words of it that are written; number of the row
    wire [25:0] address = first ? buffer_i[27:2] : row ? row_q + PITCH : next_q;
    wire        belongs  = enable_i && (first || (run_q && (row ? y_q != LAST_ROW : x_q != WORDS)));
    wire        onchip  = address[25:16] == ONCHIP_BASE[27:18];
    wire        go      = !none && !begin_o;

    assign begin_o      = !none && enable_i && first && !begun_q;
    assign onchip_req_o = go && belongs && onchip;
    assign sdram_req_o  = go && belongs && !onchip;
    assign index_o      = address[23:0];
    assign taken        = go && !(onchip_req_o && !onchip_take_i)
                          && !(sdram_req_o && !sdram_take_i);

    assign awake_o = came_i || !none || ((run_q || begun_q) && !enable_i);

    always @(posedge clk_i) begin
        if (taken && belongs) begin
            run_q  <= 1'b1;
            next_q <= address + 26'd1;
            x_q    <= first || row ? 8'd1 : x_q + 8'd1;
            if (first || row) begin
                row_q <= address;
                y_q   <= first ? 8'd0 : y_q + 8'd1;
            end
        end
        begun_q <= begin_o || (begun_q && !taken);
        if (!enable_i || rst_i) {run_q, begun_q} <= 2'b00;
    end
endmodule

`default_nettype wire
