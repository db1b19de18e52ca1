// pixel_dma.v - fetches the rows of the front picture into the line buffer, one ahead of the beam
//
//   on-chip memory (0xC8000000, 256 KB)  --+
//   any other address: the SDRAM         --+--> line_buffer
//
// Each row is on the screen for two lines; while it is, the next one is fetched.  The first row is
// fetched in the last two lines of the blanking, so a change of the front address at the end of a
// frame is in time.  As in the DE1-SoC Computer the controller reaches two memories and sees bits
// 27:0 of an address: an address in the DDR3 shows the SDRAM, of which it has the lower 26 bits.
// A row that begins in the on-chip memory is black from that memory's end on.
//
// The on-chip memory is read in every odd clock of the line.  Its word is taken in the next odd
// clock, or already in the even clock between if the processor reads the memory in that one.  The
// SDRAM gives a word every two clocks.  A row has 1,600 clocks for its 161 words, which is enough
// from either memory (tb/formal/pixel_dma_formal.v).

`default_nettype none

module pixel_dma (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        odd_i,           // an odd clock of the beam's line
    input  wire        line_end_i,
    input  wire [9:0]  v_next_i,        // the line that begins after line_end_i
    // Bits 1:0: vga.v handles a picture that begins in the middle of a word.  Bits 31:28: above.
    // verilator lint_off UNUSED
    input  wire [31:0] front_i,         // address of the picture
    // verilator lint_on UNUSED

    output wire        onchip_re_o,     // data one clock later
    input  wire        onchip_read_i,   // the processor reads it now
    output wire [15:0] onchip_index_o,
    input  wire [31:0] onchip_word_i,

    output wire        sdram_req_o,     // stays until sdram_take_i
    output wire [23:0] sdram_index_o,
    input  wire        sdram_take_i,
    input  wire        sdram_valid_i,
    input  wire [31:0] sdram_word_i,

    output wire        we_o,            // line buffer
    output wire [8:0]  windex_o,
    output wire [31:0] wdata_o,

    output wire        awake_o
);
    `include "regmap.vh"

    localparam [7:0]  WORDS     = 8'd161;
    localparam [9:0]  FIRST_ROW = 10'd523, LAST_PAIR = 10'd476;
    localparam [25:0] PITCH = 26'd256;   // words

    reg         busy_q, parity_q;        // parity_q: of the row
    reg  [7:0]  asked_q, got_q;          // words
    reg         waiting_q;               // for a word that is not the SDRAM's
    reg         onchip_q;                // ... but that memory's
    reg         sdram_q;                 // the row begins in the SDRAM
    reg  [25:0] address_q, row_q;        // of the next word, of the next row
    wire        first = v_next_i == FIRST_ROW;

    // ---- Ask --------------------------------------------------------------
    wire more      = busy_q && asked_q != WORDS;
    wire in_onchip = address_q[25:16] == ONCHIP_BASE[27:18];
    wire in_sdram  = sdram_q && !in_onchip;
    wire ask       = odd_i && more && !in_sdram && (waiting_q || asked_q == got_q);

    assign sdram_req_o    = more && in_sdram;
    assign sdram_index_o  = address_q[23:0];
    assign onchip_re_o    = ask && in_onchip;
    assign onchip_index_o = address_q[15:0];

    // ---- Take -------------------------------------------------------------
    wire take = busy_q && waiting_q && (odd_i || onchip_read_i);

    assign we_o     = take || sdram_valid_i;
    assign windex_o = {parity_q, got_q};
    assign wdata_o  = !take ? sdram_word_i : onchip_q ? onchip_word_i : 32'd0;

    wire [25:0] begins = first ? front_i[27:2] : row_q;

    always @(posedge clk_i) begin
        if (ask || sdram_take_i) begin
            asked_q   <= asked_q + 8'd1;
            address_q <= address_q + 26'd1;
        end
        if (ask || take) waiting_q <= ask;
        if (ask) onchip_q <= in_onchip;
        if (we_o) begin
            got_q  <= got_q + 8'd1;
            busy_q <= got_q != WORDS - 8'd1;
        end
        if (line_end_i && (first || (v_next_i <= LAST_PAIR && !v_next_i[0]))) begin
            busy_q    <= 1'b1;
            parity_q  <= !first && !v_next_i[1];
            asked_q   <= 8'd0;
            got_q     <= 8'd0;
            sdram_q   <= begins[25:16] != ONCHIP_BASE[27:18];
            address_q <= begins;
            row_q     <= begins + PITCH;
        end
        if (rst_i) begin
            busy_q    <= 1'b0;
            waiting_q <= 1'b0;
        end
    end

    assign awake_o = busy_q || line_end_i;
endmodule

`default_nettype wire
