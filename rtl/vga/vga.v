// vga.v - pixel DMA and VGA output: the front picture, each pixel 2 x 2, at 640 x 480
//
//   clock      0          1            2          3           4
//   h_o        n = 4k     4k + 1 ...
//              address -> memory ----> word_q --> rgb ------> pins show pixel n = 4k
//
// A word holds two pixels, so it serves four clocks; each row is fetched for two lines.  HS, VS and
// BLANK take the same four clocks.  A front address outside the two pictures shows black there.

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
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,

    output reg         fetch_o,         // to the picture store; data one clock later
    output reg  [16:0] index_o,
    input  wire [31:0] word_i,

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

    pixel_registers registers (
        .clk_i(clk_i), .rst_i(rst_i),
        .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .re_i(re_i), .resampler_re_i(resampler_re_i), .raddr_i(raddr_i), .rdata_o(rdata_o),
        .frame_end_i(h == 10'd0 && v == 10'd480), .front_o(front), .enable_o(enable)
    );

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

    // ---- Pins: a pixel of the picture is two clocks long -------------------
    reg  [8:0]  sync_q;     // HS, VS, shown of the last three clocks
    wire [15:0] pixel = h[1] ? word_q[15:0] : word_q[31:16];

    assign vga_clk_o   = ~clk_i;   // rises in the middle of a pixel
    assign vga_sync_no = 1'b0;     // no sync on green

    always @(posedge clk_i) begin
        {vga_hs_no, vga_vs_no, vga_blank_no} <= sync_q[8:6];
        if (h[0] || rst_i) begin
            vga_r_o <= sync_q[6] ? {pixel[15:11], pixel[15:13]} : 8'd0;
            vga_g_o <= sync_q[6] ? {pixel[10:5], pixel[10:9]} : 8'd0;
            vga_b_o <= sync_q[6] ? {pixel[4:0], pixel[4:2]} : 8'd0;
        end
        sync_q <= {sync_q[5:0], hs_n, vs_n, shown};
    end
endmodule

`default_nettype wire
