// vga.v - pixel DMA and VGA output: the front picture, each pixel 2 x 2, under 80 x 60 characters
//
//   clock      0          1            2          3           4
//   h_o        n = 4k     4k + 1 ...
//              address -> memory ----> word_q --> rgb ------> pins show pixel n = 4k
//
// A word holds two pixels, so it serves four clocks; each row is fetched for two lines.  HS, VS and
// BLANK take the same four clocks.  A front address outside the two pictures shows black there.
//
// Every eighth clock a character is fetched beside the pixels; its strokes are white, the rest of
// its 8 x 8 pixels is transparent.  Codes are ASCII, bit 7 is not looked at.  Whether there are any
// characters to show is looked at between lines.

`default_nettype none

module vga (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,            // register bus, PIXEL
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        resampler_re_i,  // RESAMPLER
    input  wire        text_we_i,       // TEXT
    input  wire        text_re_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,

    output reg         fetch_o,         // to the picture store; data one clock later
    output reg  [16:0] index_o,
    input  wire [31:0] word_i,

    output reg         cell_o,          // to the character store, only beside fetch_o; the same
    output reg  [10:0] cell_index_o,
    input  wire [31:0] cells_i,
    input  wire        cells_any_i,     // some character is not a blank
    output reg         clear_o,
    input  wire        clearing_i,

    output wire        vga_clk_o,       // ADV7123
    output reg         vga_hs_no,
    output reg         vga_vs_no,
    output reg         vga_blank_no,
    output wire        vga_sync_no,
    output reg  [7:0]  vga_r_o,
    output reg  [7:0]  vga_g_o,
    output reg  [7:0]  vga_b_o
);
    `include "regmap.vh"
    `include "picture_index.vh"
    `include "character_font.vh"

    wire [9:0]  h, v;
    wire [8:0]  row_next;
    wire        line_end, hs_n, vs_n, shown;
    // The two lowest bits would split a word.
    // verilator lint_off UNUSED
    wire [31:0] front;
    // verilator lint_on UNUSED
    wire        enable;

    vga_timing timing (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(h), .v_o(v), .line_end_o(line_end),
        .row_next_o(row_next), .hs_no(hs_n), .vs_no(vs_n), .shown_o(shown)
    );

    wire        frame_end = h == 10'd0 && v == 10'd480;
    wire        text_enable;
    wire [31:0] pixel_rdata, text_rdata;
    reg         clearing_rdata_q;

    pixel_registers #(
        .BUFFER(PIXEL_BUFFER_RESET), .RESOLUTION(PIXEL_RESOLUTION_RESET),
        .STATUS(PIXEL_STATUS_RESET)
    ) registers (
        .clk_i(clk_i), .rst_i(rst_i),
        .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .re_i(re_i), .resampler_re_i(resampler_re_i), .raddr_i(raddr_i), .rdata_o(pixel_rdata),
        .frame_end_i(frame_end), .front_o(front), .enable_o(enable)
    );
    // The characters are where they are.
    // verilator lint_off PINCONNECTEMPTY
    pixel_registers #(
        .BUFFER(TEXT_BUFFER_RESET), .RESOLUTION(TEXT_RESOLUTION_RESET), .STATUS(TEXT_STATUS_RESET)
    ) text_registers (
        .clk_i(clk_i), .rst_i(rst_i),
        .we_i(text_we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .re_i(text_re_i), .resampler_re_i(1'b0), .raddr_i(raddr_i), .rdata_o(text_rdata),
        .frame_end_i(frame_end), .front_o(), .enable_o(text_enable)
    );
    // verilator lint_on PINCONNECTEMPTY

    assign rdata_o = pixel_rdata | text_rdata
                     | {31'd0, clearing_rdata_q} << TEXT_BUFFER_CLEAR_LSB;

    always @(posedge clk_i)
        if (text_we_i || text_re_i || clear_o || clearing_rdata_q || rst_i) begin
            clearing_rdata_q <= text_re_i && raddr_i[3:0] == TEXT_BUFFER[3:0]
                                && (clear_o || clearing_i);
            clear_o <= text_we_i && waddr_i[3:0] == TEXT_BUFFER[3:0] && wstrb_i[2]
                       && wdata_i[TEXT_BUFFER_CLEAR_LSB] && !rst_i;
        end

    // ---- Fetch: of each four clocks, one to ask, one in the store, one to take ----
    reg  [19:0] offset_q;   // in the picture's window, of the word to fetch; bit 19: past its end
    reg         stored_q;
    reg  [31:0] word_q;
    wire        in0 = front[31:19] == PICTURE0_BASE[31:19];
    wire        in1 = front[31:19] == PICTURE1_BASE[31:19];

    always @(posedge clk_i) begin
        fetch_o <= 1'b0;
        if (h[1:0] == 2'd2) word_q <= stored_q ? word_i : 32'd0;
        if (shown && h[1:0] == 2'd0) begin
            fetch_o  <= 1'b1;
            stored_q <= stored(offset_q[18:0]) && !offset_q[19] && (in0 || in1) && enable;
            index_o  <= picture_index(in1, offset_q[18:0]);
            offset_q <= offset_q + 20'd4;
        end
        if (line_end) offset_q <= {1'b0, front[18:2], 2'b00} + {1'b0, row_next, 10'd0};
    end

    // ---- Characters: asked for beside every other word, taken when it is ----
    reg         text_q;     // there are some, in this line
    reg  [1:0]  lane_q;     // of the character in its word
    reg  [2:0]  line_q;     // of the character's eight
    reg  [7:0]  strokes_q;  // bit 0 now, bit 1 in the next clock; 0 without text_q
    wire [6:0]  code = cells_i[{lane_q, 3'd0} +: 7];

    function [7:0] line_of;
        input [63:0] pixels;
        input [2:0]  line;
        line_of = pixels[{line, 3'd0} +: 8];
    endfunction

    always @(posedge clk_i) begin
        if (text_q) begin
            strokes_q <= shown && h[2:0] == 3'd2 ? line_of(letter(code), line_q)
                         : {1'b0, strokes_q[7:1]};
            cell_o    <= 1'b0;
            if (shown && h[2:0] == 3'd0) begin
                cell_o       <= 1'b1;
                cell_index_o <= {v[8:3], h[9:5]};
                lane_q       <= h[4:3];
                line_q       <= v[2:0];
            end
        end
        if (line_end) text_q <= cells_any_i && text_enable;
        if (rst_i) begin
            text_q    <= 1'b0;
            cell_o    <= 1'b0;
            strokes_q <= 8'd0;
        end
    end

    // ---- Pins: a pixel of the picture is two clocks long -------------------
    reg  [8:0]  sync_q;     // HS, VS, shown of the last three clocks
    wire [15:0] pixel = h[1] ^ h[0] ? word_q[31:16] : word_q[15:0];
    wire [7:0]  white = {8{strokes_q[0]}};

    assign vga_clk_o   = ~clk_i;   // rises in the middle of a pixel
    assign vga_sync_no = 1'b0;     // no sync on green

    always @(posedge clk_i) begin
        {vga_hs_no, vga_vs_no, vga_blank_no} <= sync_q[8:6];
        if (h[0] || text_q || rst_i) begin
            vga_r_o <= sync_q[6] ? {pixel[15:11], pixel[15:13]} | white : 8'd0;
            vga_g_o <= sync_q[6] ? {pixel[10:5], pixel[10:9]} | white : 8'd0;
            vga_b_o <= sync_q[6] ? {pixel[4:0], pixel[4:2]} | white : 8'd0;
        end
        sync_q <= {sync_q[5:0], hs_n, vs_n, shown};
    end
endmodule

`default_nettype wire
