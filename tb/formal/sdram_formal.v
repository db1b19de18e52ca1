// sdram_formal.v - legal commands, refreshes in time, no word lost or out of order.
//
// By 8-step induction, against the datasheet of the IS42S16320D-7, for a bank that the solver
// chooses.  The chip stores one word of that bank; reads of other words give any value.  The
// requests are unconstrained, but stable until they are taken.
//
// The chip samples the pins in the middle of a clock.  The data of a read is on DQ in the middle of
// the next clock, so at the end of that clock.

`default_nettype none

module sdram_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        screen_req_i,
    input wire [23:0] screen_index_i,
    input wire        req_i,
    input wire        we_i,
    input wire [23:0] index_i,
    input wire [31:0] wdata_i,
    input wire [3:0]  wstrb_i,
    input wire [15:0] other_i,           // on DQ, where the chip does not give the chosen word
    input wire [15:0] another_i          // any other word
);
    localparam [12:0] POWER_UP = 13'd5000, INTERVAL = 13'd192;
    // 8,192 refreshes come within 8,192 intervals and this, in clocks: 64 ms are 1,600,000.
    localparam [7:0]  LATE = 8'd5;

    (* anyconst *) reg [23:0] place;
    wire [12:0] row    = place[23:11];
    wire [1:0]  bank   = place[10:9];

    reg         live = 1'b0;
    wire        screen_take, screen_valid, take, valid, cs_n, ras_n, cas_n, we_n, oe;
    wire [31:0] rdata;
    wire [1:0]  ba, dqm;
    wire [12:0] addr;
    wire [15:0] dq, dq_read;

    sdram dut (
        .clk_i(clk_i), .rst_i(rst_i),
        .screen_req_i(screen_req_i), .screen_index_i(screen_index_i), .screen_take_o(screen_take),
        .screen_valid_o(screen_valid), .req_i(req_i), .we_i(we_i), .index_i(index_i),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .take_o(take), .valid_o(valid), .rdata_o(rdata),
        .dram_cs_no(cs_n), .dram_ras_no(ras_n), .dram_cas_no(cas_n), .dram_we_no(we_n),
        .dram_ba_o(ba), .dram_addr_o(addr), .dram_dqm_o(dqm), .dram_dq_o(dq), .dram_dq_oe_o(oe),
        .dram_dq_i(dq_read), .awake_o()
    );

    // ---- Requests ----
    reg         screen_held_q, held_q, held_we_q;
    reg  [23:0] screen_held_index_q, held_index_q;

    always @(posedge clk_i) begin
        live    <= 1'b1;
        screen_held_q       <= screen_req_i && !screen_take && !rst_i;
        screen_held_index_q <= screen_index_i;
        held_q       <= req_i && !take && !rst_i;
        held_we_q    <= we_i;
        held_index_q <= index_i;
    end
    always @(*) begin
        if (!live) assume (rst_i);
        assume (!screen_held_q || (screen_req_i && screen_index_i == screen_held_index_q));
        assume (!held_q || (req_i && we_i == held_we_q && index_i == held_index_q));
    end

    // ---- The chip: the chosen bank, and times in clocks of 40 ns ----
    function [1:0] clocks;
        input [7:0] ns;
        clocks = (ns + 8'd39) / 8'd40;
    endfunction
    function [1:0] older;
        input [1:0] age;
        older = age == 2'd3 ? age : age + 2'd1;
    endfunction

    wire [2:0]  command = {ras_n, cas_n, we_n};
    wire        mode      = !cs_n && command == 3'd0;
    wire        refresh   = !cs_n && command == 3'd1;
    wire        precharge = !cs_n && command == 3'd2;
    wire        active    = !cs_n && command == 3'd3;
    wire        write     = !cs_n && command == 3'd4;
    wire        read      = !cs_n && command == 3'd5;
    wire        mine      = ba == bank;
    wire        opens     = active && mine;
    wire        closes    = precharge && (addr[10] || mine);

    reg         open_q, closed_once_q, mode_q;
    reg  [12:0] row_q;
    reg  [1:0]  refreshes_q;             // up to 3
    reg  [11:0] power_q;                 // clocks since power-up, up to 100 us
    reg  [1:0]  opened_q, any_opened_q, closed_q, written_q, refreshed_q, moded_q;  // ages, up to 3
    wire        open      = opens || (open_q && !closes);
    wire [12:0] open_row  = opens ? addr : row_q;
    wire        closed_once = closed_once_q || (precharge && addr[10]);
    wire [1:0]  refreshes = refresh && refreshes_q != 2'd3 ? refreshes_q + 2'd1 : refreshes_q;

    always @(posedge clk_i) begin
        open_q        <= open && !rst_i;
        row_q         <= open_row;
        closed_once_q <= closed_once && !rst_i;
        refreshes_q   <= rst_i ? 2'd0 : refreshes;
        mode_q        <= (mode_q || mode) && !rst_i;
        power_q       <= rst_i ? 12'd0 : power_q == 12'd2500 ? power_q : power_q + 12'd1;
        opened_q      <= rst_i ? 2'd3 : opens ? 2'd1 : older(opened_q);
        any_opened_q  <= rst_i ? 2'd3 : active ? 2'd1 : older(any_opened_q);
        closed_q      <= rst_i ? 2'd3 : closes ? 2'd1 : older(closed_q);
        written_q     <= rst_i ? 2'd3 : writes && burst_mine ? 2'd1 : older(written_q);
        refreshed_q   <= rst_i ? 2'd3 : refresh ? 2'd1 : older(refreshed_q);
        moded_q       <= rst_i ? 2'd3 : mode ? 2'd1 : older(moded_q);
    end

    // ---- The chip: bursts of two, and the word at the chosen place ----
    reg         second_q, second_write_q, second_mine_q, second_hit_q;
    reg  [9:0]  second_column_q;
    wire        access     = read || write;
    wire        burst      = access || second_q;
    wire        writes     = access ? write : second_q && second_write_q;
    wire        burst_mine = access ? mine : second_mine_q;
    wire        row_hit    = access ? mine && open_q && row_q == row : second_hit_q;
    wire [9:0]  column     = access ? addr[9:0] : second_column_q;
    wire        hit        = burst && row_hit && column[9:1] == place[8:0];
    reg  [15:0] low_q, high_q, read_q;
    reg         drives_q, drove_q;
    reg  [1:0]  dqm_q;

    assign dq_read = {drives_q && !dqm_q[1] ? read_q[15:8] : other_i[15:8],
                      drives_q && !dqm_q[0] ? read_q[7:0] : other_i[7:0]};

    always @(posedge clk_i) begin
        second_q        <= access && !rst_i;
        second_write_q  <= write;
        second_mine_q   <= mine;
        second_hit_q    <= row_hit;
        second_column_q <= {addr[9:1], !addr[0]};
        if (hit && writes && !column[0]) low_q  <= {dqm[1] ? low_q[15:8] : dq[15:8],
                                                    dqm[0] ? low_q[7:0] : dq[7:0]};
        if (hit && writes && column[0])  high_q <= {dqm[1] ? high_q[15:8] : dq[15:8],
                                                    dqm[0] ? high_q[7:0] : dq[7:0]};
        drives_q <= burst && !writes && !rst_i;
        drove_q  <= drives_q && !rst_i;
        read_q   <= !hit ? another_i : column[0] ? high_q : low_q;
        dqm_q    <= dqm;
    end

    // ---- The reference: what was written last, what was asked, when to refresh ----
    reg  [31:0] word_q, word1_q, word2_q;            // now, 1 and 2 clocks ago
    reg  [31:0] known_q, known1_q, known2_q;         // the bits that were written
    reg  [31:0] asked1_q, asked2_q, asked3_q, asked4_q;    // what reads of the place should give,
    reg  [31:0] asks1_q, asks2_q, asks3_q, asks4_q;        // in these bits
    reg  [3:0]  screen_taken_q, taken_q;             // reads of 1 to 4 clocks before
    wire        at_place = (screen_take ? screen_index_i : index_i) == place;
    wire [31:0] lanes = {{8{wstrb_i[3]}}, {8{wstrb_i[2]}}, {8{wstrb_i[1]}}, {8{wstrb_i[0]}}};
    wire [31:0] stored = take && we_i && at_place ? lanes : 32'd0;

    reg  [12:0] phase_q;                             // clocks to the next refresh
    reg         begun_q, owed_q;                     // one has been due; one is
    reg  [7:0]  late_q;                              // for so many clocks
    wire        owed = owed_q && !mode && !(refresh && mode_q);

    always @(posedge clk_i) begin
        word_q  <= (word_q & ~stored) | (wdata_i & stored);
        word1_q <= word_q;
        word2_q <= word1_q;
        {known_q, known1_q, known2_q} <= rst_i ? 96'd0 : {known_q | stored, known_q, known1_q};
        {asked1_q, asked2_q, asked3_q, asked4_q} <= {word_q, asked1_q, asked2_q, asked3_q};
        {asks1_q, asks2_q, asks3_q, asks4_q} <=
            rst_i ? 128'd0 : {at_place && (screen_take || (take && !we_i)) ? known_q : 32'd0,
                              asks1_q, asks2_q, asks3_q};
        screen_taken_q <= rst_i ? 4'd0 : {screen_taken_q[2:0], screen_take};
        taken_q        <= rst_i ? 4'd0 : {taken_q[2:0], take && !we_i};

        phase_q <= phase_q == 13'd0 ? INTERVAL - 13'd1 : phase_q - 13'd1;
        owed_q  <= owed || phase_q == 13'd0;
        late_q  <= owed ? late_q + 8'd1 : 8'd0;
        if (phase_q == 13'd0) begun_q <= 1'b1;
        if (rst_i) begin
            phase_q <= POWER_UP;
            owed_q  <= 1'b0;
            begun_q <= 1'b0;
            late_q  <= 8'd0;
        end
    end

    // ---- What must hold ----
    always @(*) if (live) begin
        a_active:    assert (!opens || (!open_q && mode_q && closed_q >= clocks(15)
                             && opened_q >= clocks(60) && refreshed_q >= clocks(60)
                             && any_opened_q >= clocks(14) && moded_q >= clocks(14)));
        a_access:    assert (!(access && mine) || (open_q && !addr[10]
                             && opened_q >= clocks(15)));
        a_precharge: assert (!precharge || power_q == 12'd2500);
        a_close:     assert (!(closes && open_q) || (opened_q >= clocks(37)
                             && written_q >= clocks(14) && !(second_q && second_mine_q)));
        a_refresh:   assert (!refresh || (closed_once_q && !open_q && closed_q >= clocks(15)
                             && refreshed_q >= clocks(60) && moded_q >= clocks(14)));
        a_mode:      assert (!mode || (closed_once_q && !open_q && refreshes_q >= 2'd2
                             && refreshed_q >= clocks(60) && ba == 2'd0 && addr == 13'h021));
        a_no_other_command: assert (cs_n || command < 3'd6);
        a_refresh_in_time:  assert (!(owed_q && mode_q) || late_q < LATE);
        a_refresh_once:     assert (!(refresh && mode_q) || owed_q);
        a_dq_one_side: assert (!(oe && (drives_q || drove_q)));
        a_dq_driven:   assert (!writes || oe);
        a_one_taken:   assert (!(screen_take && take) && (!screen_take || screen_req_i)
                               && (!take || req_i));
        a_answered:    assert (screen_valid == screen_taken_q[3] && valid == taken_q[3]);
        a_stored:      assert (((low_q ^ word1_q[15:0]) & known1_q[15:0]) == 16'd0
                               && ((high_q ^ word2_q[31:16]) & known2_q[31:16]) == 16'd0);
        a_data:        assert (((rdata ^ asked4_q) & asks4_q) == 32'd0);
    end

    // ---- Invariants ----
    wire [12:0] dut__controller__interval__count_q;
    wire [51:0] dut__controller__rows_q;
    wire [3:0]  dut__controller__open_q, dut__controller__step_q;
    wire        dut__controller__refresh_q;
    wire        set_up = dut__controller__step_q == 4'd10;
    wire        closed_first = dut__controller__step_q != 4'd0;

    always @(*) if (live) begin
        i_open:  assert (open == dut__controller__open_q[bank]);
        i_row:   assert (!open || open_row == dut__controller__rows_q[13 * bank +: 13]);
        i_dqm:   assert (oe || dqm == 2'b00);
        i_due:   assert (dut__controller__interval__count_q == phase_q);
        i_phase: assert (phase_q <= (begun_q ? INTERVAL - 13'd1 : POWER_UP));
        i_power: assert (begun_q || phase_q < 13'd2500 ? power_q == 12'd2500
                         : power_q == POWER_UP - phase_q);
        i_owed:  assert (owed == dut__controller__refresh_q);
        i_steps: assert (dut__controller__step_q <= 4'd10 && closed_once == closed_first
                         && (mode_q || mode) == set_up);
        i_closed: assert (set_up || dut__controller__open_q == 4'd0);
        i_refreshes: assert (dut__controller__step_q < 4'd4 || refreshes == 2'd3);
        i_begins: assert (begun_q || (!owed && !closed_first));
        i_init:  assert (!begun_q || set_up || (owed && late_q
                         <= {3'd0, dut__controller__step_q, 1'b0} + 8'd1));
        i_late:  assert (!owed_q || {5'd0, late_q} == INTERVAL - 13'd1 - phase_q);
    end
endmodule

`default_nettype wire
