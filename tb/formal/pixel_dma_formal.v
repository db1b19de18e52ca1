// pixel_dma_formal.v - no pixel is late: a row is whole before it is on the screen.
//
// By 2-step induction.  The SDRAM takes a request in its eleventh clock at the latest, or in its
// seventh if the request came in the clock after the previous one was taken.  It answers four
// clocks later.  sdram_wait_formal.v and sdram_formal.v prove both.  The processor may read the
// on-chip memory in any clock that is free for it.  The picture begins anywhere.
//
// Each word of a memory holds its own address, which shows where it was read.

`default_nettype none

module pixel_dma_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [31:0] front_i,
    input wire        re_i,          // the processor's read of the on-chip memory
    input wire        sdram_take_i,
    input wire [31:0] other_i        // what it gives; on the SDRAM's data while no read waits
);
    localparam [3:0]  FIRST = 4'd11, NEXT = 4'd7;
    localparam [7:0]  WORDS = 8'd161;

    reg         live = 1'b0;
    reg  [9:0]  h_q, v_q;
    wire        line_end = h_q == 10'd799;
    wire [9:0]  v_next = v_q == 10'd524 ? 10'd0 : v_q + 10'd1;
    wire        onchip_re, req, we;
    wire [15:0] onchip_index;
    wire [23:0] sdram_index;
    wire [8:0]  windex;
    wire [31:0] wdata;
    reg  [31:0] onchip_q;
    reg  [3:0]  taken_q;             // of 1 to 4 clocks before, and their indices
    reg  [23:0] index1_q, index2_q, index3_q, index4_q;

    function [31:0] sdram_word;
        input [23:0] index;
        sdram_word = {8'hd1, index};
    endfunction
    function [31:0] onchip_word;
        input [15:0] index;
        onchip_word = {16'hc410, index};
    endfunction

    pixel_dma dut (
        .clk_i(clk_i), .rst_i(rst_i), .odd_i(h_q[0]), .line_end_i(line_end), .v_next_i(v_next),
        .front_i(front_i),
        .onchip_re_o(onchip_re), .onchip_read_i(re_i && !onchip_re),
        .onchip_index_o(onchip_index), .onchip_word_i(onchip_q),
        .sdram_req_o(req), .sdram_index_o(sdram_index), .sdram_take_i(sdram_take_i),
        .sdram_valid_i(taken_q[3]), .sdram_word_i(taken_q[3] ? sdram_word(index4_q) : other_i),
        .we_o(we), .windex_o(windex), .wdata_o(wdata), .awake_o()
    );

    always @(posedge clk_i) begin
        if (onchip_re) onchip_q <= onchip_word(onchip_index);
        else if (re_i) onchip_q <= other_i;
        taken_q  <= rst_i ? 4'd0 : {taken_q[2:0], sdram_take_i};
        index1_q <= sdram_index;
        index2_q <= index1_q;
        index3_q <= index2_q;
        index4_q <= index3_q;
    end

    // ---- The beam, and which row is due before the next pair of lines ----
    wire        first    = v_q >= 10'd523;
    wire        fetching = first || v_q < 10'd478;
    wire        second   = v_q[0] != first;               // of the two lines
    wire [10:0] clocks   = (second ? 11'd800 : 11'd0) + h_q;   // since they began
    wire [7:0]  row      = first ? 8'd0 : v_q[8:1] + 8'd1;
    wire        begins   = line_end && (v_next == 10'd523 || (v_next < 10'd478 && !v_next[0]));
    wire [7:0]  row_next = v_next == 10'd523 ? 8'd0 : v_next[8:1] + 8'd1;

    reg  [25:0] front_q, base_q;      // words: where the picture begins, and the row
    reg         req_q, next_q;
    reg  [7:0]  count_q;              // words of the row that have been written
    reg  [3:0]  wait_q;               // clocks since the request
    reg  [23:0] sdram_index_q;

    function [25:0] begin_of;
        input [7:0] row;
        input [25:0] front;
        begin_of = front + {10'd0, row, 8'd0};
    endfunction
    wire [25:0] front = v_next == 10'd523 ? front_i[27:2] : front_q;

    always @(posedge clk_i) begin
        live <= 1'b1;
        h_q  <= line_end ? 10'd0 : h_q + 10'd1;
        if (line_end) v_q <= v_next;
        if (we) count_q <= count_q + 8'd1;
        if (begins) begin
            front_q <= front;
            base_q  <= begin_of(row_next, front);
            count_q <= 8'd0;
        end
        wait_q        <= req && !sdram_take_i ? wait_q + 4'd1 : 4'd0;
        next_q        <= req && (sdram_take_i || next_q) && !rst_i;
        req_q         <= req && !sdram_take_i && !rst_i;
        sdram_index_q <= sdram_index;
        if (rst_i) begin
            h_q    <= 10'd0;
            v_q    <= 10'd480;
            wait_q <= 4'd0;
        end
    end
    always @(*) begin
        if (!live) assume (rst_i);
        assume (!sdram_take_i || req);
        assume (!req || sdram_take_i || wait_q != (next_q ? NEXT : FIRST) - 4'd1);
    end

    // ---- What must hold ----
    function in_onchip;
        input [25:0] address;
        in_onchip = {address, 2'd0} >= 28'h800_0000 && {address, 2'd0} < 28'h804_0000;
    endfunction
    function in_sdram;                // all else
        input [25:0] address;
        in_sdram = !in_onchip(address);
    endfunction
    function [31:0] word_of;          // a row of the on-chip memory is black after its end
        input [25:0] base;
        input [7:0]  n;
        reg [25:0] address;
        begin
            address = base + {18'd0, n};
            word_of = in_sdram(base) && in_sdram(address) ? sdram_word(address[23:0])
                      : in_onchip(address) ? onchip_word(address[15:0]) : 32'd0;
        end
    endfunction

    // Words asked for and on their way, and the most clocks that they can have taken.
    wire        dut__busy_q, dut__parity_q, dut__waiting_q, dut__onchip_q, dut__sdram_q;
    wire [7:0]  dut__asked_q, dut__got_q;
    wire [25:0] dut__address_q, dut__row_q;
    wire [2:0]  coming = {2'd0, taken_q[0]} + {2'd0, taken_q[1]} + {2'd0, taken_q[2]}
                         + {2'd0, taken_q[3]};
    wire [25:0] last   = base_q + {18'd0, dut__asked_q} - 26'd1;
    wire [25:0] oldest = base_q + {18'd0, dut__got_q};
    wire [1:0]  age    = taken_q[0] ? 2'd0 : taken_q[1] ? 2'd1 : taken_q[2] ? 2'd2 : 2'd3;
    wire [10:0] words_took = (dut__asked_q == 8'd0 ? 11'd0
                              : {dut__asked_q, 3'd0} + 11'd3)   // 8 each; the first may be late
                             + {7'd0, req ? wait_q : taken_q != 4'd0 ? {2'd0, age}
                                      : h_q[0] ? 4'd6 : 4'd5};

    always @(*) if (live) begin
        a_in_time:      assert (!fetching || count_q == WORDS
                                || (clocks < 11'd1599 && clocks <= words_took));
        a_place:        assert (!we || (fetching && windex == {row[0], count_q}
                                        && count_q < WORDS));
        a_word:         assert (!we || wdata == word_of(base_q, count_q));
        a_not_on_screen: assert (!we || v_q >= 10'd480 || windex[8] != v_q[1]);
        a_request_stays: assert (!req_q || (req && sdram_index == sdram_index_q));
    end

    // ---- Invariants: words asked for, on their way and written ----
    always @(*) if (live) begin
        i_beam:   assert (h_q < 10'd800 && v_q < 10'd525);
        i_idle:   assert (fetching || (!dut__busy_q && taken_q == 4'd0));
        i_waits:  assert (wait_q < (next_q ? NEXT : FIRST) && (req || wait_q == 4'd0));
        i_coming: assert (!dut__waiting_q || (dut__busy_q && taken_q == 4'd0));
        if (fetching) begin
            i_row:   assert (base_q == begin_of(row, front_q)
                             && dut__row_q == base_q + 26'd256
                             && dut__parity_q == row[0]);
            i_busy:  assert (dut__busy_q == (dut__got_q != WORDS));
            i_count: assert (dut__got_q == count_q && count_q <= dut__asked_q
                             && dut__asked_q <= WORDS && dut__asked_q
                             == dut__got_q + {5'd0, dut__waiting_q ? 3'd1 : coming});
            i_sdram: assert (dut__sdram_q == in_sdram(base_q)
                             && (taken_q == 4'd0 || (dut__sdram_q && in_sdram(last))));
            i_next:  assert (!req || next_q == (dut__asked_q != 8'd0));
            i_address: assert (dut__address_q == base_q + {18'd0, dut__asked_q});
            i_index1: assert (!taken_q[0] || index1_q == last[23:0]);
            i_index2: assert (!taken_q[1] || index2_q == last[23:0] - {23'd0, taken_q[0]});
            i_index3: assert (!taken_q[2] || index3_q == last[23:0] - {23'd0, taken_q[0]}
                                                         - {23'd0, taken_q[1]});
            i_index4: assert (!taken_q[3] || index4_q == oldest[23:0]);
            i_onchip: assert (!dut__waiting_q || (dut__onchip_q == in_onchip(oldest)
                              && !(dut__sdram_q && in_sdram(oldest))
                              && (!dut__onchip_q || onchip_q == onchip_word(oldest[15:0]))));
        end
    end
endmodule

`default_nettype wire
