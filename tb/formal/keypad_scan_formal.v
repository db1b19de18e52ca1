// keypad_scan_formal.v - one column low; no key moves before its debounce time, and then it does.
//
// By 3-step induction, with slots of three clocks.  Rows, debounce time and pauses are
// unconstrained.  The harness has a reference scan, in which it follows one key that the solver
// chooses.

`default_nettype none

module keypad_scan_formal (
    input wire       clk_i,
    input wire       rst_i,
    input wire       run_i,
    input wire [7:0] debounce_i,
    input wire [3:0] row_ni
);
    localparam [1:0] SLOT_LAST = 2'd2;

    wire [3:0]  col_low;
    wire [15:0] keys;
    wire        ghost;

    keypad_scan #(.SLOT_CYCLES(3)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .run_i(run_i), .debounce_i(debounce_i),
        .col_low_o(col_low), .row_ni(row_ni), .keys_o(keys), .ghost_o(ghost)
    );

    // ---- The reference: where the scan is, what it has read -----------------
    (* anyconst *) wire [1:0] row, col;      // the key that is followed
    wire [3:0]  key = {row, col};

    reg         live = 1'b0;
    reg  [3:0]  row1_q, row2_q;              // the rows as the synchroniser delivers them
    reg         runs_q;                      // a slot was under way in the last clock, or began
    reg  [1:0]  slot_q, col_q;               // clock of the slot, which begins with run_i
    reg  [15:0] now_q, scan_q;               // read in this scan; the whole scan before
    reg         whole_q;                     // a scan was completed by the last clock
    reg  [7:0]  same_q;                      // equal scans in a row, saturating
    reg         held_q;                      // the followed key in its last sample
    reg  [7:0]  run_q;                       // equal samples of it in a row, saturating
    reg         ran_q, was_q, corners, corners_q;
    reg  [7:0]  debounce_q;
    reg         whole_was_q;
    reg  [7:0]  same_was_q;
    wire        slot_end = runs_q && slot_q == SLOT_LAST;
    wire [15:0] now = {~row2_q, now_q[11:0]};
    integer     c;

    always @(posedge clk_i) begin
        live        <= 1'b1;
        ran_q       <= !rst_i;
        was_q       <= keys[key];
        debounce_q  <= debounce_i;
        whole_was_q <= whole_q && !rst_i;
        same_was_q  <= same_q;
        corners_q   <= corners;
        row1_q      <= row_ni;
        row2_q      <= row1_q;
        runs_q      <= run_i;
        slot_q      <= slot_end || !run_i ? 2'd0 : slot_q + 2'd1;
        whole_q     <= slot_end && col_q == 2'd3;
        if (slot_end) begin
            col_q <= col_q + 2'd1;
            for (c = 0; c < 4; c = c + 1) if (col_q == c) now_q[4 * c +: 4] <= ~row2_q;
            if (col_q == col) begin
                held_q <= !row2_q[row];
                if (held_q != !row2_q[row]) run_q <= 8'd1;
                else if (run_q != 8'hff) run_q <= run_q + 8'd1;
            end
            if (col_q == 2'd3) begin
                scan_q <= now;
                if (now != scan_q) same_q <= 8'd1;
                else if (same_q != 8'hff) same_q <= same_q + 8'd1;
            end
        end
        if (rst_i) begin
            {slot_q, col_q, same_q, run_q, scan_q} <= 0;
            {whole_q, held_q, runs_q} <= 0;
        end
    end
    always @(*) if (!live) assume (rst_i);

    // A ghost: two columns meet the same two rows.
    integer c1, c2, r1, r2;
    always @(*) begin
        corners = 1'b0;
        for (c1 = 0; c1 < 4; c1 = c1 + 1) for (c2 = 0; c2 < c1; c2 = c2 + 1)
            for (r1 = 0; r1 < 4; r1 = r1 + 1) for (r2 = 0; r2 < r1; r2 = r2 + 1)
                if (scan_q[4 * c1 + r1] && scan_q[4 * c1 + r2]
                    && scan_q[4 * c2 + r1] && scan_q[4 * c2 + r2]) corners = 1'b1;
    end

    // ---- What must hold -----------------------------------------------------
    wire decided = ran_q && whole_was_q && same_was_q >= debounce_q;

    always @(*) if (live) begin
        a_one_column_low: assert (col_low == 4'd1 << col_q && slot_q <= SLOT_LAST);
        if (ran_q) begin
            a_not_before_debounce:
                assert (keys[key] == was_q || (keys[key] == held_q && run_q >= debounce_q));
            a_reported: assert (!(decided && !corners_q) || keys[key] == held_q);
            a_ghost:    assert (!decided || ghost == corners_q);
            a_no_key_invented: assert (!(decided && corners_q) || keys[key] == was_q);
        end
    end

    // ---- Invariants -----------------------------------------------------------
    wire [1:0]  dut__slot__count_q, dut__col_q;
    wire [3:0]  dut__rows0_q, dut__rows1_q, dut__rows2_q, dut__row_n;
    wire [15:0] dut__last_q;
    wire [7:0]  dut__equal_q;
    wire        dut__scanned_q, dut__runs_q;
    reg  [1:0]  age_q = 2'd0;
    always @(posedge clk_i) if (age_q != 2'd3) age_q <= age_q + 2'd1;
    wire        sampled = col_q > col;       // the followed key has been read in this scan

    always @(*) if (live) begin
        i_place: assert (dut__runs_q == runs_q && dut__col_q == col_q);
        i_slot: assert (!runs_q || dut__slot__count_q == SLOT_LAST - slot_q);
        i_still: assert (runs_q || slot_q == 2'd0);
        if (age_q == 2'd3) i_row: assert (dut__row_n == row2_q);
        i_age:  assert (age_q >= 2'd1);
        i_whole: assert (dut__scanned_q == whole_q);
        i_scan: assert (dut__last_q == scan_q && dut__equal_q == same_q);
        i_now0: assert (col_q < 2'd1 || dut__rows0_q == now_q[3:0]);
        i_now1: assert (col_q < 2'd2 || dut__rows1_q == now_q[7:4]);
        i_now2: assert (col_q < 2'd3 || dut__rows2_q == now_q[11:8]);
        i_key:  assert (sampled ? held_q == now_q[{col, row}] : held_q == scan_q[{col, row}]);
        i_run:  assert (run_q >= (!sampled ? same_q : held_q != scan_q[{col, row}] ? 8'd1
                                  : same_q == 8'hff ? 8'hff : same_q + 8'd1));
    end
endmodule

`default_nettype wire
