// i2c_writer_formal.v - START and STOP only where I2C allows them, its times, and the word as sent.
//
// By 3-step induction, with quarters of four clocks; at 63 they are the 100 kHz standard's times.
// The slave's effect on SDA and the times of the requests are unconstrained.

`default_nettype none

module i2c_writer_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        start_i,
    input wire [6:0]  slave_i,
    input wire [15:0] word_i,
    input wire        slave_low_i
);
    localparam [3:0] QUARTER = 4'd4, HALF = 4'd8;

    wire busy, done, nack, scl, oe;
    wire line = !(oe || slave_low_i);

    i2c_writer #(.QUARTER_CYCLES(4)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .start_i(start_i), .slave_i(slave_i), .word_i(word_i),
        .busy_o(busy), .done_o(done), .nack_o(nack), .sclk_o(scl), .sdat_oe_o(oe), .sdat_i(line)
    );

    // ---- The reference: an observer of the two wires --------------------------
    reg         live = 1'b0, ran_q = 1'b0;
    reg         scl_q, oe_q;                 // one clock ago
    reg  [3:0]  scl_age_q, sda_age_q;        // clocks since the last change, up to HALF
    reg         open_q;                      // between START and STOP
    reg  [4:0]  rises_q;                     // of SCL since START
    reg  [26:0] sent_q;                      // SDA as driven at each of them
    reg  [22:0] word_q;                      // the slave's address, and the word
    reg         line1_q, line2_q;
    reg         nack_q;                      // an acknowledge bit was read high

    wire        rise  = ran_q && scl && !scl_q;
    wire        fall  = ran_q && !scl && scl_q;
    wire        moved = ran_q && oe != oe_q;
    wire        start = moved && scl && scl_q && oe;
    wire        stop  = moved && scl && scl_q && !oe;
    wire [3:0]  scl_age = rise || fall ? 4'd0 : scl_age_q;
    wire [3:0]  sda_age = moved ? 4'd0 : sda_age_q;
    wire        open  = start || (open_q && !stop);
    wire [4:0]  rises = start ? 5'd0 : rises_q + {4'd0, rise};
    wire [26:0] sent  = start ? 27'd0 : rise ? {sent_q[25:0], !oe} : sent_q;
    wire        acknowledge = rises == 5'd9 || rises == 5'd18 || rises == 5'd27;
    wire        read  = open && acknowledge && scl && scl_age == QUARTER - 4'd1;
    wire        nacked = !start && nack_q;

    always @(posedge clk_i) begin
        live      <= 1'b1;
        ran_q     <= !rst_i;
        scl_q     <= scl;
        oe_q      <= oe;
        scl_age_q <= scl_age >= HALF ? HALF : scl_age + 4'd1;
        sda_age_q <= sda_age >= HALF ? HALF : sda_age + 4'd1;
        open_q    <= open;
        rises_q   <= rises;
        sent_q    <= sent;
        line1_q   <= line;
        line2_q   <= line1_q;
        nack_q    <= nacked || (read && line2_q);
        if (start_i && !busy) word_q <= {slave_i, word_i};
        if (rst_i) begin
            open_q    <= 1'b0;
            scl_age_q <= HALF;
            sda_age_q <= HALF;
        end
    end
    always @(*) if (!live) assume (rst_i);

    // ---- What must hold ---------------------------------------------------------
    wire [26:0] frame = {word_q[22:16], 1'b0, 1'b1, word_q[15:8], 1'b1, word_q[7:0], 1'b1};
    wire [26:0] gone = frame >> (5'd28 - rises);
    wire [26:0] ended = {gone[25:0], 1'b0};          // with SDA low for STOP
    wire        before_stop = rises == 5'd10 || rises == 5'd19 || rises == 5'd28;

    always @(*) if (live) begin
        a_idle_is_free: assert (busy || (scl && !oe && !open));
        a_start: assert (!start || (!open_q && sda_age_q >= HALF && scl_age_q >= HALF));
        a_stop:  assert (!stop || (open_q && scl_age_q >= HALF
                                   && before_stop));
        a_low_time:  assert (!rise || scl_age_q >= HALF);
        a_high_time: assert (!fall || scl_age_q >= HALF);
        a_hold:      assert (!(moved && !scl) || scl_age >= QUARTER);
        a_setup:     assert (!rise || sda_age >= QUARTER);
        a_start_hold: assert (!(fall && rises == 5'd0) || sda_age_q >= HALF);
        a_slave_may_acknowledge: assert (!(open && acknowledge && scl) || !oe);
        a_bits: assert (!open || sent == frame >> (5'd27 - rises)
                        || (before_stop && sent == ended));
        a_word: assert (!(done && !nack) || (rises == 5'd28 && sent == {frame[25:0], 1'b0}));
        a_nack: assert (!done || nack == nack_q);
    end

    // ---- Invariants: the wires in each quarter of each cell -----------------------
    wire [1:0]  dut__clock_q, dut__quarter_q;
    wire [4:0]  dut__cell_q;
    wire [26:0] dut__bits_q;
    wire        dut__sdat;
    reg  [1:0]  age_q = 2'd0;
    always @(posedge clk_i) if (age_q != 2'd3) age_q <= age_q + 2'd1;

    wire        ack_cell = dut__cell_q == 5'd9 || dut__cell_q == 5'd18 || dut__cell_q == 5'd27;
    wire        second = dut__quarter_q[1];              // half of the cell
    wire [3:0]  in_half = {1'b0, dut__quarter_q[0], dut__clock_q};
    wire [4:0]  shifts = dut__cell_q - 5'd1;
    wire [26:0] rest = ~(~frame << shifts);
    wire        stopping = dut__cell_q == 5'd28;

    always @(*) if (live) begin
        i_age:  assert (age_q != 2'd0);
        if (age_q == 2'd3) i_sdat: assert (dut__sdat == line2_q);
        i_idle: assert (busy || (scl_age == HALF));
        i_open: assert (!open || nack == nacked);
        i_nack: assert (!(busy && nack) || stopping || (ack_cell && dut__quarter_q == 2'd3));
        i_cell: assert (dut__cell_q <= 5'd28 || !busy);
        i_done: assert (!done || (stop && !busy));
        if (busy && dut__cell_q == 5'd0) begin
            i_start_bits: assert (dut__bits_q == frame && !nack);
            i_start_wires: assert (scl && scl_age == HALF && oe == second && open == second);
            i_start_rises: assert (!open || rises == 5'd0);
            i_start_time: assert (second ? sda_age == in_half : sda_age >= in_half);
        end
        if (busy && dut__cell_q != 5'd0) begin
            i_wires: assert (open && scl == second && scl_age == in_half);
            i_sda:   assert (dut__quarter_q == 2'd0 || oe == (stopping || !dut__bits_q[26]));
            i_setup: assert (second ? sda_age >= QUARTER : dut__quarter_q == 2'd0
                             || sda_age >= {2'd0, dut__clock_q});
        end
        if (busy && dut__cell_q != 5'd0 && !stopping) begin
            i_bits:  assert (dut__bits_q == rest);
            i_rises: assert (rises == shifts + {4'd0, second});
            i_sent:  assert (sent == frame >> (5'd27 - rises));
        end
        if (busy && stopping) begin
            i_stop_rises: assert (second ? before_stop : acknowledge);
            i_stop_whole: assert (nack || rises == 5'd27 + {4'd0, second});
            i_stop_sent:  assert (second ? sent == ended
                                  : sent == frame >> (5'd27 - rises));
        end
    end
endmodule

`default_nettype wire
