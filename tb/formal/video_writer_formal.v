// video_writer_formal.v - video-in writes into its buffer alone, and every word that belongs there.
//
// By 2-step induction; words may come at any time, and memories take them at any time.  The
// buffer's address changes only in the clock after begin_o, as pixel_registers.v guarantees.

`default_nettype none

module video_writer_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        enable_i,
    input wire [31:0] buffer_i,
    input wire        came_i,
    input wire [33:0] word_i,
    input wire        onchip_take_i,
    input wire        sdram_take_i
);
    wire        onchip_req, sdram_req, begins;
    wire [23:0] index;
    wire [31:0] wdata;

    video_writer dut (
        .clk_i(clk_i), .rst_i(rst_i), .enable_i(enable_i), .buffer_i(buffer_i), .came_i(came_i),
        .word_i(word_i), .onchip_req_o(onchip_req), .onchip_take_i(onchip_take_i),
        .sdram_req_o(sdram_req), .sdram_take_i(sdram_take_i), .index_o(index), .wdata_o(wdata),
        .begin_o(begins)
    );

    wire        dut__taken, dut__first, dut__row, dut__none, dut__run_q;
    wire [25:0] dut__row_q, dut__next_q, dut__address;
    wire        dut__begun_q;
    wire [7:0]  dut__x_q, dut__y_q;

    // ---- What happened, in other words ----
    reg         live = 1'b0;
    reg         open_q;              // a picture has begun and goes on
    reg  [25:0] base_q;              // where it lies
    reg  [7:0]  rows_q, words_q;     // rows that have begun, words of the last one
    reg         held_q;              // a request was not taken
    reg  [57:0] request_q;
    reg  [31:0] buffer_q;
    reg         began_q;             // begin_o was high a clock ago
    reg         told_q;              // and was, since the word that waits came up
    wire        goes = dut__taken && !dut__none;
    wire        fits = dut__first || (open_q && (dut__row ? rows_q < 8'd240 : words_q < 8'd160));
    // Where such a word belongs.
    wire [7:0]  y = dut__first ? 8'd0 : dut__row ? rows_q : rows_q - 8'd1;
    wire [7:0]  x = dut__first || dut__row ? 8'd0 : words_q;
    wire [25:0] place = (dut__first ? buffer_i[27:2] : base_q) + {10'd0, y, 8'd0} + {18'd0, x};
    wire        chip = place[25:16] == 10'h200;

    always @(posedge clk_i) begin
        live      <= 1'b1;
        buffer_q  <= buffer_i;
        began_q   <= begins || rst_i;
        told_q    <= enable_i && !rst_i && (begins || (told_q && !goes));
        held_q    <= enable_i && !rst_i && ((onchip_req && !onchip_take_i)
                                            || (sdram_req && !sdram_take_i));
        request_q <= {onchip_req, sdram_req, index, wdata};
        if (goes && enable_i && fits) begin
            open_q  <= 1'b1;
            if (dut__first) base_q <= buffer_i[27:2];
            rows_q  <= y + 8'd1;
            words_q <= x + 8'd1;
        end
        if (!enable_i || rst_i) open_q <= 1'b0;
    end
    always @(*) begin
        if (!live) assume (rst_i);
        if (live && !began_q) assume (buffer_i == buffer_q);
    end

    // ---- What must hold ----
    always @(*) if (live) begin
        i_open: assert (dut__run_q == open_q && dut__begun_q == told_q);
        i_told: assert (!told_q || (!dut__none && dut__first));
        if (open_q) begin
            i_places: assert (dut__row_q == base_q + {10'd0, dut__y_q, 8'd0}
                              && dut__next_q == dut__row_q + {18'd0, dut__x_q});
            i_counts: assert (rows_q == dut__y_q + 8'd1 && words_q == dut__x_q
                              && dut__y_q < 8'd240 && dut__x_q <= 8'd160 && dut__x_q != 8'd0);
        end
        a_belongs: assert (!(onchip_req || sdram_req) || (enable_i && fits));
        a_place:   assert (!(onchip_req || sdram_req)
                           || index[15:0] == place[15:0]);
        a_bank:    assert (!sdram_req || index == place[23:0]);
        a_memory:  assert (!(onchip_req && !chip) && !(sdram_req && chip));
        a_lost:    assert (!(goes && enable_i && fits)
                           || (chip ? onchip_req && onchip_take_i : sdram_req && sdram_take_i));
        a_stands:  assert (!held_q || !enable_i
                           || request_q == {onchip_req, sdram_req, index, wdata});
        a_begin:   assert (begins == (!dut__none && enable_i && dut__first && !told_q)
                           && !(goes && enable_i && dut__first && !told_q));
    end
endmodule

`default_nettype wire
